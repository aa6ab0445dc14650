// Traces every decision back to asserted facts, on a planned mission of two
// agents with conflicting paths.

#include <algorithm>
#include <map>
#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/geo/geodesy.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/server/testing/test_mission.h"
#include "kg_engine/server/testing/test_team.h"
#include "kg_engine/simulation/track_position.h"
#include "kg_engine/terms/artifact_names.h"
#include "kg_engine/terms/plan_names.h"
#include "kg_engine/terms/track_literal.h"

namespace kg_engine {
namespace {

using kg_compiler::MissionTensor;
using kg_core::Fact;

// Property path from a result to its inputs.
constexpr char kWay[] =
    "(prov:wasDerivedFrom|prov:used|prov:wasGeneratedBy|prov:wasAttributedTo"
    "|prov:wasInformedBy|ex:cooling|ex:inGraph|ex:forEdge)";

class ProvenanceTest : public testing::Test {
 protected:
  ProvenanceTest() {
    server_ = StartTestServer(folder_);
    team_ = std::make_unique<MissionPlanning>(server_.get());
    kg_core::FactUpdate update;
    update.id = "join";
    update.author = "operator";
    update.turtle = kSecondAgent;
    update.set = {{"ex:mission", "ex:minimumSeparationKm", "5"},
                  {"ex:fast", "ex:beta_poi", "0.5"}};
    const Decision decision = server_->Apply(update);
    EXPECT_TRUE(decision.accepted)
        << (decision.reasons.empty() ? "" : decision.reasons[0]);
  }

  bool Set(const Fact& fact) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.set = {fact};
    return server_->Apply(update).accepted;
  }
  bool Add(const std::string& turtle) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.turtle = turtle;
    return server_->Apply(update).accepted;
  }

  std::vector<std::vector<std::string>> Rows(const std::string& query) const {
    const kg_core::QueryResult result = kg_core::RunQuery(
        *server_->Read(), query,
        kg_core::DefaultDataset(PlanGraph(server_->plan_run()).text), {});
    std::vector<std::vector<std::string>> rows;
    for (const auto& row : result.rows) {
      rows.emplace_back();
      for (const auto& term : row) {
        rows.back().push_back(term ? kg_core::ToTurtle(*term) : "");
      }
    }
    return rows;
  }
  std::size_t Count(const std::string& pattern) const {
    return Rows("SELECT * { " + pattern + " }").size();
  }

  // Every node reached from `start` is described, and every end is asserted or
  // a file with its sha256.
  void ExpectTraced(const std::string& start) const {
    const std::string way = start + " . ?x " + kWay + "+ ?node . ";
    EXPECT_GT(Count(way), 0u) << start;
    EXPECT_EQ(
        Rows("SELECT ?node { " + way + "FILTER NOT EXISTS { ?node a ?type } }"),
        std::vector<std::vector<std::string>>())
        << "dangling, from " << start;
    EXPECT_EQ(
        Rows("SELECT DISTINCT ?node { " + way + "FILTER NOT EXISTS { ?node " +
             kWay +
             " ?more } "
             "FILTER NOT EXISTS { ?node a ex:SourceFile ; ex:sha256 ?sha "
             "  FILTER(STRLEN(?sha) = 64) } "
             "FILTER NOT EXISTS { GRAPH graph:facts { ?node ?p ?o } "
             "  GRAPH graph:log { ?c ex:ofSubject ?node ; ex:inUpdate ?u } "
             "  GRAPH graph:prov { ?u ex:author ?who ; "
             "    prov:startedAtTime ?when } } }"),
        std::vector<std::vector<std::string>>())
        << "neither asserted nor a file, from " << start;
  }

  kg_base::TemporaryFolder folder_;
  std::unique_ptr<MissionServer> server_;
  std::unique_ptr<MissionPlanning> team_;
};

TEST_F(ProvenanceTest, EveryResultLeadsToAssertedFactsAndFilesOnly) {
  team_->Plan();
  for (const char* type :
       {"ex:Assignment", "ex:Rejection", "ex:HeatmapArtifact", "ex:SeamRules",
        "ex:NavGraph", "ex:CoolingConstraint", "ex:EdgeCost"}) {
    EXPECT_GT(Count(std::string("?x a ") + type), 0u) << type;
    ExpectTraced(std::string("?x a ") + type);
  }
}

TEST_F(ProvenanceTest, ACommitmentLeadsToTheRunThatMadeIt) {
  ASSERT_TRUE(Set({"ex:fast", "ex:churnWeight", "2"}));
  team_->Plan();
  team_->Plan();
  for (const char* type : {"ex:Commitment", "ex:SeamRules", "ex:Assignment"}) {
    EXPECT_GT(Count(std::string("?x a ") + type), 0u) << type;
    ExpectTraced(std::string("?x a ") + type);
  }
}

