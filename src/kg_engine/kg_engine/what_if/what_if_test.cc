// What-ifs compared with real updates: the same code as the nodes, the same
// updates.

#include "kg_engine/what_if/what_if.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>
#include <thread>

#include "gtest/gtest.h"
#include "kg_base/common/sha256.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_base/common/units.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_engine/planning/agent_planner.h"
#include "kg_engine/planning/team_selector.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/testing/test_mission.h"

namespace kg_engine {
namespace {

using kg_compiler::Compilation;
using kg_core::FactUpdate;

constexpr char kSecondAgent[] = R"ttl(
ex:mission ex:hasAgent ex:bravo .
ex:bravo a ex:Agent ; ex:id "bravo" ; ex:usesPolicy ex:safe ;
    ex:hasCapabilities ex:bravo_capabilities .
ex:bravo_capabilities a ex:AgentCapabilities ; ex:cruiseSpeedKts 0.8 ;
    ex:maxSpeedKts 1.2 ; ex:energyPerKm 3.0 ; ex:hotelLoadW 1.5 ;
    ex:energyBudget 900 ; ex:sensorRadiusKm 6 .
ex:bravo_start a ex:AgentState ; ex:forAgent ex:bravo ; ex:forWindow ex:w0 ;
    geo:asWKT "POINT(-90.87 25.73)"^^geo:wktLiteral .
ex:safe ex:lambda_time 0.15 ; ex:lambda_energy 0.01 ; ex:lambda_risk 0.4 .
ex:fast ex:lambda_time 0.01 ; ex:lambda_energy 0.002 ; ex:lambda_risk 0.1 .
)ttl";

// Plan of the nodes for a compilation, each with its received messages.
class Nodes {
 public:
  Nodes(const Compilation& compilation, std::uint64_t cycle) {
    for (const kg_compiler::SeamRules& rules : compilation.rules) {
      Send(compilation, rules, cycle);
    }
    selector_.KnowRun(0);
    Hear(selector_.Take(ToTeamTask(compilation, cycle)));
    for (auto& [agent, planner] : planners_) {
      const PlannerAnswer answer = planner.Plan();
      for (const AgentGraph& graph : answer.graphs) {
        hashes_[{agent, graph.window()}] = graph.graph->hash;
      }
      Hear(selector_.Take(answer.candidates));
    }
  }

  const kg_selector::CommittedPlan& plan() const { return plan_; }
  const std::map<std::pair<std::string, int>, std::string>& hashes() const {
    return hashes_;
  }

 private:
  void Send(const Compilation& compilation, const kg_compiler::SeamRules& rules,
            std::uint64_t cycle) {
    AgentPlanner& planner = planners_[rules.agent_id];
    for (const auto& field : compilation.fields) planner.Take(field);
    for (const auto& tensor : compilation.tensors) {
      if (tensor->agent_iri == rules.agent_iri) planner.Take(tensor);
    }
    planner.Take(rules, cycle);
    EXPECT_TRUE(planner.IsComplete()) << planner.Missing();
  }

  void Hear(const SelectorAnswer& said) {
    if (said.plan) plan_ = *said.plan;
    if (!said.request) return;
    for (auto& [agent, planner] : planners_) {
      const auto answer = planner.PlanAgain(*said.request);
      if (answer) Hear(selector_.Take(answer->candidates));
    }
  }

