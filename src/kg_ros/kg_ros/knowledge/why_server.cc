#include "kg_ros/knowledge/why_server.h"

#include <exception>
#include <iterator>

#include "kg_core/base/input_error.h"
#include "kg_core/base/units.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/message_units.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/knowledge/mission_server.h"
#include "kg_selector/team/plan_mission.h"

namespace kg_ros {
namespace {

using kg_compiler::Explanation;
using kg_core::InputError;
using kg_selector::ConflictKind;
using kg_selector::PlannedWorld;
using kg_selector::PlanQuestion;
using kg_selector::QuestionKind;
using kg_selector::TeamMember;

// The graphs of one agent, as far as they have come without a gap.
template <typename Graphs>
TeamMember MemberOf(const kg_compiler::SeamRules& rules, const Graphs& graphs) {
  TeamMember member;
  member.rules = rules;
  for (const kg_compiler::WindowRules& window : rules.windows) {
    const auto graph = graphs.find({rules.agent_id, window.window});
    if (graph == graphs.end()) break;
    member.graphs.push_back(FromMessage(*graph->second));
  }
  return member;
}

kg_selector::RejectedPath ToRejection(const kg_msgs::Rejection& message) {
  kg_selector::RejectedPath rejection;
  rejection.pathlet.agent = message.agent_iri;
  rejection.pathlet.rank = static_cast<int>(message.rank);
  rejection.pathlet.reward = message.score;
  rejection.round = static_cast<int>(message.round);
  rejection.reason = message.reason;
  rejection.conflict.kind = kg_selector::ParseConflictKind(message.kind)
                                .value_or(ConflictKind::kMalformed);
  rejection.conflict.with_agent = message.to_agent;
  rejection.conflict.window = message.window;
  rejection.conflict.event = message.event;
  rejection.conflict.margin = message.margin;
  return rejection;
}

void AddPlan(const PlanRecord& record, PlannedWorld* world) {
  const kg_msgs::Assignments& plan = record.assignments;
  world->has_plan = true;
  world->run_iri = PlanRunNode(plan.plan_run).text;
  world->plan_graph = PlanGraph(plan.plan_run).text;
  for (const kg_msgs::Assignment& assignment : plan.assignments) {
    world->plan.committed.push_back(
        kg_ros::FromMessage(assignment.pathlet, assignment.agent_iri));
  }
  for (const kg_msgs::Rejection& rejection : record.rejections) {
    world->plan.rejections.push_back(ToRejection(rejection));
  }
  for (const std::string& line : plan.unassigned) {  // "id: reason"
    const std::size_t colon = line.find(": ");
    if (colon == std::string::npos) continue;
    world->plan.unassigned[line.substr(0, colon)] = line.substr(colon + 2);
  }
  for (const ExecutedVisit& past : record.executed) {
    for (const std::string& event : past.visit.events) {
      world->past_visits[event].push_back(past.agent_iri);
    }
  }
}

void Fill(const Explanation& explanation, kg_msgs::Why::Response* response) {
  response->ok = true;
  response->value = explanation.value;
  response->unit = explanation.unit;
  response->verdict = explanation.verdict;
  for (const kg_compiler::Contribution& part : explanation.parts) {
    response->facts.push_back(kg_compiler::JoinFacts(part.facts));
    response->contributions.push_back(part.value);
  }
  response->text = kg_compiler::ToText(explanation);
  response->json = kg_compiler::ToJson(explanation);
}

}  // namespace

PlanQuestion ToQuestion(const kg_msgs::Why::Request& request) {
  constexpr QuestionKind kKinds[] = {
      QuestionKind::kAssignment, QuestionKind::kTensorCell,
      QuestionKind::kEdge,       QuestionKind::kRejection,
      QuestionKind::kWaypoint,   QuestionKind::kEvent,
      QuestionKind::kPlace};
  if (request.what >= std::size(kKinds)) {
    throw InputError("Why.what: expected 0 to " +
                     std::to_string(std::size(kKinds) - 1) + ", not " +
                     std::to_string(request.what));
  }
  PlanQuestion question;
  question.what = kKinds[request.what];
  question.agent = request.agent;
  question.window = request.window;
  question.from = static_cast<int>(request.from);
  question.to = static_cast<int>(request.to);
  question.via.assign(request.via.begin(), request.via.end());
  question.place = GetPosition(request);
  question.id = request.id;
  return question;
}

// What is known ---------------------------------------------------------------

void PlanArchive::Begin(
    const std::uint64_t cycle,
    std::shared_ptr<const kg_compiler::Compilation> compilation,
    std::shared_ptr<const kg_core::GraphView> view) {
  const std::lock_guard<std::mutex> lock(mutex_);
  newest_ = {cycle, std::move(compilation), std::move(view), {}, nullptr};
}

void PlanArchive::Take(const kg_msgs::NavGraph& graph) {
  auto kept = std::make_shared<const kg_msgs::NavGraph>(graph);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (graph.cycle != newest_.number) return;
  const std::pair<std::string, int> key{graph.agent, graph.window};
  newest_.graphs[key] = kept;
  if (planned_.number != newest_.number) return;
  planned_.graphs[key] = std::move(kept);  // It comes after the plan.
  converted_.reset();
}

void PlanArchive::Commit(const PlanRecord& record,
                         std::shared_ptr<const kg_core::GraphView> view) {
  auto kept = std::make_shared<const PlanRecord>(record);
  const std::lock_guard<std::mutex> lock(mutex_);
  planned_ = newest_;
  planned_.record = std::move(kept);
  planned_.view = std::move(view);
  converted_.reset();
}

PlanArchive::World PlanArchive::Convert(const Cycle& cycle) {
  auto world = std::make_shared<PlannedWorld>();
  world->view = cycle.view;
  world->compilation = cycle.compilation;
  world->rules = kg_selector::ToTeamRules(*cycle.compilation);
  for (const kg_compiler::SeamRules& rules : cycle.compilation->rules) {
    world->members.push_back(MemberOf(rules, cycle.graphs));
  }
  if (cycle.record) AddPlan(*cycle.record, world.get());
  kg_selector::NameAgentsByIri(world.get());
  return world;
}

PlanArchive::World PlanArchive::Newest() const {
  Cycle cycle;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    cycle = newest_;
  }
  cycle.graphs.clear();
  return cycle.compilation ? Convert(cycle) : nullptr;
}

