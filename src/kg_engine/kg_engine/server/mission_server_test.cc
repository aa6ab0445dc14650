// Mission server and one planner in one process: updates, cycles, plans as
// facts, restarts.

#include "kg_engine/server/mission_server.h"

#include <algorithm>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/planning/agent_planner.h"
#include "kg_engine/planning/team_selector.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/terms/plan_names.h"
#include "kg_mission/mission/testing/validate_graph.h"
#include "kg_mission/mission/validator.h"

namespace kg_engine {
namespace {

using kg_base::InputError;
using kg_compiler::Compilation;
using kg_compiler::Layer;

class MissionServerTest : public testing::Test {
 protected:
  MissionServerTest() {
    folders_.mission = folder_ / "mission";
    folders_.state = folder_ / "state";
    folders_.ontology = "../kg_mission/ontology";
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

  // Plan of planner and selector for a compilation.
  static kg_selector::CommittedPlan PlanOf(const Compilation& compilation,
                                           const MissionServer& server,
                                           PlannerAnswer* answer) {
    AgentPlanner planner;
    for (const auto& field : compilation.fields) planner.Take(field);
    for (const auto& tensor : compilation.tensors) planner.Take(tensor);
    planner.Take(compilation.rules.at(0), server.cycle());
    EXPECT_TRUE(planner.IsComplete()) << planner.Missing();
    *answer = planner.Plan();
    TeamSelector selector;
    selector.KnowRun(server.plan_run());
    selector.Take(ToTeamTask(compilation, server.cycle()));
    const SelectorAnswer plan = selector.Take(answer->candidates);
    EXPECT_TRUE(plan.plan) << answer->candidates.found.note;
    return plan.plan.value_or(kg_selector::CommittedPlan());
  }

  static void Record(const kg_selector::CommittedPlan& plan,
                     const PlannerAnswer& answer, MissionServer* server) {
    PlanRecord record;
    record.plan = plan;
    for (const AgentGraph& graph : answer.graphs) {
      record.nav_graphs[{graph.agent, graph.window()}] =
          ToStamp(*graph.graph, graph.made_s);
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

  kg_base::TemporaryFolder folder_;
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
  EXPECT_TRUE(server.Check(Set("ex:alpha", "ex:usesPolicy", "ex:safe"))
                  .reasons.empty());
  EXPECT_FALSE(
      server.Check(Set("ex:w0", "ex:confidence", "1.2")).reasons.empty());
  EXPECT_EQ(server.world_version(), before);
  EXPECT_EQ(server.mission().agents.at(0).policy.name, "fast");
}

TEST_F(MissionServerTest, CheckListsTheViolationsOfAnUpdate) {
  MissionServer server(folders_);
  const kg_mission::UpdateJudgement judgement =
      server.Check(Set("ex:w0", "ex:confidence", "1.2"));
  ASSERT_TRUE(judgement.violations);
  ASSERT_EQ(judgement.violations->size(), 1u);
  const kg_core::Violation& violation = judgement.violations->front();
  EXPECT_EQ(judgement.reasons,
            std::vector<std::string>{"ex:w0 ex:confidence: expected exactly "
                                     "one confidence in [0, 1], not 1.2 "
                                     "(ex:TimeWindowShape)"});
  EXPECT_EQ(violation.Line(), judgement.reasons[0]);
  EXPECT_NE(kg_core::ReportTurtle(*judgement.violations)
                .find("sh:focusNode ex:w0 ;\n    sh:resultPath ex:confidence"),
            std::string::npos);
  EXPECT_TRUE(
      server.Check(Set("ex:w0", "ex:confidence", "0.5")).violations->empty());
  kg_core::FactUpdate unreadable;
  unreadable.turtle = "ex:w0 ex:confidence";
  EXPECT_FALSE(server.Check(unreadable).violations);
}

TEST_F(MissionServerTest, AStoreThatViolatesTheShapesIsReportedAndRepairable) {
  { MissionServer server(folders_); }
  {
    kg_core::Store store(folders_.state + "/store.db");
    kg_core::Transaction damage = store.Begin();
    const kg_core::Term w1 = kg_core::Iri(std::string(kg_core::kEx) + "w1");
    const kg_core::Term property =
        kg_core::Iri(std::string(kg_core::kEx) + "confidence");
    const kg_core::Term facts = kg_core::Iri(kg_core::kFactsGraph);
    damage.RemoveMatching(&w1, &property, nullptr, facts);
    damage.Add({w1, property, kg_core::DoubleLiteral(1.5), facts});
    damage.Commit(kg_core::WorldChange::kYes);
  }
  MissionServer server(folders_);
  ASSERT_EQ(server.violations_at_start().size(), 1u);
  EXPECT_EQ(server.violations_at_start()[0].rfind("ex:w1 ex:confidence: ", 0),
            0u);
  EXPECT_TRUE(
      server.Apply(Set("ex:alpha", "ex:usesPolicy", "ex:safe")).accepted);
  EXPECT_FALSE(server.Apply(Set("ex:w1", "ex:durationHours", "23")).accepted);
  EXPECT_TRUE(server.Apply(Set("ex:w1", "ex:confidence", "0.8")).accepted);
  EXPECT_TRUE(kg_mission::Validate(*server.Read()).empty());
}

TEST_F(MissionServerTest, PlansBecomeFactsThatLeadBackToFiles) {
  MissionServer server(folders_);
  const auto compilation = server.BeginCycle();
  PlannerAnswer answer;
  const kg_selector::CommittedPlan plan = PlanOf(*compilation, server, &answer);
  ASSERT_EQ(plan.assignments.size(), 1u);
  ASSERT_EQ(plan.assignments[0].pathlet.visits.size(), 2u);
  Record(plan, answer, &server);
  std::string previous;
  for (const AgentGraph& graph : answer.graphs) {
    server.RecordGraph(graph, previous);
    previous = graph.graph->hash;
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
  for (const AgentGraph& graph : answer.graphs) {
    edges += graph.graph->edges.size();
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
    EXPECT_TRUE(server.Observe("alpha", pose));
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

TEST_F(MissionServerTest, AMissionCanRestartAfterItsEndAndKeepsTheOldOne) {
  {
    MissionServer server(folders_);
    AgentPose pose;
    pose.position = {-90.5, 25.6};
    pose.time_s = server.mission().windows.back().end_s;
    server.Observe("alpha", pose);
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
  const kg_mission::TimeWindow& first = server.mission().windows[0];
  AgentPose pose;
  pose.position = {-90.6, 25.6};
  pose.time_s = first.begin_s + 0.5 * first.duration_s();
  server.Observe("alpha", pose);
  const auto rules = server.BeginCycle()->rules.at(0);
  EXPECT_EQ(rules.start.lon_deg, -90.6);
  ASSERT_EQ(rules.windows.size(), 2u);
  EXPECT_EQ(rules.windows[0].begin_s, pose.time_s);
  EXPECT_NEAR(rules.windows[0].base_travel_m,
              0.5 * rules.windows[1].base_travel_m, 1e-6);
}

TEST_F(MissionServerTest, AWindowThatIsNearlyOverIsNotPlannedAnyMore) {
  MissionServer server(folders_);
  const kg_mission::TimeWindow& first = server.mission().windows[0];
  AgentPose pose;
  pose.position = {-90.6, 25.6};
  pose.time_s = first.begin_s + 0.9 * first.duration_s();
  server.Observe("alpha", pose);
  const auto rules = server.BeginCycle()->rules.at(0);
  ASSERT_EQ(rules.windows.size(), 1u);
  EXPECT_EQ(rules.windows[0].window, 1);
  EXPECT_EQ(rules.windows[0].begin_s, pose.time_s);
}

TEST_F(MissionServerTest, AConstraintThatExpiresComesOffTheMap) {
  MissionServer server(folders_);
  kg_core::FactUpdate update;
  update.author = "operator";
  update.turtle =
      "ex:firing a ex:Constraint ; ex:kind \"no_go\" ; ex:validUntil "
      "\"2026-06-02T12:00:00Z\"^^xsd:dateTime ; geo:asWKT "
      "\"POLYGON((-91 25.5, -90.7 25.5, -90.7 26, -91 26, -91 25.5))\" .";
  const std::size_t without = server.mission().constraints.size();
  ASSERT_TRUE(server.Apply(update).accepted);
  ASSERT_EQ(server.mission().constraints.size(), without + 1);
  EXPECT_EQ(server.mission().constraints[0].windows, std::vector<int>{0});
  const auto blocked = server.BeginCycle();
  AgentPose pose;
  pose.position = {-90.6, 25.6};
  pose.time_s = server.mission().windows[0].begin_s + 6 * 3600.0;
  server.Observe("alpha", pose);
  EXPECT_FALSE(server.ExpiryIsDue());
  pose.time_s += 6 * 3600.0;
  server.Observe("alpha", pose);
  ASSERT_TRUE(server.ExpiryIsDue());
  const std::uint64_t before = server.world_version();
  const Expired expired = server.Expire();
  EXPECT_TRUE(expired.decision.accepted);
  EXPECT_EQ(expired.decision.world_version, before + 1);
  EXPECT_FALSE(server.ExpiryIsDue());
  EXPECT_EQ(server.mission().constraints.size(), without);
  const auto open = server.BeginCycle();
  EXPECT_FALSE(open->dirty.empty());
  for (const auto& dirty : open->dirty) EXPECT_EQ(dirty.window, 0);
  EXPECT_NE(open->tensors.at(0)->hash, blocked->tensors.at(0)->hash);
  EXPECT_EQ(open->tensors.at(1)->hash, blocked->tensors.at(1)->hash);
  EXPECT_EQ(Count(server,
                  "SELECT ?c { GRAPH graph:log { ?c ex:ofSubject ex:firing ; "
                  "ex:ofProperty ex:kind ; ex:oldValue \"no_go\" ; "
                  "ex:inUpdate ?u } ?u ex:author \"kg\" }"),
            1u);
}

TEST_F(MissionServerTest, ReferencedFactsOutliveTheirEndWithOneWarning) {
  MissionServer server(folders_);
  kg_core::FactUpdate update;
  update.turtle =
      "ex:reef a ex:Constraint ; ex:kind \"soft\" ; ex:attenuation 0.5 ; "
      "ex:validUntil \"2026-06-01T00:00:00Z\"^^xsd:dateTime ; geo:asWKT "
      "\"POLYGON((-91 25.5, -90.7 25.5, -90.7 26, -91 26, -91 25.5))\" . "
      "ex:safe ex:softOverrides '{\"reef\": 0.1}' .";
  const std::size_t without = server.mission().constraints.size();
  ASSERT_TRUE(server.Apply(update).accepted);
  EXPECT_EQ(server.mission().constraints.size(), without);  // Applies nowhere.
  ASSERT_TRUE(server.ExpiryIsDue());
  const Expired expired = server.Expire();
  EXPECT_TRUE(expired.update.remove.empty());
  ASSERT_EQ(expired.kept.size(), 1u);
  EXPECT_NE(expired.kept[0].find("ex:constraint refers to it"),
            std::string::npos);
  EXPECT_FALSE(server.ExpiryIsDue());
  EXPECT_TRUE(server.Expire().kept.empty());
  kg_core::FactUpdate freed;
  freed.remove = {{"ex:safe", "ex:softOverrides", ""}};
  ASSERT_TRUE(server.Apply(freed).accepted);
  ASSERT_TRUE(server.ExpiryIsDue());
  EXPECT_TRUE(server.Expire().decision.accepted);
  EXPECT_EQ(Count(server, "SELECT ?t { ex:reef a ?t }"), 0u);
}

// Checks every graph that the node writes against the shapes.
void ExpectAllConforms(const MissionServer& server) {
  const auto view = server.Read();
  const kg_core::Vocabulary vocabulary(*view);
  const kg_core::Term type = kg_core::Iri(std::string(kg_core::kRdf) + "type");
  for (const std::string& graph :
       {std::string(kg_core::kFactsGraph), std::string(kg_core::kProvGraph),
        std::string(kg_core::kLogGraph), std::string(kg_core::kStateGraph),
        PlanGraph(server.plan_run()).text}) {
    for (const kg_core::Violation& found :
         kg_mission::ValidateGraph(*view, graph)) {
      ADD_FAILURE() << graph << ": " << found.Line();
    }
    int quads = 0;
    kg_core::Quad pattern;
    pattern.graph = view->Find(kg_core::Iri(graph));
    view->Match(pattern, [&](const kg_core::Quad& quad) {
      const kg_core::Term& property = view->Get(quad.predicate);
      EXPECT_NE(vocabulary.FindProperty(property), nullptr) << property;
      if (property == type) {
        EXPECT_TRUE(vocabulary.HasClass(view->Get(quad.object)))
            << view->Get(quad.object);
      }
      ++quads;
      return true;
    });
    EXPECT_GT(quads, 5) << graph;
  }
}

void RecordGraphs(const PlannerAnswer& answer, MissionServer* server) {
  std::string previous;
  for (const AgentGraph& graph : answer.graphs) {
    server->RecordGraph(graph, previous);
    previous = graph.graph->hash;
  }
}

TEST_F(MissionServerTest, AllThatItWritesConformsAndIsInTheOntology) {
  MissionServer server(folders_);
  const auto compilation = server.BeginCycle();
  PlannerAnswer answer;
  Record(PlanOf(*compilation, server, &answer), answer, &server);
  RecordGraphs(answer, &server);
  server.Apply(Set("ex:alpha", "ex:usesPolicy", "ex:safe"));
  ExpectAllConforms(server);
}

// Facts kept of walks and executed stops.
TEST_F(MissionServerTest, StopsAreFactsThatConformAndSurviveARestart) {
  kg_selector::Visit made;
  {
    MissionServer server(folders_);
    ASSERT_TRUE(server.Apply(Set("ex:mission", "ex:movementMode", "\"edges\""))
                    .accepted);
    const auto compilation = server.BeginCycle();
    PlannerAnswer answer;
    const kg_selector::CommittedPlan plan =
        PlanOf(*compilation, server, &answer);
    for (const kg_selector::Visit& visit : plan.assignments[0].pathlet.visits) {
      if (!visit.via.empty()) made = visit;
    }
    ASSERT_FALSE(made.via.empty());
    Record(plan, answer, &server);
    RecordGraphs(answer, &server);
    ExpectAllConforms(server);
    EXPECT_GT(Count(server,
                    "SELECT ?e { ?e a ex:TraverseEdge ; ex:via ?w ; "
                    "ex:inGraph ?g . ?w ex:inGraph ?g }"),
              0u);
    EXPECT_GT(Count(server,
                    "SELECT ?x { ?x a ex:Assignment ; "
                    "ex:stopsWKT ?wkt ; ex:status \"planned\" }"),
              0u);
    server.AddExecuted({"alpha", plan.assignments[0].agent_iri, made});
    Record(PlanOf(*server.BeginCycle(), server, &answer), answer, &server);
  }
  MissionServer server(folders_);
  ASSERT_EQ(server.executed().size(), 1u);
  const kg_selector::Visit& kept = server.executed()[0].visit;
  ASSERT_EQ(kept.via.size(), made.via.size());
  for (std::size_t i = 0; i < made.via.size(); ++i) {
    const kg_base::LonLat& there = made.via[i].position;
    EXPECT_NEAR(kept.via[i].position.lon_deg, there.lon_deg, 1e-10);
    EXPECT_NEAR(kept.via[i].position.lat_deg, there.lat_deg, 1e-10);
  }
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
    const kg_selector::CommittedPlan plan =
        PlanOf(*compilation, server, &answer);
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
  kg_selector::CommittedPlan plan = PlanOf(*compilation, server, &answer);
  for (int i = 0; i < 7; ++i) {
    Record(plan, answer, &server);
    ++plan.run;
  }
  EXPECT_EQ(Count(server,
                  "SELECT DISTINCT ?g { GRAPH ?g { ?s ?p ?o } "
                  "FILTER(CONTAINS(STR(?g), \"graph/plan/\")) }"),
            5u);
}

// A soft zone around the whole area, a second agent with its own policy, and
// the effect of an escalating policy on the zone.
class EscalationTest : public MissionServerTest {
 protected:
  EscalationTest() : server_(folders_) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.turtle = R"ttl(
ex:zone a ex:Constraint ; ex:kind "soft" ; ex:attenuation 0.4 ;
    geo:asWKT "POLYGON((-95 20, -85 20, -85 30, -95 30, -95 20))" .
ex:mission ex:hasAgent ex:bravo .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:usesPolicy ex:safe ;
    ex:hasCapabilities ex:alpha_capabilities .
ex:bravo_start a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.7 25.7)" .
)ttl";
    EXPECT_TRUE(server_.Apply(update).accepted);
  }

  void Take(const std::string& subject, const std::string& property,
            const std::string& value) {
    const Decision decision = server_.Apply(Set(subject, property, value));
    EXPECT_TRUE(decision.accepted) << decision.reasons.at(0);
  }

  static double Most(const kg_base::Raster& raster) {
    double most = 0.0;
    for (const float value : raster) {
      if (value > most) most = value;
    }
    return most;
  }

  // An agent's tensors, by window.
  using Tensors =
      std::vector<std::shared_ptr<const kg_compiler::MissionTensor>>;
  static Tensors Of(const Compilation& compilation, const std::string& agent) {
    Tensors tensors;
    for (const auto& tensor : compilation.tensors) {
      if (tensor->agent_iri == kg_core::kEx + agent) tensors.push_back(tensor);
    }
    EXPECT_EQ(tensors.size(), 2u);
    return tensors;
  }

  // Inferred fact that alpha must avoid the zone; empty if none.
  std::string Inference() const {
    const kg_core::QueryResult result = kg_core::RunQuery(
        *server_.Read(),
        "SELECT ?i { ?i a ex:Inference ; ex:byRule ex:escalation ; "
        "ex:conclusion [ rdf:subject ex:alpha ; rdf:predicate ex:mustAvoid ; "
        "rdf:object ex:zone ] ; prov:wasDerivedFrom [ rdf:subject ex:fast ; "
        "rdf:predicate ex:escalateSoft ; rdf:object true ] }",
        kg_core::DefaultDataset(std::nullopt), {});
    return result.rows.empty() ? "" : result.rows[0][0]->text;
  }

  MissionServer server_;
};

TEST_F(EscalationTest, TogglingThePolicyFlipsTheMaskOfThatAgentOnly) {
  const auto before = server_.BeginCycle();
  for (const char* agent : {"alpha", "bravo"}) {
    for (const auto& tensor : Of(*before, agent)) {
      EXPECT_NEAR(Most(tensor->Get(Layer::kAttenuation)), 0.4, 1e-6);
      EXPECT_GT(Most(tensor->Get(Layer::kFused)), 0.0);
      EXPECT_EQ(Most(tensor->Get(Layer::kFeasibility)), 1.0);
    }
  }
  EXPECT_EQ(Inference(), "");
  Take("ex:fast", "ex:escalateSoft", "true");
  const auto after = server_.BeginCycle();
  for (const auto& tensor : Of(*after, "alpha")) {
    EXPECT_EQ(Most(tensor->Get(Layer::kFused)), 0.0);
    EXPECT_EQ(Most(tensor->Get(Layer::kFeasibility)), 0.0);
  }
  EXPECT_EQ(Of(*after, "bravo"), Of(*before, "bravo"));  // The same objects.
  for (const kg_compiler::DirtyArtifact& dirty : after->dirty) {
    EXPECT_EQ(dirty.agent, std::string(kg_core::kEx) + "alpha");
  }
  Take("ex:fast", "ex:escalateSoft", "false");
  const auto again = server_.BeginCycle();
  EXPECT_EQ(Of(*again, "alpha")[0]->hash, Of(*before, "alpha")[0]->hash);
  EXPECT_EQ(Inference(), "");
}

TEST_F(EscalationTest, TheTensorIsDerivedFromTheInference) {
  Take("ex:fast", "ex:escalateSoft", "true");
  const auto compilation = server_.BeginCycle();
  const std::string inference = Inference();
  ASSERT_NE(inference, "");
  const auto cites = [&](const std::string& agent) {
    const auto& sources = Of(*compilation, agent)[0]->derived_from;
    return std::count(sources.begin(), sources.end(), inference);
  };
  EXPECT_EQ(cites("alpha"), 1);
  EXPECT_EQ(cites("bravo"), 0);
}

TEST_F(EscalationTest, SwitchingTheRuleOffByAFactStopsIt) {
  Take("ex:fast", "ex:escalateSoft", "true");
  Take("ex:escalation", "ex:enabled", "false");
  EXPECT_EQ(Inference(), "");
  EXPECT_TRUE(server_.mission().agents.at(0).must_avoid.empty());
  EXPECT_GT(Most(Of(*server_.BeginCycle(), "alpha")[0]->Get(Layer::kFused)),
            0.0);
  Take("ex:escalation", "ex:enabled", "true");
  EXPECT_NE(Inference(), "");
  EXPECT_EQ(Most(Of(*server_.BeginCycle(), "alpha")[0]->Get(Layer::kFused)),
            0.0);
}

TEST_F(MissionServerTest, ConclusionsSurviveARestart) {
  {
    MissionServer server(folders_);
    kg_core::FactUpdate update = Set("ex:fast", "ex:escalateSoft", "true");
    update.turtle =
        "ex:zone a ex:Constraint ; ex:kind 'soft' ; ex:attenuation 0.4 ; "
        "geo:asWKT 'POLYGON((-95 20, -85 20, -85 30, -95 30, -95 20))' .";
    EXPECT_TRUE(server.Apply(update).accepted);
  }
  const MissionServer server(folders_);
  EXPECT_EQ(server.mission().agents.at(0).must_avoid.size(), 1u);
}

}  // namespace
}  // namespace kg_engine
