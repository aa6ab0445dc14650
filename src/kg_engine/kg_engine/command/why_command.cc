// kg why TARGET: compiles and plans in process, from the agents' current
// positions, and explains as kg/why does.

#include <cstdlib>
#include <iostream>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/common/units.h"
#include "kg_compiler/explain/fact_warnings.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"
#include "kg_engine/state/start_state.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_selector/explain/explain_plan.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_engine::command {
namespace {

using kg_selector::PlannedWorld;
using kg_selector::PlanQuestion;
using kg_selector::QuestionKind;

double ToNumber(const std::string& text, const std::string& option) {
  char* end = nullptr;
  const double number = std::strtod(text.c_str(), &end);
  if (!text.empty() && *end == '\0') return number;
  throw UsageError(option + ": expected a number, not '" + text + "'");
}

int ToInt(const std::string& text, const std::string& option) {
  const double number = ToNumber(text, option);
  if (number == static_cast<int>(number)) return static_cast<int>(number);
  throw UsageError(option + ": expected a whole number, not '" + text + "'");
}

// Splits "a,b" at the comma.
std::pair<std::string, std::string> Split(const std::string& text,
                                          const std::string& option) {
  const std::size_t comma = text.find(',');
  if (comma == std::string::npos) {
    throw UsageError(option + ": expected two numbers as in 1,2");
  }
  return {text.substr(0, comma), text.substr(comma + 1)};
}

kg_base::LonLat ToPlace(const std::string& text, const std::string& option) {
  const auto [lon, lat] = Split(text, option);
  return {ToNumber(lon, option), ToNumber(lat, option)};
}

// Parses "0,3", or "0,5,3" via 5.
void ReadEdge(const std::string& text, PlanQuestion* question) {
  auto [from, rest] = Split(text, "--edge");
  question->from = ToInt(from, "--edge");
  for (auto comma = rest.find(','); comma != std::string::npos;
       comma = rest.find(',')) {
    question->via.push_back(ToInt(rest.substr(0, comma), "--edge"));
    rest.erase(0, comma + 1);
  }
  question->to = ToInt(rest, "--edge");
}

// Sets the subject of the question from its option.
void ReadSubject(const std::string& option, const std::string& text,
                 PlanQuestion* question) {
  if (option == "--cell" || option == "--place") {
    question->what =
        option == "--cell" ? QuestionKind::kTensorCell : QuestionKind::kPlace;
    question->place = ToPlace(text, option);
  } else if (option == "--edge") {
    question->what = QuestionKind::kEdge;
    ReadEdge(text, question);
  } else if (option == "--waypoint") {
    question->what = QuestionKind::kWaypoint;
    question->to = ToInt(text, option);
  } else {
    question->what =
        option == "--event" ? QuestionKind::kEvent : QuestionKind::kRejection;
    question->id = text;
  }
}

PlanQuestion ReadQuestion(const Arguments& arguments) {
  PlanQuestion question;
  question.agent = arguments.One("--agent").value_or("");
  const auto window = arguments.One("--window");
  if (window) question.window = ToInt(*window, "--window");
  int subjects = 0;
  for (const char* option : {"--cell", "--place", "--edge", "--waypoint",
                             "--event", "--rejection"}) {
    const auto text = arguments.One(option);
    if (!text) continue;
    ReadSubject(option, *text, &question);
    ++subjects;
  }
  if (subjects > 1) throw UsageError("expected one thing to explain");
  return question;
}

PlannedWorld Plan(const Target& target, const std::string& data_folder) {
  PlannedWorld world;
  world.view = target.store->Read();
  const kg_mission::Mission mission = kg_mission::ReadMission(*world.view);
  const StartState start = StartOf(*world.view, mission);
  if (FirstWindowToPlan(start, mission) ==
      static_cast<int>(mission.windows.size())) {
    throw kg_base::InputError("the mission has ended: nothing is planned");
  }
  kg_mission::FileCache files(target.mission_folder, data_folder);
  kg_compiler::MissionCompiler compiler(&files);
  world.compilation =
      StartFrom(start, *compiler.Compile(mission, world.view->world_version(),
                                         FirstWindowToPlan(start, mission)));
  const std::vector<std::string> closed =
      kg_compiler::FindClosedStarts(*world.compilation);
  if (!closed.empty()) {
    throw kg_base::InputError(kg_base::JoinStrings(closed, "; "));
  }
  // Plan from scratch: the command line has no earlier plan to reuse.
  kg_selector::PlannedMission planned =
      kg_selector::PlanMission(*world.compilation, nullptr);
  world.rules = kg_selector::ToTeamRules(*world.compilation);
  world.members = std::move(planned.members);
  world.plan = std::move(planned.plan);
  world.has_plan = true;
  for (const ExecutedVisit& past : start.executed) {
    for (const std::string& event : past.visit.events) {
      world.past_visits[event].push_back(past.agent_iri);
    }
  }
  kg_selector::NameAgentsByIri(&world);
  return world;
}

int RunWhy(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "TARGET");
  const PlanQuestion question = ReadQuestion(arguments);
  const std::string data = arguments.One("--data").value_or("");
  const Target target = OpenTarget(arguments.words[0], data);
  const kg_compiler::Explanation explanation =
      kg_selector::Explain(Plan(target, data), question);
  std::cout << (arguments.Has("--json") ? kg_compiler::ToJson(explanation)
                                        : kg_compiler::ToText(explanation))
            << std::endl;
  return kDone;
}

}  // namespace

const Subcommand kWhy = {
    "why",
    "TARGET [--agent ID] [--window N] [--cell LON,LAT | --edge FROM,TO | ...]",
    "why the plan of these facts is as it is, or not otherwise",
    "Compiles and plans TARGET in process, without nodes, from where its "
    "agents\n"
    "are. Alone: what the agent's step in the window is worth, or its whole\n"
    "path. What each answer is: docs/interface.md, \"Why\".\n\n"
    "  --agent ID        ex:id of the agent\n"
    "  --window N        its index\n"
    "  --cell LON,LAT    a cell of the mission tensor [deg]\n"
    "  --edge FROM,TO    a seam: waypoints of the window before and of this "
    "one;\n"
    "                    a walk with its stops between them: FROM,STOP,TO\n"
    "  --waypoint ID     why not by way of this waypoint\n"
    "  --event IRI       why not this event, e.g. ex:seep\n"
    "  --place LON,LAT   why not this place [deg]\n"
    "  --rejection N     why a candidate path lost\n"
    "  --json            as JSON\n"
    "  --data FOLDER     where the mission's files are looked up first\n",
    {{"--agent", true},
     {"--window", true},
     {"--cell", true},
     {"--edge", true},
     {"--waypoint", true},
     {"--event", true},
     {"--place", true},
     {"--rejection", true},
     {"--json"},
     {"--data", true}},
    RunWhy};

}  // namespace kg_engine::command
