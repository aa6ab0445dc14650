// Reaches at slower speeds through water, which may be cheaper; computed on
// demand. Thread-safe.

#ifndef KG_COMPILER_TRAVERSAL_SLOWER_REACHES_H_
#define KG_COMPILER_TRAVERSAL_SLOWER_REACHES_H_

#include <array>
#include <mutex>

#include "kg_compiler/traversal/reach.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

class SlowerReaches {
 public:
  static constexpr int kCount = 5;
  // Fractions of the full speed, descending.
  static constexpr std::array<double, kCount> kShares = {0.75, 0.5, 0.3, 0.15,
                                                         0.05};

  // Reach at kShares[k]; null if it reads anything outside `read`. The voyage
  // (at full speed) and `read` must be the same at every call.
  const ReachMap* At(int k, const VoyageRequest& voyage, const CellBox& read);

 private:
  std::array<std::once_flag, kCount> made_;
  std::array<ReachMap, kCount> reaches_;
  std::array<bool, kCount> stays_within_{};
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_SLOWER_REACHES_H_
