#include "kg_compiler/control_plane/movement_mode.h"

#include <stdexcept>

#include "kg_base/common/input_error.h"
#include "kg_mission/mission/option_names.h"

namespace kg_compiler {

const char* Name(MovementMode mode) {
  switch (mode) {
    case MovementMode::kHops:
      return kg_mission::kHopsMovement;
    case MovementMode::kEdges:
      return kg_mission::kEdgesMovement;
  }
  throw std::logic_error("a movement mode without a name");
}

MovementMode MovementModeOf(const std::string& name) {
  for (const MovementMode mode : {MovementMode::kHops, MovementMode::kEdges}) {
    if (name == Name(mode)) return mode;
  }
  throw kg_base::InputError("movement mode '" + name + "': expected '" +
                            Name(MovementMode::kHops) + "' or '" +
                            Name(MovementMode::kEdges) + "'");
}

}  // namespace kg_compiler
