// The knowledge graph's work and one planner's, in one process, without ROS
// topics: updates, cycles, plans as facts, restarts.

#include "kg_ros/knowledge/mission_server.h"

#include "gtest/gtest.h"
#include "kg_core/base/input_error.h"
#include "kg_core/base/temporary_folder.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_ros/conversion/rules_conversion.h"
#include "kg_ros/conversion/tensor_conversion.h"
#include "kg_ros/knowledge/test_mission.h"
#include "kg_ros/planning/planner_server.h"
#include "kg_ros/selection/selector_server.h"

namespace kg_ros {
namespace {

using kg_compiler::Compilation;
using kg_compiler::Layer;
using kg_core::InputError;

class MissionServerTest : public testing::Test {
 protected:
  MissionServerTest() {
    ros::Time::init();
    folders_.mission = folder_ / "mission";
    folders_.state = folder_ / "state";
    folders_.ontology = "../kg_core/ontology";
    WriteTestMission(folders_.mission);
  }

  static kg_core::FactUpdate Set(const std::string& subject,
                                 const std::string& property,
                                 const std::string& value) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.set = {{subject, property, value}};
    return update;
  }

  // What planner and selector answer to a compilation.
  static kg_msgs::Assignments PlanOf(const Compilation& compilation,
                                     const MissionServer& server,
                                     PlannerAnswer* answer) {
    PlannerServer planner;
    for (const auto& field : compilation.fields) {
      planner.Take(ToMessage(*field, compilation.world_version));
    }
    for (const auto& tensor : compilation.tensors) {
      planner.Take(
          ToMessage(*tensor, "alpha", compilation.world_version,
                    {Layer::kFused, Layer::kFeasibility, Layer::kAttenuation}));
    }
    planner.Take(ToMessage(compilation.rules.at(0), server.cycle()));
    EXPECT_TRUE(planner.IsComplete()) << planner.Missing();
    *answer = planner.Plan();
    SelectorServer selector;
    selector.KnowRun(server.plan_run());
    Coordination team;
    team.world_version = compilation.world_version;
    team.cycle = server.cycle();
    team.agents = {"alpha"};
    team.rules = compilation.coordination;
    selector.Take(ToMessage(team));
    const SelectorAnswer plan = selector.Take(answer->candidates);
    EXPECT_TRUE(plan.assignments) << answer->candidates.note;
    return plan.assignments.value_or(kg_msgs::Assignments());
  }

  static void Record(const kg_msgs::Assignments& plan,
                     const PlannerAnswer& answer, MissionServer* server) {
    PlanRecord record;
    record.assignments = plan;
    for (const kg_msgs::NavGraph& graph : answer.nav_graphs) {
      record.nav_graphs[{graph.agent, graph.window}] = StampOf(graph);
    }
    server->RecordPlan(record);
  }

  static std::size_t Count(const MissionServer& server,
                           const std::string& query) {
    return kg_core::RunQuery(
               *server.Read(), query,
               kg_core::DefaultDataset(PlanGraph(server.plan_run()).text), {})
        .rows.size();
  }