PlanArchive::World PlanArchive::Planned() const {
  Cycle cycle;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (converted_) return converted_;
    cycle = planned_;
  }
  if (!cycle.record) return nullptr;
  World world = Convert(cycle);  // Without the lock: it takes a while.
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool is_still_it = cycle.record == planned_.record &&
                           cycle.graphs.size() == planned_.graphs.size();
  if (is_still_it) converted_ = world;
  return world;
}

// The service -----------------------------------------------------------------

WhyServer::WhyServer(const ros::NodeHandle& node, const MissionServer* server)
    : node_(node), server_(server), spinner_(1, &queue_) {
  node_.setCallbackQueue(&queue_);
  service_ = node_.advertiseService(kWhyService, &WhyServer::Handle, this);
  spinner_.start();
}

WhyServer::~WhyServer() { spinner_.stop(); }

bool WhyServer::Handle(kg_msgs::Why::Request& request,
                       kg_msgs::Why::Response& response) {
  try {
    const PlanQuestion question = ToQuestion(request);
    const PlanArchive::World world = question.what == QuestionKind::kTensorCell
                                         ? archive_.Newest()
                                         : archive_.Planned();
    if (!world) throw InputError("there is no plan yet");
    response.world_version = world->compilation->world_version;
    Explanation explanation = kg_selector::Explain(*world, question);
    const std::uint64_t now = server_->Read()->world_version();
    if (now != response.world_version) {
      explanation.text += " The answer is of world version " +
                          std::to_string(response.world_version) +
                          "; the facts are at " + std::to_string(now) +
                          " and the plan is stale.";
    }
    Fill(explanation, &response);
  } catch (const std::exception& error) {  // Also what planners got wrong.
    response.error = error.what();
  }
  return true;
}

}  // namespace kg_ros
