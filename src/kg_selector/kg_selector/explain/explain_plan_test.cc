#include "kg_selector/explain/explain_plan.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"
#include "kg_compiler/explain/explain_tensor.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/store.h"
#include "kg_selector/explain/path_terms.h"
#include "kg_selector/paths/masking.h"
#include "kg_selector/testing/planned_test_world.h"

namespace kg_selector {
namespace {

using kg_compiler::Explanation;
using kg_compiler::NavGraph;

void ExpectSums(const Explanation& explanation) {
  EXPECT_NEAR(explanation.value, explanation.Sum(), 1e-9) << explanation.text;
  EXPECT_FALSE(explanation.parts.empty()) << explanation.text;
  EXPECT_FALSE(explanation.unit.empty()) << explanation.text;
  EXPECT_FALSE(explanation.text.empty());
}

PlanQuestion About(QuestionKind what, const std::string& agent, int window) {
  PlanQuestion question;
  question.what = what;
  question.agent = agent;
  question.window = window;
  return question;
}

// --- Reference: every path of a member by exhaustive search, around the paths
// committed before it. ---

class EveryPath {
 public:
  // Waypoints visited, by stage; the last is where the window ends.
  using Stops = std::vector<std::vector<int>>;
  using Accepts = std::function<bool(const Stops&)>;
  EveryPath(const PlannedWorld& world, const TeamMember& member)
      : world_(world),
        member_(member),
        before_(CommittedBefore(world, member.rules.agent_iri)),
        full_(FullEvents(world.rules, before_)) {
    for (const auto& window : member.rules.windows) {
      for (const auto& event : window.events) {
        if (full_.count(event.iri) == 0) {
          open_[window.window][event.iri] = event.reward;
        }
      }
    }
  }

  // Best score of accepted paths that break no rule.
  std::optional<double> Best(const Accepts& accepts) {
    best_.reset();
    accepts_ = &accepts;
    stops_.clear();
    Extend(0.0, 0.0, {});
    return best_;
  }

 private:
  void Extend(double score, double energy_j,
              std::vector<kg_compiler::TimedPoint> track) {
    const std::size_t s = stops_.size();
    if (s == member_.graphs.size()) {
      const double whole = score + EventReward();
      if (energy_j <= member_.rules.energy_budget_j && (*accepts_)(stops_) &&
          (!best_ || whole > *best_) && IsApart(track)) {
        best_ = whole;
      }
      return;
    }
    for (const auto& edge : member_.graphs[s].edges) {
      if (edge.from != (s == 0 ? 0 : stops_.back().back())) continue;
      auto longer = track;
      longer.insert(longer.end(), edge.flight.track.begin(),
                    edge.flight.track.end());
      stops_.push_back(StopsOf(edge));
      double more = -edge.seam_cost;
      for (const int stop : stops_.back()) {
        more += member_.graphs[s].waypoints[stop].score;
      }
      Extend(score + more, energy_j + edge.flight.energy_j, std::move(longer));
      stops_.pop_back();
    }
  }

  double EventReward() const {
    std::map<std::string, double> best;
    for (std::size_t s = 0; s < stops_.size(); ++s) {
      const NavGraph& graph = member_.graphs[s];
      const auto open = open_.find(graph.window);
      if (open == open_.end()) continue;
      for (const int stop : stops_[s]) {
        for (const std::string& event : graph.waypoints[stop].events) {
          if (open->second.count(event)) {
            best[event] = std::max(best[event], open->second.at(event));
          }
        }
      }
    }
    double sum = 0.0;
    for (const auto& [event, reward] : best) sum += reward;
    return sum;
  }

  bool IsApart(const std::vector<kg_compiler::TimedPoint>& track) const {
    Pathlet pathlet;
    pathlet.track = track;
    for (const NavGraph& graph : member_.graphs) {
      pathlet.visits.push_back({graph.window, 0, {}, 0.0, {}});
    }
    return !FindConflict(world_.rules, before_, pathlet);
  }