  std::map<std::string, AgentPlanner> planners_;
  TeamSelector selector_;
  std::map<std::pair<std::string, int>, std::string> hashes_;
  kg_selector::CommittedPlan plan_;
};

void ExpectSamePlan(const kg_selector::CommittedPlan& a,
                    const kg_selector::CommittedPlan& b) {
  EXPECT_EQ(a.unassigned, b.unassigned);
  EXPECT_NEAR(a.reward, b.reward, 1e-9);
  EXPECT_NEAR(a.seam_cost, b.seam_cost, 1e-9);
  ASSERT_EQ(a.assignments.size(), b.assignments.size());
  for (std::size_t i = 0; i < a.assignments.size(); ++i) {
    EXPECT_EQ(a.assignments[i].pathlet.agent, b.assignments[i].pathlet.agent);
    EXPECT_EQ(a.assignments[i].pathlet.visits, b.assignments[i].pathlet.visits);
  }
}

std::vector<std::string> Lines(const std::vector<RecompiledArtifact>& dirty) {
  std::vector<std::string> lines;
  for (const RecompiledArtifact& one : dirty) {
    lines.push_back(one.kind + " " + one.agent + " " +
                    std::to_string(one.window) + " " + one.hash);
  }
  return lines;
}

std::string DigestOf(const kg_core::GraphView& view) {
  std::set<std::string> lines;
  view.Match({}, [&](const kg_core::Quad& quad) {
    std::string line;
    for (const kg_core::TermId id :
         {quad.subject, quad.predicate, quad.object, quad.graph}) {
      line += kg_core::ToTurtle(view.Get(id)) + " ";
    }
    lines.insert(line);
    return true;
  });
  EXPECT_GT(lines.size(), 100u);
  kg_base::Hasher hash;
  for (const std::string& line : lines) hash.Add(line);
  return hash.Hex();
}

std::string ReadFile(const std::string& path) {
  std::ifstream file(path);
  EXPECT_TRUE(file) << path;
  return {std::istreambuf_iterator<char>(file), {}};
}

class WhatIfTest : public testing::Test {
 protected:
  WhatIfTest() {
    folders_.mission = folder_ / "mission";
    folders_.state = folder_ / "state";
    folders_.ontology = "../kg_mission/ontology";
    WriteTestMission(folders_.mission);
    server_ = std::make_unique<MissionServer>(folders_);
    what_if_ = std::make_unique<WhatIf>(server_->files());
    FactUpdate more;
    more.turtle = kSecondAgent;
    const Decision decision = server_->Apply(more);
    EXPECT_TRUE(decision.accepted) << testing::PrintToString(decision.reasons);
  }

  static FactUpdate Set(const std::string& subject, const std::string& property,
                        const std::string& value) {
    FactUpdate update;
    update.set = {{subject, property, value}};
    return update;
  }

  WhatIfAnswer Ask(const FactUpdate& update, const std::string& query = "") {
    return what_if_->Ask(server_->present(), {update, query, 0.0});
  }

  Nodes PlanReally() {
    compilation_ = server_->BeginCycle();
    return Nodes(*compilation_, server_->cycle());
  }

  // A random plausible change; some are rejected, some have no effect.
  FactUpdate AnyUpdate(std::mt19937& rng) {
    const auto pick = [&](std::vector<std::string> of) {
      return of[std::uniform_int_distribution<std::size_t>(0,
                                                           of.size() - 1)(rng)];
    };
    switch (std::uniform_int_distribution<int>(0, 6)(rng)) {
      case 0:
        return Set(pick({"ex:alpha", "ex:bravo"}), "ex:usesPolicy",
                   pick({"ex:fast", "ex:safe", "ex:nobody"}));
      case 1:
        return Set(pick({"ex:w0", "ex:w1"}), "ex:confidence",
                   pick({"0.5", "0.8", "1.0", "1.5"}));
      case 2:
        return Set(pick({"ex:alpha_capabilities", "ex:bravo_capabilities"}),
                   "ex:energyBudget", pick({"20", "120", "900", "5000"}));
      case 3:
        return Set(pick({"ex:fast", "ex:safe"}),
                   pick({"ex:lambda_risk", "ex:gamma_front"}),
                   pick({"0", "0.3", "0.9"}));
      case 4:
        return Set("ex:bloom", "ex:capacity", pick({"1", "2"}));
      case 5:
        return Set("ex:mission", "ex:minimumSeparationKm",
                   pick({"0", "2", "15"}));
      default: {
        FactUpdate area;
        area.turtle =
            "ex:reef a ex:Constraint ; ex:kind \"no_go\" ; geo:asWKT "
            "\"POLYGON((-90.8 25.5, -90.6 25.5, -90.6 25.9, -90.8 25.9, "
            "-90.8 25.5))\"^^geo:wktLiteral .";
        return area;
      }
    }
  }