  kg_core::TemporaryFolder folder_;
  MissionFolders folders_;
};

TEST_F(MissionServerTest, RefusesAMissionFolderWithoutFacts) {
  folders_.mission = folder_ / "nowhere";
  EXPECT_THROW(MissionServer server(folders_), InputError);
}

TEST_F(MissionServerTest, TakesAFactAndRefusesAnother) {
  MissionServer server(folders_);
  const std::uint64_t before = server.world_version();
  const Decision taken =
      server.Apply(Set("ex:alpha", "ex:usesPolicy", "ex:safe"));
  EXPECT_TRUE(taken.accepted);
  EXPECT_EQ(taken.world_version, before + 1);
  EXPECT_EQ(server.mission().agents.at(0).policy.name, "safe");
  const Decision refused =
      server.Apply(Set("ex:alpha", "ex:usesPolicy", "ex:nobody"));
  EXPECT_FALSE(refused.accepted);
  EXPECT_EQ(refused.reasons.size(), 1u);
  EXPECT_EQ(refused.world_version, before + 1);
  EXPECT_EQ(server.mission().agents.at(0).policy.name, "safe");
}

TEST_F(MissionServerTest, AFactThatIsSoAlreadyIsNoNewWorld) {
  MissionServer server(folders_);
  const std::uint64_t before = server.world_version();
  EXPECT_TRUE(
      server.Apply(Set("ex:alpha", "ex:usesPolicy", "ex:fast")).accepted);
  EXPECT_EQ(server.world_version(), before);
}

TEST_F(MissionServerTest, AnUnreadableFileIsRefusedAndTheMissionRunsOn) {
  MissionServer server(folders_);
  const Decision decision =
      server.Apply(Set("ex:currents", "ex:file", "\"absent.nc\""));
  EXPECT_FALSE(decision.accepted);
  ASSERT_EQ(decision.reasons.size(), 1u);
  EXPECT_NE(decision.reasons[0].find("absent.nc"), std::string::npos);
  EXPECT_NO_THROW(server.BeginCycle());
}

TEST_F(MissionServerTest, CheckChangesNothing) {
  MissionServer server(folders_);
  const std::uint64_t before = server.world_version();
  EXPECT_TRUE(
      server.Check(Set("ex:alpha", "ex:usesPolicy", "ex:safe")).empty());
  EXPECT_FALSE(server.Check(Set("ex:w0", "ex:confidence", "1.2")).empty());
  EXPECT_EQ(server.world_version(), before);
  EXPECT_EQ(server.mission().agents.at(0).policy.name, "fast");
}

TEST_F(MissionServerTest, PlansBecomeFactsThatLeadBackToFiles) {
  MissionServer server(folders_);
  const auto compilation = server.BeginCycle();
  PlannerAnswer answer;
  const kg_msgs::Assignments plan = PlanOf(*compilation, server, &answer);
  ASSERT_EQ(plan.assignments.size(), 1u);
  ASSERT_EQ(plan.assignments[0].pathlet.visits.size(), 2u);
  Record(plan, answer, &server);
  std::string previous;
  for (const kg_msgs::NavGraph& graph : answer.nav_graphs) {
    server.RecordNavGraph(graph, previous);
    previous = graph.hash;
  }
  EXPECT_EQ(Count(server,
                  "SELECT ?a { ?a a ex:Assignment ; "
                  "ex:forAgent ex:alpha }"),
            2u);
  EXPECT_EQ(Count(server,
                  "SELECT DISTINCT ?a { ?a a ex:Assignment ; "
                  "prov:wasDerivedFrom+ ?f . ?f a ex:SourceFile }"),
            2u);
  std::size_t edges = 0;
  for (const kg_msgs::NavGraph& graph : answer.nav_graphs) {
    edges += graph.edges.size();
  }
  EXPECT_EQ(Count(server,
                  "SELECT ?c { ?c a ex:EdgeCost ; ex:forEdge ?e . "
                  "?e ex:to ?w . ?w ex:score ?s }"),
            edges);
}

TEST_F(MissionServerTest, AnAssignmentNeverTriggersItsOwnRecompilation) {
  MissionServer server(folders_);
  const auto compilation = server.BeginCycle();
  PlannerAnswer answer;
  Record(PlanOf(*compilation, server, &answer), answer, &server);
  EXPECT_EQ(server.world_version(), compilation->world_version);
  EXPECT_TRUE(server.BeginCycle()->dirty.empty());
}

TEST_F(MissionServerTest, ARestartGoesOnWhereItWas) {
  std::uint64_t version = 0;
  std::uint64_t cycle = 0;
  {
    MissionServer server(folders_);
    server.Apply(Set("ex:alpha", "ex:usesPolicy", "ex:safe"));
    server.BeginCycle();
    AgentPose pose;
    pose.position = {-90.5, 25.6};
    pose.time_s = server.mission().windows[0].begin_s + 1000.0;
    pose.energy_left_j = 123.0;
    EXPECT_TRUE(server.fleet().Observe("alpha", pose));
    server.Save();
    version = server.world_version();
    cycle = server.cycle();
  }
  MissionServer server(folders_);
  EXPECT_TRUE(server.was_restored());
  EXPECT_EQ(server.world_version(), version);
  EXPECT_EQ(server.cycle(), cycle);
  EXPECT_EQ(server.mission().agents.at(0).policy.name, "safe");
  EXPECT_EQ(server.fleet().poses().at("alpha").position.lon_deg, -90.5);
  EXPECT_NEAR(server.fleet().poses().at("alpha").energy_left_j, 123.0, 1e-9);
  EXPECT_EQ(server.fleet().time_s(),
            server.mission().windows[0].begin_s + 1000.0);
}

TEST_F(MissionServerTest, RefusesTheStateOfAnotherMission) {
  { MissionServer server(folders_); }
  MissionFolders other = folders_;
  other.mission = folder_ / "other";
  WriteTestMission(other.mission);
  EXPECT_THROW(MissionServer server(other), InputError);
}

TEST_F(MissionServerTest, AfterItsEndAMissionBeginsAnewAndTheOldOneIsKept) {
  {
    MissionServer server(folders_);
    AgentPose pose;
    pose.position = {-90.5, 25.6};
    pose.time_s = server.mission().windows.back().end_s;
    server.fleet().Observe("alpha", pose);
    ASSERT_TRUE(server.ended());
    server.RecordEnd();
  }
  MissionServer server(folders_);
  EXPECT_FALSE(server.was_restored());
  EXPECT_FALSE(server.ended());
  EXPECT_TRUE(std::filesystem::exists(folders_.state + "/store-1.db"));
}

TEST_F(MissionServerTest, CyclesLeaveFromWhereAgentsAreNow) {
  MissionServer server(folders_);
  const kg_core::TimeWindow& first = server.mission().windows[0];
  AgentPose pose;
  pose.position = {-90.6, 25.6};
  pose.time_s = first.begin_s + 0.5 * first.duration_s();
  server.fleet().Observe("alpha", pose);
  const auto rules = server.BeginCycle()->rules.at(0);
  EXPECT_EQ(rules.start.lon_deg, -90.6);
  ASSERT_EQ(rules.windows.size(), 2u);
  EXPECT_EQ(rules.windows[0].begin_s, pose.time_s);
  EXPECT_NEAR(rules.windows[0].base_travel_m,
              0.5 * rules.windows[1].base_travel_m, 1e-6);
}

TEST_F(MissionServerTest, AWindowThatIsNearlyOverIsNotPlannedAnyMore) {
  MissionServer server(folders_);
  const kg_core::TimeWindow& first = server.mission().windows[0];
  AgentPose pose;
  pose.position = {-90.6, 25.6};
  pose.time_s = first.begin_s + 0.9 * first.duration_s();
  server.fleet().Observe("alpha", pose);
  const auto rules = server.BeginCycle()->rules.at(0);
  ASSERT_EQ(rules.windows.size(), 1u);
  EXPECT_EQ(rules.windows[0].window, 1);
  EXPECT_EQ(rules.windows[0].begin_s, pose.time_s);
}

TEST_F(MissionServerTest, AVisitedEventIsClosed) {
  MissionServer server(folders_);
  EXPECT_EQ(server.BeginCycle()->rules.at(0).windows.at(1).events.size(), 1u);
  ExecutedVisit past;
  past.agent = "alpha";
  past.agent_iri = std::string(kg_core::kEx) + "alpha";
  past.visit.events = {std::string(kg_core::kEx) + "bloom"};
  server.AddExecuted(past);
  const auto compilation = server.BeginCycle();
  EXPECT_TRUE(compilation->rules.at(0).windows.at(1).events.empty());
  EXPECT_EQ(compilation->coordination.event_capacity.begin()->second, 0);
}

TEST_F(MissionServerTest, ExecutedStopsSurviveARestart) {
  {
    MissionServer server(folders_);
    const auto compilation = server.BeginCycle();
    PlannerAnswer answer;
    const kg_msgs::Assignments plan = PlanOf(*compilation, server, &answer);
    server.AddExecuted({"alpha", plan.assignments[0].agent_iri,
                        plan.assignments[0].pathlet.visits[0]});
    Record(plan, answer, &server);
  }
  MissionServer server(folders_);
  ASSERT_EQ(server.executed().size(), 1u);
  EXPECT_EQ(server.executed()[0].agent, "alpha");
  EXPECT_EQ(server.executed()[0].visit.window, 0);
  EXPECT_GT(server.executed()[0].visit.cost.energy_j, 0.0);
}

TEST_F(MissionServerTest, OldPlansAreDroppedWhole) {
  MissionServer server(folders_);
  const auto compilation = server.BeginCycle();
  PlannerAnswer answer;
  kg_msgs::Assignments plan = PlanOf(*compilation, server, &answer);
  for (int i = 0; i < 7; ++i) {
    Record(plan, answer, &server);
    ++plan.plan_run;
  }
  EXPECT_EQ(Count(server,
                  "SELECT DISTINCT ?g { GRAPH ?g { ?s ?p ?o } "
                  "FILTER(CONTAINS(STR(?g), \"graph/plan/\")) }"),
            5u);
}

}  // namespace
}  // namespace kg_ros
