// Arbitrary WKT: rejected with one line, or a geometry that survives a round
// trip and contains its own vertices.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/geo/wkt.h"

namespace kg_base {
namespace {

void ReadWriteRead(const std::string& text) {
  const Geometry geometry = Geometry::FromWkt(text);
  const Geometry again = Geometry::FromWkt(geometry.Wkt());
  const bool same_box = again.west_deg() == geometry.west_deg() &&
                        again.east_deg() == geometry.east_deg() &&
                        again.south_deg() == geometry.south_deg() &&
                        again.north_deg() == geometry.north_deg();
  if (!same_box || again.repaired()) std::abort();
  if (!geometry.Intersects(again)) std::abort();
  geometry.Rings();
  geometry.Parts();
}

}  // namespace
}  // namespace kg_base

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  try {
    kg_base::ReadWriteRead(text);
  } catch (const kg_base::InputError& error) {
    if (std::string(error.what()).find('\n') != std::string::npos) std::abort();
  }
  return 0;
}
