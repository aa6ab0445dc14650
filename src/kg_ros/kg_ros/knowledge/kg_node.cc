#include "kg_ros/knowledge/kg_node.h"

#include <algorithm>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_compiler/explain/fact_warnings.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/validator.h"
#include "kg_ros/base/names.h"
#include "kg_ros/conversion/agent_conversion.h"
#include "kg_ros/conversion/fact_conversion.h"
#include "kg_ros/conversion/plan_conversion.h"
#include "kg_ros/conversion/world_conversion.h"
#include "ros/callback_queue.h"
#include "ros/console.h"

namespace kg_ros {
namespace {

using kg_engine::Decision;
using kg_engine::Expired;
using kg_engine::MissionFolders;
using kg_engine::SparqlHttpOptions;
using kg_msgs::UpdateReport;
using kg_msgs::World;

constexpr unsigned kBurst = 10000;  // Queue length of fact updates.
constexpr unsigned kManyGraphs = 1000;
constexpr double kWatchPeriod_s = 0.5;
constexpr double kIdle_s = 0.02;
constexpr int kMovesPerRepaint = 4;       // Markers are large: every 2 s.
constexpr double kPosePatience_s = 0.5;   // Wait for all poses at a new window.
constexpr double kHttpPatience_s = 30.0;  // Wait for an HTTP update to begin.

double Now_s() { return ros::WallTime::now().toSec(); }

kg_msgs::StageTime Stage(const std::string& name, double seconds,
                         std::size_t count) {
  return ToMessage(kg_selector::StageTime{name, seconds, count});
}

}  // namespace

KgNode::KgNode(const MissionFolders& folders, const SparqlHttpOptions& http,
               const ros::NodeHandle& node, const ros::NodeHandle& own)
    : node_(node),
      own_(own),
      opening_s_(Now_s()),
      server_(folders),
      artifacts_(node_),
      rviz_(node_),
      queries_(node_, &server_),
      what_ifs_(node_, &server_),
      checks_(node_, &server_),
      watches_(node_, &server_),
      why_(node_, &server_),
      main_thread_(ros::getGlobalCallbackQueue()) {
  updates_ = node_.advertise<UpdateReport>(kUpdatesTopic, 100, kLatched);
  world_ = node_.advertise<World>(kWorldTopic, 1, kLatched);
  Subscribe();
  diagnostics_.setHardwareID("none");
  diagnostics_.add("mission", this, &KgNode::Diagnose);
  diagnostics_.add("data", this, &KgNode::DiagnoseData);
  watch_ =
      node_.createWallTimer(ros::WallDuration(kWatchPeriod_s),
                            [this](const ros::WallTimerEvent&) { Watch(); });
  ROS_INFO(
      "[facts] %zu agents, %zu windows, %zu constraints, %zu events; "
      "world version %lu%s",
      server_.mission().agents.size(), server_.mission().windows.size(),
      server_.mission().constraints.size(), server_.mission().events.size(),
      server_.world_version(),
      server_.was_restored() ? ", resumed from the store" : "");
  for (const std::string& line : server_.violations_at_start()) {
    ROS_WARN_STREAM("[facts] the store violates its shapes: " << line);
  }
  ExpectFirstPlan();
  ExpireFacts();
  PublishWorld();
  if (http.port != 0) StartHttpServer(http);
}

KgNode::~KgNode() { main_thread_.Close(); }

void KgNode::StartHttpServer(const SparqlHttpOptions& options) {
  kg_engine::EndpointStore store;
  store.read = [this] { return server_.Read(); };
  store.dataset = kg_engine::CurrentDataset;
  store.update = [this](const kg_core::FactUpdate& update) {
    return DecideForHttp(update);
  };
  http_.emplace(options, std::move(store));
  ROS_INFO("[http] http://127.0.0.1:%d/sparql, %s, %s", http_->port(),
           options.writable ? "writable" : "read-only",
           options.token_file.empty() ? "no token" : "with a token");
}

// The first cycle is reported like one of an update.
void KgNode::ExpectFirstPlan() {
  UpdateReport report;
  report.header.stamp = ros::Time::now();
  report.id = "bringup";
  report.author = "kg";
  report.accepted = true;
  report.world_version = server_.world_version();
  report.stages = {Stage("facts", Now_s() - opening_s_, 1)};
  TellGaps(&report);
  pending_.Add(report);
}

void KgNode::Subscribe() {
  subscribers_ = {
      node_.subscribe(kFactsTopic, kBurst, &KgNode::HandleFacts, this),
      node_.subscribe(kAgentStatesTopic, kBurst, &KgNode::HandleAgentState,
                      this),
      node_.subscribe(kNavGraphsTopic, kManyGraphs, &KgNode::HandleNavGraph,
                      this),
      node_.subscribe(kCandidatesTopic, kManyGraphs, &KgNode::HandleCandidates,
                      this),
      node_.subscribe(kRoundRequestsTopic, 100, &KgNode::HandleRoundRequest,
                      this),
      node_.subscribe(kRejectionsTopic, 100, &KgNode::HandleRejections, this),
      node_.subscribe(kAssignmentsTopic, 10, &KgNode::HandleAssignments, this)};
  services_ = {
      node_.advertiseService(kUpdateService, &KgNode::HandleUpdate, this),
      node_.advertiseService(kValidateService, &KgNode::HandleValidate, this)};
}

void KgNode::Spin() {
  ros::CallbackQueue* queue = ros::getGlobalCallbackQueue();
  while (ros::ok()) {
    queue->callAvailable(ros::WallDuration(kIdle_s));
    if (cycle_is_due_ && FleetIsReady()) {
      StartCycle();
    } else if (plan_status_.is_ok() && queue->isEmpty()) {
      RecordNextGraph();
    }
  }
  server_.Save();
}

void KgNode::RecordNextGraph() {
  const kg_engine::AgentGraph* graph = progress_.NextUnrecorded();
  if (graph == nullptr) return;
  server_.RecordGraph(*graph, progress_.HashBefore(*graph));
}

// Facts ---------------------------------------------------------------------

void KgNode::HandleFacts(const kg_msgs::FactUpdate& message) {
  Decide(FromMessage(message));
}

bool KgNode::HandleUpdate(kg_msgs::UpdateFacts::Request& request,
                          kg_msgs::UpdateFacts::Response& response) {
  response.report = Decide(FromMessage(request.update));
  return true;
}

kg_engine::UpdateVerdict KgNode::DecideForHttp(
    const kg_core::FactUpdate& update) {
  using Outcome = kg_engine::UpdateVerdict::Outcome;
  kg_engine::UpdateVerdict verdict;
  main_thread_.Do(
      [&] {
        const UpdateReport report = Decide(update);
        verdict.outcome =
            report.accepted ? Outcome::kAccepted : Outcome::kRefused;
        verdict.reasons = report.reasons;
        verdict.world_version = report.world_version;
      },
      kHttpPatience_s);
  return verdict;
}

UpdateReport KgNode::Decide(const kg_core::FactUpdate& update) {
  const std::uint64_t before = server_.world_version();
  return Report(update, server_.Apply(update), before);
}

UpdateReport KgNode::Report(const kg_core::FactUpdate& update,
                            const Decision& decision,
                            const std::uint64_t before) {
  UpdateReport report;
  report.header.stamp = ros::Time::now();
  report.id = update.id;
  report.author = update.author;
  report.accepted = decision.accepted;
  report.reasons = decision.reasons;
  report.world_version = decision.world_version;
  report.stages = {Stage("facts", decision.facts_s, 1),
                   Stage("ingest", decision.ingest_s, 0)};
  report.plan_status = UpdateReport::PLAN_PENDING;
  for (const std::string& reason : decision.reasons) {
    ROS_WARN_STREAM("[facts] refused from " << update.author << ": " << reason);
  }
  if (decision.world_version != before) {
    cycle_is_due_ = true;
    plan_status_.Expire();
    TellGaps(&report);
    pending_.Add(report);
    PublishWorld();
  } else if (decision.accepted) {
    report.warnings.push_back("no change: all facts were already present");
    report.plan_status = plan_status_.is_ok() ? UpdateReport::PLAN_OK
                                              : UpdateReport::PLAN_PENDING;
  }
  updates_.publish(report);
  return report;
}

void KgNode::ExpireFacts() {
  if (!server_.ExpiryIsDue()) return;
  const std::uint64_t before = server_.world_version();
  const Expired expired = server_.Expire();
  for (const std::string& line : expired.kept) {
    ROS_WARN_STREAM("[facts] expired, but " << line);
  }
  for (const kg_core::Fact& fact : expired.update.remove) {
    ROS_INFO_STREAM("[facts] expired: " << fact.subject);
  }
  if (expired.update.remove.empty()) return;
  Report(expired.update, expired.decision, before);
}

void KgNode::TellGaps(UpdateReport* report) {
  std::vector<std::string> gaps = kg_mission::WindowGaps(server_.mission());
  if (gaps == gaps_) return;
  gaps_ = std::move(gaps);
  for (const std::string& gap : gaps_) {
    ROS_WARN_STREAM("[facts] " << gap);
    report->warnings.push_back(gap);
  }
}

void KgNode::TellWarnings() {
  const std::vector<kg_compiler::FactWarning> of_facts =
      kg_compiler::FindWarnings(*compilation_);
  rviz_.Keep(of_facts);
  std::vector<std::string> warnings = kg_compiler::Lines(of_facts);
  const auto view = server_.Read();
  data_ = kg_mission::SummarizeData(*view);
  const std::vector<std::string> of_data = kg_mission::DataWarnings(*view);
  warnings.insert(warnings.end(), of_data.begin(), of_data.end());
  if (warnings == warnings_) return;
  warnings_ = std::move(warnings);
  for (const std::string& line : warnings_) {
    ROS_WARN_STREAM("[facts] " << line);
  }
  pending_.Warn(warnings_);
}

bool KgNode::HandleValidate(kg_msgs::Validate::Request& request,
                            kg_msgs::Validate::Response& response) {
  response.world_version = server_.world_version();
  const kg_core::FactUpdate update = FromMessage(request.update);
  const bool nothing = update.set.empty() && update.add.empty() &&
                       update.remove.empty() && update.turtle.empty() &&
                       update.sparql.empty();
  if (nothing) {
    const std::vector<kg_core::Violation> violations =
        kg_mission::Validate(*server_.Read());
    response.violations = kg_core::Lines(violations);
    response.report = kg_core::ReportTurtle(violations);
  } else {
    const kg_mission::UpdateJudgement judgement = server_.Check(update);
    response.violations = judgement.reasons;
    if (judgement.violations) {
      response.report = kg_core::ReportTurtle(*judgement.violations);
    }
  }
  response.conforms = response.violations.empty();
  return true;
}

// Cycles ---------------------------------------------------------------------

void KgNode::StartCycle() {
  cycle_is_due_ = false;
  if (server_.ended()) return;
  cycle_began_s_ = Now_s();
  try {
    compilation_ = server_.BeginCycle();
  } catch (const std::runtime_error& error) {  // Bad input, or no disk space.
    FailCycle(error.what());
    return;
  }
  const double compiled_s = Now_s();
  progress_.Begin(server_.cycle());
  why_.archive().Begin(server_.cycle(), compilation_, server_.Read());
  artifacts_.Publish(*compilation_, server_.cycle());
  TellWarnings();  // While the planners work.
  if (!plan_status_.is_ok()) plan_status_.Expire();
  rviz_.Show(compilation_, ViewWindow());
  const double published_s = Now_s();
  pending_.Compiled(*compilation_, compiled_s - cycle_began_s_,
                    published_s - compiled_s);
  ROS_INFO(
      "[compile] cycle %lu, world version %lu: recompiled %zu artifacts (%zu "
      "tensors, %zu work fields) in %.3f s, published in %.3f s",
      server_.cycle(), compilation_->world_version, compilation_->dirty.size(),
      compilation_->tensors.size(), compilation_->fields.size(),
      compiled_s - cycle_began_s_, published_s - compiled_s);
  PublishWorld();
}

// At a new window: whether all agents have reported from its begin, or the wait
// has timed out.
bool KgNode::FleetIsReady() const {
  return server_.fleet().IsComplete() || Now_s() >= patience_ends_s_;
}

void KgNode::FailCycle(const std::string& why) {
  ROS_ERROR_STREAM("[compile] " << why << "; the last plan remains in force");
  plan_status_.Fail(why);
  for (const UpdateReport& report : pending_.Fail(why)) {
    updates_.publish(report);
  }
  PublishWorld();
}

void KgNode::Guarded(const std::function<void()>& work) {
  try {
    work();
  } catch (const kg_base::InputError& error) {
    ROS_ERROR_STREAM("[plan] answer ignored: " << error.what());
  }
}

void KgNode::HandleNavGraph(const kg_msgs::NavGraph& message) {
  Guarded([&] {
    const kg_engine::AgentGraph graph = FromMessage(message);
    if (!progress_.Take(graph)) return;
    why_.archive().Take(graph);
    rviz_.Keep(graph);
    graphs_are_new_ = true;
  });
}

void KgNode::HandleCandidates(const kg_msgs::Candidates& message) {
  if (message.cycle != server_.cycle()) return;
  Guarded([&] {
    rviz_.Keep(FromMessage(message));
    graphs_are_new_ = true;
  });
}

// Requests, rejections and assignments come on three topics: whichever is the
// last of a run completes its plan.
void KgNode::HandleRoundRequest(const kg_msgs::RoundRequest& message) {
  Guarded([&] {
    if (progress_.Take(FromMessage(message))) CommitFinishedPlan();
  });
}

void KgNode::HandleRejections(const kg_msgs::Rejections& message) {
  Guarded([&] {
    if (progress_.Take(FromMessage(message))) CommitFinishedPlan();
  });
}

void KgNode::HandleAssignments(const kg_msgs::Assignments& message) {
  Guarded([&] {
    if (progress_.Take(FromMessage(message))) CommitFinishedPlan();
  });
}

void KgNode::CommitFinishedPlan() {
  const std::optional<kg_selector::CommittedPlan> plan =
      progress_.TakeFinishedPlan();
  if (!plan || cycle_is_due_) return;
  // Run numbers ascend; an older run may come from a replaced selector.
  if (plan->run <= server_.plan_run()) {
    ROS_WARN("[commit] run %lu is not newer than run %lu: dropped", plan->run,
             server_.plan_run());
    return;
  }
  const double begin_s = Now_s();
  kg_engine::PlanRecord record = progress_.MakeRecord(*plan);
  record.started_s = cycle_began_s_;
  record.ended_s = begin_s;
  try {
    record.executed = server_.executed();
    server_.RecordPlan(record);
    why_.archive().Commit(record, server_.Read());
  } catch (const std::runtime_error& error) {
    FailCycle(error.what());
    return;
  }
  plan_ = *plan;
  plan_status_.Commit(plan->unassigned.empty()
                          ? ""
                          : kg_selector::UnassignedLines(*plan).front());
  rviz_.ShowPlan(*plan);
  graphs_are_new_ = true;
  ReportPlan(*plan, Now_s() - begin_s);
  PublishWorld();
}

void KgNode::ReportPlan(const kg_selector::CommittedPlan& plan,
                        const double commit_s) {
  for (const UpdateReport& report : pending_.Answer(plan, commit_s)) {
    updates_.publish(report);
  }
  for (const kg_selector::StageTime& stage : plan.stages) {
    ROS_INFO("[%s] %zu in %.3f s", stage.stage.c_str(), stage.count,
             stage.seconds);
  }
  ROS_INFO(
      "[commit] plan %lu for world version %lu: %zu agents, reward %.2f, "
      "seam cost %.2f; %.3f s after the cycle began",
      plan.run, plan.world_version, plan.assignments.size(), plan.reward,
      plan.seam_cost, Now_s() - cycle_began_s_);
}

// Agents and time -------------------------------------------------------------

void KgNode::HandleAgentState(const kg_msgs::AgentState& message) {
  const int before = server_.current_window();
  if (!server_.Observe(message.agent, FromMessage(message))) {
    ROS_WARN_STREAM_THROTTLE(10, "[agents] state of '"
                                     << message.agent
                                     << "' refused: unknown agent or numbers "
                                        "that are not finite");
    return;
  }
  fleet_has_moved_ = true;
  const int after = server_.current_window();
  if (after > before) PassWindows(before, after);
  ExpireFacts();
}

// Marks the planned stops of past windows as executed, then starts a new cycle
// or ends the mission.
void KgNode::PassWindows(const int from, const int to) {
  if (plan_) {
    for (const kg_selector::PathAssignment& assignment : plan_->assignments) {
      for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
        if (visit.window < from || visit.window >= to) continue;
        server_.AddExecuted(
            {assignment.pathlet.agent, assignment.agent_iri, visit});
      }
    }
  }
  if (server_.ended()) {
    ROS_INFO("[mission] all %zu windows are flown",
             server_.mission().windows.size());
    server_.RecordEnd();
  } else {
    ROS_INFO("[mission] window %d begins", to);
    plan_status_.Expire();
    cycle_is_due_ = true;
    patience_ends_s_ = Now_s() + kPosePatience_s;
  }
  PublishWorld();
}

