#include "kg_compiler/traversal/slower_reaches.h"

#include "kg_compiler/traversal/fan.h"

namespace kg_compiler {

const ReachMap* SlowerReaches::At(int k, const VoyageRequest& voyage,
                                  const CellBox& read) {
  const auto i = static_cast<std::size_t>(k);
  std::call_once(made_[i], [&] {
    VoyageRequest slower = voyage;
    slower.motion.cruise_mps *= kShares[i];
    reaches_[i] = ExtremalFan(slower).Run();
    stays_within_[i] = IsWithin(reaches_[i].read, read);
  });
  return stays_within_[i] ? &reaches_[i] : nullptr;
}

}  // namespace kg_compiler