  const PlannedWorld& world_;
  const TeamMember& member_;
  std::vector<Pathlet> before_;
  std::set<std::string> full_;
  std::map<int, std::map<std::string, double>> open_;
  const Accepts* accepts_ = nullptr;
  Stops stops_;
  std::optional<double> best_;
};

// Every feasible world of the first seeds; every third in mode "edges".
void ForEachWorld(int seeds,
                  const std::function<void(const PlannedWorld&)>& f) {
  int planned = 0;
  for (int seed = 1; seed <= seeds; ++seed) {
    PlannedTestWorld random(seed);
    if (seed % 3 == 0) random.mission.coordination.movement_mode = "edges";
    try {
      const PlannedWorld world = random.Plan();
      f(world);
      ++planned;
    } catch (const kg_base::InputError&) {  // An agent starts in a no-go area.
    }
  }
  EXPECT_GT(planned, seeds / 2);
}

// Replanned with commitments to stay at the start.
PlannedWorld Bound(PlannedWorld world) {
  for (TeamMember& member : world.members) {
    member.rules.churn_weight = 1.5;
    for (auto& window : member.rules.windows) {
      window.committed = member.rules.start;
    }
  }
  world.plan = PlanTeam(world.rules, world.members);
  NameAgentsByIri(&world);
  return world;
}

TEST(ExplainPlan, LeavingThePlanInForceIsATermOfItsOwn) {
  int charged = 0;
  ForEachWorld(8, [&](const PlannedWorld& free) {
    const PlannedWorld world = Bound(free);
    for (const Pathlet& path : world.plan.committed) {
      double sum = 0.0;
      for (const Visit& visit : path.visits) {
        const Explanation step = Explain(
            world, About(QuestionKind::kAssignment, path.agent, visit.window));
        ExpectSums(step);
        sum += step.value;
        charged += std::count_if(
            step.parts.begin(), step.parts.end(), [](const auto& part) {
              return part.term == "-churn" && part.value < 0.0;
            });
      }
      const Explanation whole =
          Explain(world, About(QuestionKind::kAssignment, path.agent, -1));
      ExpectSums(whole);
      EXPECT_NEAR(path.score(), whole.value, 1e-9);
      EXPECT_NEAR(sum, whole.value, 1e-9);
    }
  });
  EXPECT_GT(charged, 10);
}

// Plans of random missions in which turns at the start are dear.
TEST(ExplainPlan, TheTurnAtTheStartIsATermOfItsOwn) {
  int turns = 0, with_stops = 0;
  for (unsigned seed = 2; seed <= 12; ++seed) {
    PlannedTestWorld random(seed);
    if (seed % 2 == 0) random.mission.coordination.movement_mode = "edges";
    for (kg_mission::Agent& agent : random.mission.agents) {
      agent.policy.lambda_turn_per_rad = 3.0;
      agent.start_heading_rad = kg_compiler::Uniform(random.rng(), 0.0, 6.0);
    }
    const PlannedWorld world = random.Plan();
    for (const Pathlet& path : world.plan.committed) {
      const kg_mission::Agent& agent = FindAgent(world, path.agent);
      const auto terms = ListTerms(world, FindMember(world, agent), path);
      EXPECT_NEAR(path.score(), Sum(terms), 1e-9);
      for (const PathTerm& term : terms) {
        if (term.kind != TermKind::kTurn) continue;
        const double turn_rad =
            term.window == 0 ? path.visits[0].cost.turn_rad : 0.0;
        EXPECT_EQ(-3.0 * turn_rad, term.value);
        turns += turn_rad > 0.0;
        with_stops += turn_rad > 0.0 && !path.visits[0].via.empty();
      }
      ExpectSums(
          Explain(world, About(QuestionKind::kAssignment, path.agent, 0)));
    }
  }
  EXPECT_GT(turns, 10);
  EXPECT_GT(with_stops, 0);
}

TEST(ExplainPlan, AssignmentsSumToTheStepsAndStepsToThePath) {
  int steps = 0, with_stops = 0;
  ForEachWorld(8, [&](const PlannedWorld& world) {
    for (const Pathlet& path : world.plan.committed) {
      const TeamMember& member =
          FindMember(world, FindAgent(world, path.agent));
      double sum = 0.0;
      for (std::size_t s = 0; s < path.visits.size(); ++s) {
        const Visit& visit = path.visits[s];
        const Explanation step = Explain(
            world, About(QuestionKind::kAssignment, path.agent, visit.window));
        ExpectSums(step);
        EXPECT_NEAR(visit.reward - EdgeTaken(member, path, s).seam_cost,
                    step.value, 1e-9);
        with_stops += !visit.via.empty();
        for (const auto& part : step.parts) {
          if (part.term == "rounding") {
            EXPECT_LT(std::abs(part.value), 2e-5);
          }
        }
        sum += step.value;
        ++steps;
      }
      const Explanation whole =
          Explain(world, About(QuestionKind::kAssignment, path.agent, -1));
      ExpectSums(whole);
      EXPECT_NEAR(path.score(), whole.value, 1e-9);
      EXPECT_NEAR(sum, whole.value, 1e-9);
    }
  });
  EXPECT_GT(steps, 30);
  EXPECT_GT(with_stops, 5);
}

// Events whose IRIs are prefixes of one another, abbreviated and in full.
TEST(ExplainPlan, AnEventsTermCitesTheEventsEarnedAndNoOthers) {
  const std::string ex = kg_core::kEx;
  const std::vector<std::string> iris = {ex + "ember_10", ex + "ember_1",
                                         "http://sites.org/spot/north",
                                         "http://sites.org/spot"};
  kg_core::Store store("");
  kg_core::Transaction change = store.Begin();
  for (const std::string& iri : iris) {
    change.Add({kg_core::Iri(iri), kg_core::Iri(ex + "capacity"),
                kg_core::IntegerLiteral(1),
                kg_core::Iri(kg_core::kFactsGraph)});
  }
  change.Commit(kg_core::WorldChange::kYes);
  std::map<std::string, int> earned;
  for (unsigned seed = 1; seed <= 8; ++seed) {
    PlannedTestWorld random(seed);
    for (std::size_t i = 0; i < iris.size(); ++i) {
      random.mission.events[i].iri = iris[i];
    }
    PlannedWorld world = random.Plan();
    world.view = store.Read();
    for (const Pathlet& path : world.plan.committed) {
      const kg_mission::Agent& agent = FindAgent(world, path.agent);
      for (const PathTerm& term :
           ListTerms(world, FindMember(world, agent), path)) {
        if (term.kind != TermKind::kEvents) continue;
        std::set<std::string> expected;
        for (const Visit& visit : path.visits) {
          if (visit.window != term.window) continue;
          for (const std::string& iri : visit.events) {
            ++earned[iri];
            for (const std::string& fact : world.facts().Event(iri)) {
              expected.insert(fact);
            }
          }
        }
        const auto facts = TermFacts(world, agent, term);
        EXPECT_EQ(expected, std::set<std::string>(facts.begin(), facts.end()));
      }
    }
  }
  EXPECT_GT(earned[iris[0]], 0);
  EXPECT_GT(earned[iris[2]], 0);
}

TEST(ExplainPlan, EdgesSumToTheirSeamCosts) {
  ForEachWorld(4, [](const PlannedWorld& world) {
    for (const TeamMember& member : world.members) {
      for (const NavGraph& graph : member.graphs) {
        for (const auto& edge : graph.edges) {
          PlanQuestion question =
              About(QuestionKind::kEdge, member.rules.agent_id, graph.window);
          question.from = edge.from;
          question.to = edge.to;
          question.via = edge.via;
          const Explanation explanation = Explain(world, question);
          ExpectSums(explanation);
          EXPECT_EQ(edge.seam_cost, explanation.value);
        }
      }
    }
  });
}

TEST(ExplainPlan, RejectionsSumToTheirMargins) {
  int separations = 0, capacities = 0;
  ForEachWorld(20, [&](const PlannedWorld& world) {
    for (std::size_t i = 0; i < world.plan.rejections.size(); ++i) {
      PlanQuestion question = About(QuestionKind::kRejection, "", -1);
      question.id = std::to_string(i);
      const Explanation explanation = Explain(world, question);
      ExpectSums(explanation);
      const Conflict& conflict = world.plan.rejections[i].conflict;
      EXPECT_EQ(conflict.margin, explanation.value);
      const bool is_capacity = conflict.kind == ConflictKind::kCapacity;
      ++(is_capacity ? capacities : separations);
      if (!is_capacity) continue;
      EXPECT_EQ(1.0, explanation.parts[0].value);   // Capacity 1,
      EXPECT_EQ(-1.0, explanation.parts[1].value);  // one used.
    }
  });
  EXPECT_GT(separations, 3);
  EXPECT_GT(capacities, 3);
}

TEST(ExplainPlan, PathsTurnedAwayForOtherReasonsSumToTheirMargins) {
  ForEachWorld(3, [](const PlannedWorld& planned) {
    if (planned.plan.committed.empty()) return;
    PlannedWorld world = planned;
    const Pathlet& path = world.plan.committed.front();
    const std::map<ConflictKind, double> margins = {
        {ConflictKind::kEnergy, 360.0},
        {ConflictKind::kExpired, 2.0},
        {ConflictKind::kOutbid, 0.5}};
    for (const auto& [kind, margin] : margins) {
      Conflict conflict{kind, "", -1, "", margin};
      world.plan.rejections = {{path, conflict, conflict.Line(), 1}};
      PlanQuestion question = About(QuestionKind::kRejection, "", -1);
      question.id = "0";
      const Explanation explanation = Explain(world, question);
      ExpectSums(explanation);
      EXPECT_EQ(margin, explanation.value);
      EXPECT_EQ(Name(kind), explanation.verdict);
      EXPECT_EQ(kind, ParseConflictKind(Name(kind)));
    }
  });
}

TEST(ExplainPlan, TensorCellsAreTheCompiledOnes) {
  ForEachWorld(3, [](const PlannedWorld& world) {
    for (const auto& tensor : world.compilation->tensors) {
      for (int i = 0; i < static_cast<int>(tensor->grid.size()); i += 7) {
        PlanQuestion question =
            About(QuestionKind::kTensorCell, tensor->agent_iri, tensor->window);
        const int cols = tensor->grid.cols();
        question.place = tensor->grid.Centre({i / cols, i % cols});
        const Explanation explanation = Explain(world, question);
        ExpectSums(explanation);
        const double compiled = tensor->At(kg_compiler::Layer::kFused, i);
        EXPECT_NEAR(compiled, explanation.value, 2e-7);
      }
    }
  });
}

TEST(ExplainPlan, WaypointVerdictsAreThoseOfExhaustion) {
  std::map<std::string, int> verdicts;
  ForEachWorld(12, [&](const PlannedWorld& world) {
    for (const Pathlet& path : world.plan.committed) {
      const TeamMember& member =
          FindMember(world, FindAgent(world, path.agent));
      EveryPath every(world, member);
      for (std::size_t s = 0; s < member.graphs.size(); ++s) {
        for (const auto& waypoint : member.graphs[s].waypoints) {
          PlanQuestion question = About(QuestionKind::kWaypoint, path.agent,
                                        member.graphs[s].window);
          question.to = waypoint.id;
          const Explanation explanation = Explain(world, question);
          ++verdicts[explanation.verdict];
          ExpectSums(explanation);
          const auto visits = [&](const std::vector<int>& stops) {
            return std::count(stops.begin(), stops.end(), waypoint.id) > 0;
          };
          const auto best = every.Best(
              [&](const EveryPath::Stops& stops) { return visits(stops[s]); });
          EXPECT_EQ(visits(StopsOf(path.visits[s])),
                    explanation.verdict == "taken");
          if (explanation.verdict == "taken") continue;
          ASSERT_EQ(best.has_value(), explanation.verdict == "worth_less")
              << explanation.text;
          if (!best) continue;
          EXPECT_NEAR(path.score() - *best, explanation.value, 1e-9);
          EXPECT_GE(explanation.value, -1e-9);
        }
      }
    }
  });
  EXPECT_GT(verdicts["taken"], 50);
  EXPECT_GT(verdicts["worth_less"], 100);
}

TEST(ExplainPlan, StatesTheEnergyMissingInTheBudget) {
  int lacking = 0;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    PlannedTestWorld random(seed);
    const PlannedWorld rich = random.Plan();
    // Energy of the cheapest path, plus a margin.
    double least_j = std::numeric_limits<double>::infinity();
    std::function<void(std::size_t, int, double)> walk =
        [&](std::size_t s, int from, double energy_j) {
          const auto& graphs = rich.members[0].graphs;
          if (s == graphs.size()) {
            least_j = std::min(least_j, energy_j);
            return;
          }
          for (const auto& edge : graphs[s].edges) {
            if (edge.from == from) {
              walk(s + 1, edge.to, energy_j + edge.flight.energy_j);
            }
          }
        };
    walk(0, 0, 0.0);
    random.mission.agents[0].capabilities.energy_budget_j = least_j * 1.02;
    const PlannedWorld world = random.Plan();
    if (FindPath(world, "ex:alpha") == nullptr) continue;
    for (const NavGraph& graph : world.members[0].graphs) {
      for (const auto& waypoint : graph.waypoints) {
        PlanQuestion question =
            About(QuestionKind::kWaypoint, "alpha", graph.window);
        question.to = waypoint.id;
        const Explanation explanation = Explain(world, question);
        ExpectSums(explanation);
        if (explanation.verdict != "energy") continue;
        EXPECT_EQ("J", explanation.unit);
        EXPECT_GT(explanation.value, 0.0);
        ++lacking;
      }
    }
  }
  EXPECT_GT(lacking, 8);
}

TEST(ExplainPlan, EventVerdictsAreThoseOfExhaustion) {
  std::map<std::string, int> verdicts;
  ForEachWorld(10, [&](const PlannedWorld& world) {
    for (const Pathlet& path : world.plan.committed) {
      const TeamMember& member =
          FindMember(world, FindAgent(world, path.agent));
      EveryPath every(world, member);
      for (const kg_mission::Event& event : world.compilation->mission.events) {
        PlanQuestion question = About(QuestionKind::kEvent, path.agent, -1);
        question.id = event.iri;
        const Explanation explanation = Explain(world, question);
        ++verdicts[explanation.verdict];
        ExpectSums(explanation);
        const bool is_taken = std::any_of(
            path.visits.begin(), path.visits.end(), [&](const Visit& visit) {
              return std::count(visit.events.begin(), visit.events.end(),
                                event.iri) > 0;
            });
        EXPECT_EQ(is_taken, explanation.verdict == "taken");
        if (is_taken) continue;
        const auto full =
            FullEvents(world.rules, CommittedBefore(world, path.agent));
        ASSERT_EQ(full.count(event.iri) > 0, explanation.verdict == "capacity");
        if (explanation.verdict == "capacity") {
          EXPECT_EQ(-1.0, explanation.value);
          continue;
        }
        const auto best = every.Best([&](const EveryPath::Stops& stops) {
          for (std::size_t s = 0; s < stops.size(); ++s) {
            if (std::count(event.windows.begin(), event.windows.end(),
                           member.graphs[s].window) == 0) {
              continue;
            }
            for (const int stop : stops[s]) {
              const auto& events = member.graphs[s].waypoints[stop].events;
              if (std::count(events.begin(), events.end(), event.iri) > 0) {
                return true;
              }
            }
          }
          return false;
        });
        ASSERT_EQ(best.has_value(), explanation.verdict == "worth_less")
            << explanation.text;
        if (best) {
          EXPECT_NEAR(path.score() - *best, explanation.value, 1e-9);
        }
      }
    }
  });
  EXPECT_GT(verdicts["taken"], 5);
  EXPECT_GT(verdicts["capacity"], 2);
  EXPECT_GT(verdicts["worth_less"], 2);
}

TEST(ExplainPlan, AnEventOutOfItsTimeMissesTheWindowByItsDistance) {
  PlannedTestWorld random(2);
  random.mission.events = {{"ex:late", {-90.5, 24.5}, 2.0, 1, 9000.0, {2}},
                           {"ex:early", {-90.5, 24.5}, 2.0, 1, 9000.0, {0}}};
  for (auto& event : random.mission.events) event.value = 0.0;
  const PlannedWorld world = random.Plan();
  PlanQuestion question = About(QuestionKind::kEvent, "alpha", 0);
  question.id = "ex:late";
  Explanation explanation = Explain(world, question);
  EXPECT_EQ("not_active", explanation.verdict);
  EXPECT_EQ(2 * 86400.0, explanation.value);
  ExpectSums(explanation);
  question = About(QuestionKind::kEvent, "alpha", 2);
  question.id = "ex:early";
  explanation = Explain(world, question);
  EXPECT_EQ("expired", explanation.verdict);
  EXPECT_EQ(86400.0, explanation.value);
  ExpectSums(explanation);
}

TEST(ExplainPlan, PlacesAreForbiddenFarOrNotSampledAndAlwaysSaySo) {
  std::map<std::string, int> verdicts;
  ForEachWorld(3, [&](const PlannedWorld& world) {
    PlannedTestWorld places(99);
    for (int i = 0; i < 40; ++i) {
      PlanQuestion question = About(QuestionKind::kPlace, "bravo", i % 3);
      question.place = places.AnyPlace();
      const Explanation explanation = Explain(world, question);
      ++verdicts[explanation.verdict];
      ExpectSums(explanation);
      const auto& tensor = kg_compiler::FindTensor(
          *world.compilation, FindAgent(world, "bravo"), i % 3);
      const auto cell = tensor.grid.CellAt(question.place);
      const bool is_open = tensor.At(kg_compiler::Layer::kFeasibility,
                                     tensor.grid.Index(*cell)) == 1.0f;
      EXPECT_EQ(is_open, explanation.verdict != "forbidden");
      if (explanation.verdict == "unreachable") {
        EXPECT_GT(explanation.value, 0);
      }
    }
  });
  EXPECT_GT(verdicts["forbidden"], 0);
  EXPECT_GT(verdicts["unreachable"], 5);
  EXPECT_GT(verdicts["not_sampled"], 5);
}

TEST(ExplainPlan, RefusesWhatIsNotThereWithWhatIs) {
  const PlannedWorld world = PlannedTestWorld(2).Plan();
  const auto refused = [&](const PlanQuestion& question) -> std::string {
    try {
      Explain(world, question);
    } catch (const kg_base::InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ("agent 'nobody' is not known; there are alpha, bravo, charlie",
            refused(About(QuestionKind::kAssignment, "nobody", 0)));
  EXPECT_EQ("window 7 of alpha is not planned: the windows are 0 to 2",
            refused(About(QuestionKind::kAssignment, "alpha", 7)));
  PlanQuestion question = About(QuestionKind::kWaypoint, "alpha", 1);
  question.to = 99;
  EXPECT_NE("", refused(question));
  question = About(QuestionKind::kEvent, "alpha", 1);
  question.id = "ex:nothing";
  EXPECT_NE(std::string::npos, refused(question).find("is not known"));
  question = About(QuestionKind::kRejection, "", 0);
  for (const char* id : {"", "-1", "x", "999", "1x"}) {
    question.id = id;
    EXPECT_NE("", refused(question)) << id;
  }
  question = About(QuestionKind::kTensorCell, "alpha", 0);
  question.place = {0.0, 0.0};
  EXPECT_NE("", refused(question));
  PlannedWorld early = world;
  early.members[0].graphs.pop_back();
  EXPECT_THROW(Explain(early, About(QuestionKind::kAssignment, "alpha", 0)),
               kg_base::InputError);
  PlannedWorld strange = world;
  kg_compiler::NavGraphs odd;
  for (NavGraph graph : strange.members[0].graphs) {
    for (auto& waypoint : graph.waypoints) waypoint.footprint = {1 << 30};
    odd.push_back(graph);
  }
  strange.members[0].graphs = odd;
  EXPECT_THROW(Explain(strange, About(QuestionKind::kAssignment, "alpha", 0)),
               kg_base::InputError);
  PlannedWorld unplanned = world;
  unplanned.has_plan = false;
  EXPECT_THROW(Explain(unplanned, About(QuestionKind::kAssignment, "alpha", 0)),
               kg_base::InputError);
}

}  // namespace
}  // namespace kg_selector