void KgNode::Watch() {
  diagnostics_.update();  // Publishes once a second at most.
  if (fleet_has_moved_) {
    PublishWorld();
    fleet_has_moved_ = false;
    if (++moves_ % kMovesPerRepaint == 0) graphs_are_new_ = true;
  }
  if (compilation_ == nullptr) return;
  rviz_.ShowFleet(server_.fleet());  // Also without motion: transforms age.
  if (shown_window_ != ViewWindow()) {
    shown_window_ = ViewWindow();
    rviz_.Show(compilation_, shown_window_);
  } else if (graphs_are_new_) {
    rviz_.Refresh();
  }
  graphs_are_new_ = false;
  if (plan_status_.SetMissing(MissingNodes())) PublishWorld();
}

std::string KgNode::MissingNodes() const {
  for (const kg_mission::Agent& agent : server_.mission().agents) {
    if (!artifacts_.HasPlanner(agent.id)) {
      return "planner for " + agent.id + " not connected";
    }
  }
  return artifacts_.HasSelector() ? "" : "selector not connected";
}

int KgNode::ViewWindow() const {
  int window = -1;
  own_.getParamCached("view_window", window);
  return window >= 0 ? window : server_.current_window();
}

// Publishing ------------------------------------------------------------------

void KgNode::PublishWorld() {
  World world = DescribeWorld(server_, compilation_.get());
  world.header.stamp = ros::Time::now();
  world.plan_version = plan_ ? plan_->world_version : 0;
  world.plan_status = plan_status_.status();
  world.plan_note = plan_status_.note();
  world_.publish(world);
}

void KgNode::Diagnose(diagnostic_updater::DiagnosticStatusWrapper& status) {
  const bool ok = plan_status_.is_ok();
  status.summary(ok ? diagnostic_msgs::DiagnosticStatus::OK
                    : diagnostic_msgs::DiagnosticStatus::WARN,
                 ok ? "the plan is up to date" : "the plan is not up to date");
  status.add("world_version", server_.world_version());
  status.add("cycle", server_.cycle());
  status.add("plan_run", server_.plan_run());
  status.add("plan_note", plan_status_.note());
  status.add("warnings", kg_base::JoinStrings(warnings_, "; "));
  status.add("missing", MissingNodes());
  status.add("answers_dropped", progress_.dropped());
}

void KgNode::DiagnoseData(diagnostic_updater::DiagnosticStatusWrapper& status) {
  status.summary(diagnostic_msgs::DiagnosticStatus::OK,
                 std::to_string(data_.size()) + " variables read");
  for (const kg_mission::DataSummary& data : data_) {
    status.add(data.what, data.text);
  }
}

}  // namespace kg_ros
