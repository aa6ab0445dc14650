#include "kg_engine/server/world_check.h"

#include <stdexcept>
#include <string>

#include "kg_base/common/input_error.h"
#include "kg_base/common/stopwatch.h"
#include "kg_compiler/compile/same_compilation.h"
#include "kg_engine/facts/artifact_facts.h"
#include "kg_engine/terms/artifact_names.h"
#include "kg_mission/mission/mission_reader.h"

namespace kg_engine {
namespace {

using kg_compiler::Compilation;
using kg_compiler::Difference;
using kg_compiler::MissionCompiler;
using CompilationPtr = std::shared_ptr<const Compilation>;

std::string Text(const CheckAnswer& answer) {
  if (!answer.errors.empty()) return "not checked: " + answer.errors.front();
  std::string text = std::to_string(answer.compared) + " artifacts compared, " +
                     std::to_string(answer.differs.size()) + " differ, " +
                     std::to_string(answer.total_s) + " s";
  for (const std::string& name : answer.differs) text += "\ndiffers: " + name;
  return text;
}

// Compilation task for a world.
struct Task {
  kg_mission::Mission mission;
  std::uint64_t world_version = 0;
  int first_window = 0;

  CompilationPtr By(MissionCompiler* compiler) const {
    return compiler->Compile(mission, world_version, first_window);
  }
};

Task TaskOf(const kg_core::GraphView& view, StartState start) {
  Task task;
  task.mission = kg_mission::ReadMission(view);
  task.world_version = view.world_version();
  start.fleet.Follow(task.mission);
  task.first_window = FirstWindowToPlan(start, task.mission);
  if (task.first_window >= static_cast<int>(task.mission.windows.size())) {
    throw kg_base::InputError("the mission has ended: nothing is compiled");
  }
  return task;
}

// `compare` receives the task and the fresh compilation.
template <typename Compare>
CheckAnswer Check(const kg_core::GraphView& view, const StartState& start,
                  kg_mission::FileCache* files, const Compare& compare) {
  const kg_base::Stopwatch watch;
  CheckAnswer answer;
  answer.world_version = view.world_version();
  try {
    const Task task = TaskOf(view, start);
    const kg_base::Stopwatch compiling;
    MissionCompiler fresh(files);
    const CompilationPtr anew = task.By(&fresh);
    answer.compile_s = compiling.Elapsed_s();
    const Difference found = compare(task, *anew);
    answer.compared = found.compared;
    answer.differs = found.differs;
  } catch (const std::runtime_error& error) {  // Bad input, or no threads.
    answer.errors.push_back(error.what());
  }
  answer.ok = answer.errors.empty() && answer.differs.empty();
  answer.total_s = watch.Elapsed_s();
  answer.text = Text(answer);
  return answer;
}

}  // namespace

CheckAnswer CheckWorld(const Present& present, kg_mission::FileCache* files) {
  return Check(*present.facts, present.start, files,
               [&](const Task& task, const Compilation& anew) {
                 MissionCompiler held = present.compiler;
                 return kg_compiler::Compare(*task.By(&held), anew);
               });
}

CheckAnswer CheckStore(const kg_core::GraphView& view,
                       kg_mission::FileCache* files) {
  StartState start;
  try {
    start = StartOf(view, kg_mission::ReadMission(view));
  } catch (const kg_base::InputError& error) {
    CheckAnswer answer;
    answer.errors.push_back(error.what());
    answer.text = Text(answer);
    return answer;
  }
  return Check(
      view, start, files, [&](const Task& task, const Compilation& anew) {
        Difference found;
        for (const auto& tensor : anew.tensors) {
          ++found.compared;
          const auto node = TensorNode(*tensor, task.mission);
          if (IsDescribed(view, node)) continue;
          found.differs.push_back("tensor of " + tensor->agent_iri +
                                  ", window " + std::to_string(tensor->window));
        }
        return found;
      });
}

}  // namespace kg_engine