  kg_base::TemporaryFolder folder_;
  MissionFolders folders_;
  std::unique_ptr<MissionServer> server_;
  std::unique_ptr<WhatIf> what_if_;
  std::shared_ptr<const Compilation> compilation_;
};

TEST_F(WhatIfTest, PlansInProcessWhatTheNodesCommit) {
  std::mt19937 rng(11);
  for (int i = 0; i < 12; ++i) {
    const Nodes nodes = PlanReally();
    const kg_selector::PlannedMission planned =
        kg_selector::PlanMission(*compilation_, nullptr);
    ExpectSamePlan(kg_selector::ToCommittedPlan(planned), nodes.plan());
    std::map<std::pair<std::string, int>, std::string> hashes;
    for (const kg_selector::TeamMember& member : planned.members) {
      for (const kg_compiler::NavGraph& graph : member.graphs) {
        hashes[{NameOf(member), graph.window}] = graph.hash;
      }
    }
    EXPECT_FALSE(hashes.empty());
    EXPECT_EQ(hashes, nodes.hashes());
    server_->Apply(AnyUpdate(rng));
    AgentPose pose;
    pose.position = {-90.9 + 0.0123 * i, 25.7 + 0.00345 * i};
    pose.time_s = server_->mission().windows[0].begin_s + 3000.0 * i;
    server_->Observe(i % 2 == 0 ? "alpha" : "bravo", pose);
  }
}

TEST_F(WhatIfTest, ForeseesWhatARealUpdateBrings) {
  std::mt19937 rng(5);
  int accepted = 0;
  int refused = 0;
  PlanReally();
  for (int i = 0; i < 40; ++i) {
    const FactUpdate update = AnyUpdate(rng);
    const std::uint64_t version = server_->world_version();
    const WhatIfAnswer foreseen = Ask(update);
    EXPECT_EQ(foreseen.world_version, version);
    const Decision decision = server_->Apply(update);
    EXPECT_EQ(foreseen.errors, decision.reasons);
    EXPECT_EQ(foreseen.ok, decision.accepted);
    ++(decision.accepted ? accepted : refused);
    if (!decision.accepted) continue;
    const Nodes nodes = PlanReally();
    EXPECT_EQ(Lines(foreseen.dirty), Lines(ListRecompiled(*compilation_)));
    ExpectSamePlan(foreseen.plan, nodes.plan());
  }
  EXPECT_GT(accepted, 20);
  EXPECT_GT(refused, 2);
}

TEST_F(WhatIfTest, LeavesTheWorldAsItIs) {
  PlanReally();
  const std::string before = DigestOf(*server_->Read());
  const std::uint64_t version = server_->world_version();
  const std::string query = "SELECT * { ?edge a ex:TraverseEdge }";
  EXPECT_TRUE(Ask(Set("ex:alpha", "ex:usesPolicy", "ex:safe"), query).ok);
  EXPECT_FALSE(Ask(Set("ex:w0", "ex:confidence", "1.2")).ok);
  EXPECT_FALSE(Ask(Set("ex:alpha", "ex:usesPolicy", "ex:safe"), "SELEKT").ok);
  EXPECT_FALSE(Ask(Set("ex:currents", "ex:file", "\"absent.nc\"")).ok);
  const WhatIfAnswer late =
      what_if_->Ask(server_->present(),
                    {Set("ex:alpha", "ex:usesPolicy", "ex:safe"), "", 1e-9});
  EXPECT_FALSE(late.ok);
  EXPECT_NE(late.errors.at(0).find("time limit"), std::string::npos);
  EXPECT_EQ(DigestOf(*server_->Read()), before);
  EXPECT_EQ(server_->world_version(), version);
  EXPECT_TRUE(server_->BeginCycle()->dirty.empty());
}

TEST_F(WhatIfTest, AnUpdateThatChangesNothingMakesNoDifference) {
  PlanReally();
  for (const FactUpdate& update :
       {FactUpdate(), Set("ex:alpha", "ex:usesPolicy", "ex:fast")}) {
    const WhatIfAnswer answer = Ask(update);
    EXPECT_TRUE(answer.ok);
    EXPECT_TRUE(answer.dirty.empty());
    EXPECT_EQ(answer.reward_change, 0.0);
    EXPECT_EQ(answer.energy_change_j, 0.0);
    EXPECT_GT(answer.edges, 0u);
    EXPECT_EQ(
        answer.edges_infeasible + answer.edges_dearer + answer.edges_cheaper,
        0u);
    EXPECT_TRUE(answer.changed_edges.empty());
    ASSERT_EQ(answer.paths.size(), 2u);
    for (const PathChange& path : answer.paths) {
      EXPECT_FALSE(path.changed);
      EXPECT_EQ(path.infeasible, "");
      EXPECT_NEAR(path.energy_needed_j, path.before.energy_j, 1e-6);
    }
  }
}

TEST_F(WhatIfTest, EveryEdgeIsCountedOnceAndPricedAsItIsListed) {
  PlanReally();
  const WhatIfAnswer answer =
      Ask(Set("ex:fast", "ex:lambda_energy", "0.02"),
          "SELECT ?edge ?now ?then { "
          "GRAPH <http://example.org/mission/graph/plan/present> "
          "{ ?a ex:forEdge ?edge ; ex:seamCost ?now } "
          "GRAPH <http://example.org/mission/graph/plan/repriced> "
          "{ ?b ex:forEdge ?edge ; ex:seamCost ?then } "
          "FILTER(?now != ?then) }");
  ASSERT_TRUE(answer.ok) << answer.text;
  // Alpha's edges only; energy costs ten times as much; nothing else changes.
  EXPECT_GT(answer.edges_dearer, 0u);
  EXPECT_EQ(answer.edges_infeasible + answer.edges_cheaper, 0u);
  EXPECT_EQ(answer.changed_edges.size(), answer.edges_dearer);
  for (const EdgeChange& edge : answer.changed_edges) {
    EXPECT_EQ(edge.agent, "alpha");
    // Higher prices reduce energy use; the optimal flight at one price costs at
    // most as much as any other flight at that price.
    const double dearer_per_j = 0.018 / kg_base::kJoulesPerWh;
    // Isolation is priced after the flight is chosen.
    const double isolation = 0.1 / kg_base::kSecondsPerHour *
                             (edge.after.isolation_s - edge.before.isolation_s);
    const double rise =
        edge.after.seam_cost - edge.before.seam_cost - isolation;
    // Tolerance of the search.
    const double slack = 1e-3 * edge.after.seam_cost;
    EXPECT_LE(edge.after.energy_j, edge.before.energy_j * 1.001);
    EXPECT_GE(rise, dearer_per_j * edge.after.energy_j - slack);
    EXPECT_LE(rise, dearer_per_j * edge.before.energy_j + slack);
    EXPECT_NE(answer.result.find(edge.edge), std::string::npos);
  }
}

TEST_F(WhatIfTest, AnotherStartHeadingRepricesTheEdgesThatLeaveTheStart) {
  ASSERT_TRUE(server_->Apply(Set("ex:fast", "ex:lambda_turn", "0.5")).accepted);
  PlanReally();
  const WhatIfAnswer answer =
      Ask(Set("ex:alpha_start", "ex:headingDeg", "270"));
  ASSERT_TRUE(answer.ok) << answer.text;
  EXPECT_GT(answer.edges_dearer, 0u);
  EXPECT_GT(answer.edges_cheaper, 0u);
  EXPECT_EQ(answer.edges_infeasible, 0u);
  for (const EdgeChange& edge : answer.changed_edges) {
    EXPECT_EQ(edge.agent, "alpha");
    EXPECT_EQ(edge.window, 0);
    // From 90 to 270 degrees: what was a turn is the rest of half a circle.
    EXPECT_NEAR(edge.before.turn_rad + edge.after.turn_rad, kg_base::kPi, 1e-9);
    EXPECT_NEAR(edge.after.seam_cost - edge.before.seam_cost,
                0.5 * (edge.after.turn_rad - edge.before.turn_rad), 1e-9);
  }
}

TEST_F(WhatIfTest, AnAreaThatIsClosedMakesEdgesAndPathsInfeasible) {
  PlanReally();
  const WhatIfAnswer now = Ask(FactUpdate());
  const kg_selector::Visit stop = now.paths[0].before.visits[0];
  const double lon = stop.position.lon_deg;
  const double lat = stop.position.lat_deg;
  const auto point = [](double x, double y) {
    return std::to_string(x) + " " + std::to_string(y);
  };
  FactUpdate area;
  area.turtle =
      "ex:reef a ex:Constraint ; ex:kind \"no_go\" ; geo:asWKT \"POLYGON((" +
      point(lon - .06, lat - .06) + ", " + point(lon + .06, lat - .06) + ", " +
      point(lon + .06, lat + .06) + ", " + point(lon - .06, lat + .06) + ", " +
      point(lon - .06, lat - .06) + "))\"^^geo:wktLiteral .";
  const WhatIfAnswer answer = Ask(area);
  ASSERT_TRUE(answer.ok || !answer.paths.empty()) << answer.text;
  EXPECT_GT(answer.edges_infeasible, 0u);
  EXPECT_TRUE(answer.changed_edges.at(0).infeasible);
  const kg_compiler::EdgeCost& none = answer.changed_edges.at(0).after;
  for (const double number :
       {none.travel_s, none.energy_j, none.hazard_s, none.isolation_s,
        none.through_water_m, none.speed_mps, none.turn_rad, none.seam_cost}) {
    EXPECT_TRUE(std::isnan(number));
  }
  EXPECT_NE(answer.paths[0].infeasible.find("cannot be flown"),
            std::string::npos)
      << answer.text;
  EXPECT_TRUE(std::isnan(answer.paths[0].energy_needed_j));
}

// The paper's first question, with the shipped files.
TEST_F(WhatIfTest, ReportsPathsInfeasibleUnderALowerBudget) {
  PlanReally();
  const std::string folder = "../../config/queries/what_if_energy_budget";
  FactUpdate less;
  less.sparql = ReadFile(folder + ".ru");
  // Bravo's budget is its need plus 10 %, so that 30 % less is insufficient.
  const WhatIfAnswer now = Ask(FactUpdate());
  const double needed_wh =
      now.paths.at(1).before.energy_j / kg_base::kJoulesPerWh;
  server_->Apply(Set("ex:bravo_capabilities", "ex:energyBudget",
                     std::to_string(1.1 * needed_wh)));
  const WhatIfAnswer answer = Ask(less, ReadFile(folder + ".rq"));
  ASSERT_TRUE(answer.ok) << answer.text;
  EXPECT_EQ(answer.paths[0].infeasible, "");
  EXPECT_NE(answer.paths[1].infeasible, "");
  EXPECT_NEAR(answer.paths[1].energy_budget_j,
              0.77 * now.paths[1].before.energy_j, 0.01);
  EXPECT_NE(answer.result.find("\"bravo\""), std::string::npos);
  EXPECT_EQ(answer.result.find("\"alpha\""), std::string::npos);
  // The query's sum over facts equals the value in the plan.
  EXPECT_NE(answer.text.find(std::to_string(needed_wh).substr(0, 5)),
            std::string::npos)
      << answer.text;
  EXPECT_LE(answer.paths[1].after.energy_j, answer.paths[1].energy_budget_j);
}

// The second one: the query's rows are those of the answer's own list.
TEST_F(WhatIfTest, ReportsEdgesThatBecomeTooCostly) {
  PlanReally();
  const std::string folder = "../../config/queries/what_if_too_costly";
  FactUpdate safe;
  safe.sparql = ReadFile(folder + ".ru");
  const WhatIfAnswer answer = Ask(safe, ReadFile(folder + ".rq"));
  ASSERT_TRUE(answer.ok) << answer.text;
  std::size_t wanted = 0;
  for (const EdgeChange& edge : answer.changed_edges) {
    const bool too_costly = edge.before.seam_cost <= 2.0 &&
                            (edge.infeasible || edge.after.seam_cost > 2.0);
    if (too_costly) {
      ++wanted;
      EXPECT_EQ(edge.agent, "alpha");
    }
    EXPECT_EQ(answer.result.find(edge.edge + "\"") != std::string::npos,
              too_costly);
  }
  EXPECT_GT(wanted, 0u);
}

TEST_F(WhatIfTest, FactsAndCyclesGoOnMeanwhile) {
  PlanReally();
  std::thread asking([&] {
    for (int i = 0; i < 6; ++i) {
      const Present present = server_->present();
      const WhatIfAnswer answer = what_if_->Ask(
          present, {Set("ex:alpha", "ex:usesPolicy", "ex:safe"), "", 0.0});
      EXPECT_TRUE(answer.ok) << answer.text;
      EXPECT_EQ(answer.world_version, present.facts->world_version());
      EXPECT_EQ(answer.plan.assignments.size(), 2u);
    }
  });
  const std::uint64_t before = server_->world_version();
  for (int i = 0; i < 12; ++i) {
    EXPECT_TRUE(
        server_
            ->Apply(Set("ex:w1", "ex:confidence", i % 2 == 0 ? "0.7" : "0.8"))
            .accepted);
    server_->BeginCycle();
  }
  EXPECT_EQ(server_->world_version(), before + 12);
  asking.join();
}

}  // namespace
}  // namespace kg_engine