TEST_F(ProvenanceTest, EveryArtifactIsAnEntityOfOneActivityWithItsTimes) {
  team_->Plan();
  for (const char* type : {"ex:HeatmapArtifact", "ex:SeamRules", "ex:NavGraph",
                           "ex:Assignment", "ex:Rejection"}) {
    const std::string artifact = std::string("?x a ") + type;
    EXPECT_EQ(Count(artifact + " FILTER NOT EXISTS { ?x a/rdfs:subClassOf* "
                               "prov:Entity }"),
              0u)
        << type;
    EXPECT_EQ(Count(artifact +
                    " FILTER NOT EXISTS { ?x prov:wasGeneratedBy ?a . ?a a "
                    "prov:Activity ; prov:startedAtTime ?s ; prov:endedAtTime "
                    "?e ; prov:used ?u ; ex:worldVersion ?v FILTER(?s <= ?e) "
                    "}"),
              0u)
        << type;
  }
  EXPECT_EQ(Count("?a a prov:Activity ; prov:startedAtTime ?s , ?t "
                  "FILTER(?s != ?t)"),
            0u);
  EXPECT_EQ(Count("?a a prov:Activity ; prov:endedAtTime ?s , ?t "
                  "FILTER(?s != ?t)"),
            0u);
}

TEST_F(ProvenanceTest, TensorsAreDerivedFromExactlyWhatTheirCompileRead) {
  team_->Plan();
  for (const auto& tensor : team_->compilation().tensors) {
    const kg_core::Term node =
        TensorNode(*tensor, team_->compilation().mission);
    std::set<std::string> stated;
    for (const kg_core::Term& source :
         kg_core::Objects(*server_->Read(), kg_core::kProvGraph, node,
                          kg_core::Prov("wasDerivedFrom"))) {
      stated.insert(source.text);
    }
    EXPECT_EQ(stated, std::set<std::string>(tensor->derived_from.begin(),
                                            tensor->derived_from.end()));
  }
}

TEST_F(ProvenanceTest, RejectionsNameBothAgentsAndTheEndOfCooling) {
  const kg_selector::CommittedPlan& plan = team_->Plan();
  EXPECT_GT(plan.rounds, 0);
  const auto rows = Rows(
      "SELECT ?agent ?by ?until ?factor { ?r a ex:Rejection ; ex:forAgent "
      "?agent ; ex:lostTo ?by ; ex:cooling ?c . ?c ex:forAgent ?agent ; "
      "ex:cooledBy ?by ; ex:expires ?until ; ex:attenuation ?factor ; "
      "geo:asWKT ?wkt ; ex:forWindow ex:w0 , ex:w1 }");
  ASSERT_GT(rows.size(), 0u);
  EXPECT_NE(rows[0][0], rows[0][1]);
  EXPECT_EQ(Count("GRAPH graph:facts { ?c a ex:CoolingConstraint }"), 0u);
  const std::uint64_t cycle = team_->compilation().world_version;
  EXPECT_EQ(server_->world_version(), cycle);  // No policy changed.
}

TEST_F(ProvenanceTest, ATensorThatIsNotCompiledAgainKeepsItsNodeAndTime) {
  team_->Plan();
  const std::string times =
      "SELECT ?t ?hash ?end { ?t a ex:HeatmapArtifact ; ex:hash ?hash ; "
      "prov:wasGeneratedBy/prov:endedAtTime ?end } ORDER BY ?t";
  const auto before = Rows(times);
  ASSERT_EQ(before.size(), 4u);
  ASSERT_TRUE(Set({"ex:w1", "ex:confidence", "0.5"}));
  team_->Plan();
  const auto after = Rows(times);
  EXPECT_EQ(after.size(), 6u);  // The two of window 1 are new.
  for (const auto& row : before) {
    EXPECT_EQ(std::count(after.begin(), after.end(), row), 1) << row[0];
  }
  EXPECT_EQ(Count("GRAPH graph:state { ?s ex:currentPlan ?run } ?run prov:used "
                  "?t . ?t a ex:HeatmapArtifact"),
            4u);
}

