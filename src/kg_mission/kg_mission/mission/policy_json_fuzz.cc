// Fuzz test: arbitrary input as the JSON in ex:priors and ex:softOverrides of a
// policy is rejected with reasons, or expanded into weights that the mission
// reader accepts.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_update.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

void SetJson(const char* property, const std::string& json) {
  static MissionWorld world;
  kg_core::Transaction change = world.store.Begin();
  kg_core::FactUpdate update;
  update.set = {
      {"ex:fast", property, kg_core::ToTurtle(kg_core::Literal(json))}};
  if (!StageUpdate(update, change).empty()) return;
  ReadMission(change.view());  // A staged update must be readable.
}

}  // namespace
}  // namespace kg_mission

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  kg_mission::SetJson("ex:priors", text);
  kg_mission::SetJson("ex:softOverrides", text);
  return 0;
}
