#include "kg_compiler/control_plane/movement_mode.h"

#include <stdexcept>

#include "kg_base/common/input_error.h"

namespace kg_compiler {

const char* Name(MovementMode mode) {
  switch (mode) {
    case MovementMode::kHops:
      return "hops";
    case MovementMode::kEdges:
      return "edges";
  }
  throw std::logic_error("a movement mode without a name");
}

MovementMode MovementModeOf(const std::string& name) {
  for (const MovementMode mode : {MovementMode::kHops, MovementMode::kEdges}) {
    if (name == Name(mode)) return mode;
  }
  throw kg_base::InputError("movement mode '" + name +
                            "': expected 'hops' or 'edges'");
}

}  // namespace kg_compiler
