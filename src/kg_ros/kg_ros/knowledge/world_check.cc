#include "kg_ros/knowledge/world_check.h"

#include <stdexcept>
#include <string>

#include "kg_compiler/compile/same_compilation.h"
#include "kg_core/base/input_error.h"
#include "kg_core/base/stopwatch.h"
#include "kg_core/mission/mission_reader.h"
#include "kg_ros/knowledge/artifact_facts.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;
using kg_compiler::Difference;
using kg_compiler::MissionCompiler;
using CompilationPtr = std::shared_ptr<const Compilation>;

std::string Text(const kg_msgs::CheckResponse& answer) {
  if (!answer.errors.empty()) return "not checked: " + answer.errors.front();
  std::string text = std::to_string(answer.compared) + " artifacts compared, " +
                     std::to_string(answer.differs.size()) + " differ, " +
                     std::to_string(answer.total_s) + " s";
  for (const std::string& name : answer.differs) text += "\ndiffers: " + name;
  return text;
}

// What is to be compiled of a world.
struct Task {
  kg_core::Mission mission;
  std::uint64_t world_version = 0;
  int first_window = 0;

  CompilationPtr By(MissionCompiler* compiler) const {
    return compiler->Compile(mission, world_version, first_window);
  }
};

Task TaskOf(const kg_core::GraphView& view, StartState start) {
  Task task;
  task.mission = kg_core::ReadMission(view);
  task.world_version = view.world_version();
  start.fleet.Follow(task.mission);
  task.first_window = FirstWindowToPlan(start, task.mission);
  if (task.first_window >= static_cast<int>(task.mission.windows.size())) {
    throw kg_core::InputError("the mission has ended: nothing is compiled");
  }
  return task;
}

// `compare` is given the task and the compilation made anew.
template <typename Compare>
kg_msgs::CheckResponse Check(const kg_core::GraphView& view,
                             const StartState& start, kg_core::FileCache* files,
                             const Compare& compare) {
  const kg_core::Stopwatch watch;
  kg_msgs::CheckResponse answer;
  answer.world_version = view.world_version();
  try {
    const Task task = TaskOf(view, start);
    const kg_core::Stopwatch compiling;
    MissionCompiler fresh(files);
    const CompilationPtr anew = task.By(&fresh);
    answer.compile_s = compiling.Elapsed_s();
    const Difference found = compare(task, *anew);
    answer.compared = static_cast<unsigned>(found.compared);
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

kg_msgs::CheckResponse CheckWorld(const Present& present,
                                  kg_core::FileCache* files) {
  return Check(*present.facts, present.start, files,
               [&](const Task& task, const Compilation& anew) {
                 MissionCompiler held = present.compiler;
                 return kg_compiler::Compare(*task.By(&held), anew);
               });
}

kg_msgs::CheckResponse CheckStore(const kg_core::GraphView& view,
                                  kg_core::FileCache* files) {
  StartState start;
  try {
    start = StartOf(view, kg_core::ReadMission(view));
  } catch (const kg_core::InputError& error) {
    kg_msgs::CheckResponse answer;
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

}  // namespace kg_ros