TEST_F(ProvenanceTest, APlanIsStaleFromAChangeUntilTheNextAndThenSuperseded) {
  team_->Plan();
  const std::string status =
      "SELECT ?run ?status { GRAPH ?g { ?run a ex:PlanRun ; ex:status ?status "
      "} } ORDER BY ?run";
  using Row = std::vector<std::string>;
  EXPECT_EQ(Rows(status),
            (std::vector<Row>{{"<" + PlanRunNode(1).text + ">", "\"ok\""}}));
  ASSERT_TRUE(Set({"ex:w1", "ex:confidence", "0.5"}));
  EXPECT_EQ(Rows(status)[0][1], "\"stale\"");
  team_->Plan();
  EXPECT_EQ(Rows(status)[0][1], "\"superseded\"");
  EXPECT_EQ(Rows(status)[1][1], "\"ok\"");
}

TEST_F(ProvenanceTest, ExecutedStopsKeepTheirProvenanceWhenTheirRunIsDropped) {
  team_->Plan();
  const std::string path =
      "SELECT ?p ?t ?by { ?x ex:status \"executed\" ; ex:forAgent ex:alpha ; "
      "ex:pathWKT ?p ; ex:pathTimes ?t ; prov:wasGeneratedBy ?by . "
      "?by a ex:PlanRun ; ex:worldVersion ?v }";
  const auto& window = server_->mission().windows[0];
  for (const char* agent : {"alpha", "bravo"}) {
    AgentPose pose;
    pose.position = server_->fleet().poses().at(agent).position;
    pose.time_s = window.end_s;
    pose.energy_left_j = 4e6;
    ASSERT_TRUE(server_->Observe(agent, pose));
  }
  team_->PassWindow(0);
  team_->Plan();
  const auto before = Rows(path);
  ASSERT_EQ(before.size(), 1u);
  EXPECT_EQ(before[0][2], "<" + PlanRunNode(1).text + ">");
  for (int i = 0; i < 6; ++i) team_->Plan();
  EXPECT_EQ(Count("GRAPH <" + PlanGraph(1).text + "> { ?s ?p ?o }"), 0u);
  EXPECT_EQ(Rows(path), before);
  ExpectTraced("?x a ex:Assignment");
  ExpectTraced("?x a ex:NavGraph");  // Derived from reported states.
  EXPECT_GT(Count("?x a ex:SeamRules ; prov:wasDerivedFrom ?s . ?s a "
                  "ex:AgentState ; prov:wasAttributedTo ex:bravo"),
            0u);
}

TEST_F(ProvenanceTest, APathIsWhereTheTrackIsAndEndsAtItsWaypoint) {
  const kg_selector::CommittedPlan& plan = team_->Plan();
  for (const kg_selector::PathAssignment& assignment : plan.assignments) {
    const Track& track = assignment.pathlet.track;
    double begin_s = track.front().time_s;
    for (const kg_selector::Visit& visit : assignment.pathlet.visits) {
      const auto rows =
          Rows("SELECT ?p ?t { ?x ex:forAgent <" + assignment.agent_iri +
               "> ; ex:forWindow/ex:index " + std::to_string(visit.window) +
               " ; ex:pathWKT ?p ; ex:pathTimes ?t }");
      ASSERT_EQ(rows.size(), 1u);
      const auto parts =
          FromLiteral({kg_core::ParseTurtleTerm(rows[0][0]).text,
                       kg_core::ParseTurtleTerm(rows[0][1]).text});
      ASSERT_EQ(parts.size(), 1u);
      EXPECT_NEAR(parts[0].front().time_s, begin_s, 0.1);
      begin_s = parts[0].back().time_s;
      EXPECT_LT(kg_base::Distance_m(parts[0].back().position, visit.position),
                1.0);
      for (const auto& point : track) {
        if (point.time_s < parts[0].front().time_s ||
            point.time_s > parts[0].back().time_s) {
          continue;
        }
        EXPECT_LT(kg_base::Distance_m(point.position,
                                      PositionAt(parts[0], point.time_s)),
                  11.0);
      }
    }
  }
}

// Fact changes that every consumer must notice.
const Fact kChanges[] = {
    {"ex:fast", "ex:alpha_base", "2.0"},
    {"ex:fast", "ex:beta_poi", "0.7"},
    {"ex:land", "ex:bufferCells", "3"},
    {"ex:zone", "ex:attenuation", "0.3"},
    {"ex:private", "ex:attenuation", "0.2"},
    {"ex:corridor", "ex:edgeKm", "9"},
    {"<http://example.org/mission/fast/prior/corridor>", "ex:beta", "0.9"},
    {"<http://example.org/mission/fast/soft_override/zone>", "ex:attenuation",
     "0.05"},
    {"ex:bloom", "ex:value", "4"},
    {"ex:w0", "ex:confidence", "0.8"},
    {"ex:w1", "ex:confidence", "0.8"},
    {"ex:alpha_capabilities", "ex:cruiseSpeedKts", "0.7"},
    {"ex:alpha_capabilities", "ex:sensorRadiusKm", "7"},
    {"ex:alpha_start", "ex:headingDeg", "10"},
    {"ex:mission", "ex:waypointSpacingKm", "11"},
    {"ex:safe", "ex:alpha_base", "3"},
    {"ex:alpha", "ex:mobility", "\"hover\""},
};

TEST_F(ProvenanceTest, ATensorChangesWithTheFactsItListsAndWithNoOthers) {
  ASSERT_TRUE(
      Add("ex:zone a ex:Constraint ; ex:kind \"soft\" ; ex:name \"zone\" ; "
          "ex:attenuation 0.5 ; ex:appliesIn ex:w0 ; geo:asWKT "
          "\"POLYGON((-91 25.5,-90.8 25.5,-90.8 25.7,-91 25.7,-91 25.5))\" . "
          "ex:private a ex:Constraint ; ex:kind \"soft\" ; ex:attenuation 0.5 "
          "; ex:appliesTo ex:bravo ; geo:asWKT "
          "\"POLYGON((-91 26,-90.8 26,-90.8 26.2,-91 26.2,-91 26))\" . "
          "ex:corridor a ex:PriorLayer ; ex:name \"corridor\" ; geo:asWKT "
          "\"POLYGON((-91 26,-90.5 26,-90.5 26.2,-91 26.2,-91 26))\" . "
          "ex:fast ex:priors '{\"corridor\": 0.8}' ; ex:softOverrides "
          "'{\"zone\": 0.1}' ."));
  int changed = 0, kept = 0;
  for (const Fact& fact : kChanges) {
    const auto before = server_->BeginCycle();
    const std::string subject = kg_core::ParseTurtleTerm(fact.subject).text;
    ASSERT_TRUE(Set(fact)) << fact.subject << " " << fact.property;
    const auto after = server_->BeginCycle();
    for (std::size_t i = 0; i < before->tensors.size(); ++i) {
      const MissionTensor& old = *before->tensors[i];
      const bool lists = std::count(old.derived_from.begin(),
                                    old.derived_from.end(), subject) > 0;
      // The override replaces the zone's own factor.
      const bool is_overridden = fact.subject == "ex:zone";
      const bool differs = old.hash != after->tensors[i]->hash;
      EXPECT_EQ(differs, lists && !is_overridden)
          << fact.subject << " " << fact.property << " " << old.agent_iri
          << " w" << old.window;
      ++(differs ? changed : kept);
    }
  }
  EXPECT_GT(changed, 20);
  EXPECT_GT(kept, 20);
}

TEST_F(ProvenanceTest, VocabularyAndMissionAreLoadedFromFilesWithTheirSha256) {
  EXPECT_EQ(Count("?a a ex:LoadVocabulary ; prov:used ?f . ?f ex:path ?p ; "
                  "ex:sha256 ?s FILTER(STRENDS(?p, \"shapes.ttl\"))"),
            1u);
  EXPECT_EQ(Count("?a a ex:UpdateFacts ; ex:author \"mission.ttl\" ; "
                  "prov:used ?f . ?f a ex:SourceFile ; ex:path ?p ; ex:sha256 "
                  "?s FILTER(STRENDS(?p, \"mission.ttl\"))"),
            1u);
}

TEST_F(ProvenanceTest, AFactThatSaysWhereAnAgentStartsCountsUntilItReports) {
  ASSERT_TRUE(Set({"ex:alpha_start", "geo:asWKT", "\"POINT(-90.95 25.65)\""}));
  EXPECT_NEAR(server_->BeginCycle()->rules.at(0).start.lon_deg, -90.95, 1e-9);
  ASSERT_TRUE(Set({"ex:alpha_capabilities", "ex:energyBudget", "1000"}));
  EXPECT_NEAR(server_->BeginCycle()->rules.at(0).energy_budget_j, 3.6e6, 1.0);
  AgentPose pose;
  pose.position = {-90.7, 25.7};
  pose.time_s = server_->mission().windows[0].begin_s;
  ASSERT_TRUE(server_->Observe("alpha", pose));
  ASSERT_TRUE(Set({"ex:alpha_start", "geo:asWKT", "\"POINT(-90.8 25.65)\""}));
  EXPECT_NEAR(server_->BeginCycle()->rules.at(0).start.lon_deg, -90.7, 1e-9);
}

}  // namespace
}  // namespace kg_engine
