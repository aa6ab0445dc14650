// Incremental == full, bit by bit: a mission with random changes of every kind
// of fact that the compiler reads, compiled and planned step by step, against
// compilers and planners without previous state.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "kg_base/common/input_error.h"
#include "kg_compiler/compile/same_compilation.h"
#include "kg_compiler/control_plane/nav_graph.h"
#include "kg_compiler/control_plane/seam_cache.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

constexpr int kWindows = 4;
constexpr int kSize = 26;  // Rows and columns of the grid.

class LivingMission {
 public:
  explicit LivingMission(unsigned seed) : rng_(seed) {
    mission.iri = "ex:mission";
    mission.files["ex:file"] = {"ex:file", "/file.nc", "0"};
    for (int t = 0; t < kWindows; ++t) AddWindow(t);
    for (const char* id : {"alpha", "bravo", "charlie"}) AddAgent(id);
    mission.coordination.waypoints_per_window = 5;
    mission.coordination.waypoint_spacing_m = 8000.0;
    for (int i = 0; i < 3; ++i) AddConstraint();
    AddPrior();
    AddEvent();
  }

  // Applies one change of a random kind; returns its name.
  std::string Change() {
    const auto at =
        std::next(kChanges.begin(), static_cast<int>(rng_() % kChanges.size()));
    at->second(this);
    return at->first;
  }
  static std::size_t kinds() { return kChanges.size(); }

  RasterReaders Readers() const {
    return {[](const kg_mission::Mission& all,
               const kg_mission::WorkFieldRef& ref) {
              std::mt19937 rng(ref.first_time_index + Seed(all));
              return RandomFlow(rng, EvenGrid(-91, 24, 0.04, kSize, kSize),
                                0.08, 43200, 4 * 86400);
            },
            [](const kg_mission::Mission& all,
               const kg_mission::ValueLayer& layer, const kg_base::Grid& grid) {
              std::mt19937 rng(layer.time_index + 77 + Seed(all));
              return RandomRaster(rng, grid.size(), 0, 1);
            }};
  }

  kg_mission::Mission mission;
  int first_window = 0;

 private:
  using Changes = std::map<std::string, std::function<void(LivingMission*)>>;
  static const Changes kChanges;

  static unsigned Seed(const kg_mission::Mission& all) {
    return static_cast<unsigned>(std::stoul(all.files.at("ex:file").sha256) *
                                 1000);
  }
  double Any(double low, double high) { return Uniform(rng_, low, high); }
  bool Toss() { return rng_() % 2 == 0; }
  int Pick(std::size_t count) { return static_cast<int>(rng_() % count); }
  kg_mission::Agent& AnyAgent() {
    return mission.agents[Pick(mission.agents.size())];
  }
  kg_mission::Policy& AnyPolicy() { return AnyAgent().policy; }
  std::vector<int> AnyWindows() {
    std::vector<int> windows;
    for (int t = 0; t < kWindows; ++t) {
      if (Toss()) windows.push_back(t);
    }
    return windows;
  }
  std::vector<std::string> AnyAgents() {
    if (Toss()) return {};
    return {AnyAgent().iri};
  }
  kg_base::LonLat AnyPlace() { return {Any(-90.9, -90.1), Any(24.1, 24.9)}; }
  kg_base::Geometry AnyArea() {
    const kg_base::LonLat at = AnyPlace();
    const double size = Any(0.02, 0.15);
    return Box(at.lon_deg, at.lat_deg, at.lon_deg + size, at.lat_deg + size);
  }

  void AddWindow(int t) {
    const std::string name = std::to_string(t);
    mission.windows.push_back(TestWindow(t, 1.0 - 0.1 * t));
    mission.work_fields.push_back({"ex:field" + name, t, "ex:file", t, t + 1});
    mission.value_layers.push_back(
        {"ex:value" + name, t, "delta_sst", "ex:file", t + 1, t});
    mission.value_layers.back().full_scale = 2.0;
    mission.value_layers.back().front_full_scale = 0.5;
  }
  void AddAgent(const std::string& id) {
    kg_mission::Agent agent = TestAgent(id);
    agent.policy.iri = "ex:policy_of_" + id;
    agent.policy.lambda_time_per_s = 1e-5;
    agent.policy.lambda_risk = 0.1;
    agent.policy.hazard_range_m = 1500.0;
    agent.policy.beta["ex:prior0"] = 0.4;
    agent.policy.beta_poi = 0.3;
    agent.capabilities.cruise_mps = 0.12;
    agent.capabilities.sensor_radius_m = 7000.0;
    agent.start = AnyPlace();
    mission.agents.push_back(agent);
  }
  void AddConstraint() {
    kg_mission::Constraint one =
        AreaConstraint("ex:c" + std::to_string(next_++),
                       Pick(3) ? kg_mission::ConstraintKind::kSoft
                               : kg_mission::ConstraintKind::kNoGo,
                       AnyArea());
    one.attenuation = Any(0.1, 0.9);
    one.buffer_cells = Toss() ? 0.0 : Any(0.0, 2.5);
    one.windows = AnyWindows();
    one.agents = AnyAgents();
    mission.constraints.push_back(one);
  }
  void AddPrior() {
    kg_mission::PriorLayer prior;
    prior.iri = "ex:prior" + std::to_string(mission.priors.size());
    prior.area = AnyArea();
    prior.edge_m = Toss() ? 0.0 : Any(1000.0, 9000.0);
    prior.windows = AnyWindows();
    prior.agents = AnyAgents();
    mission.priors.push_back(prior);
    AnyPolicy().beta[prior.iri] = Any(-0.5, 1.0);
  }
  void AddEvent() {
    mission.events.push_back({"ex:e" + std::to_string(next_++), AnyPlace(),
                              Any(1, 5), 1 + Pick(3), Any(2000, 9000),
                              AnyWindows()});
  }
  template <typename T>
  void RemoveOne(std::vector<T>* list) {
    if (!list->empty()) list->erase(list->begin() + Pick(list->size()));
  }
  template <typename T, typename Edit>
  void ChangeOne(std::vector<T>* list, const Edit& edit) {
    if (!list->empty()) edit(&(*list)[Pick(list->size())]);
  }

  std::mt19937 rng_;
  int next_ = 0;
};

// Every kind of fact change, by name.
const LivingMission::Changes LivingMission::kChanges = {
    {"constraint added", [](auto* m) { m->AddConstraint(); }},
    {"constraint moved",
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints,
                    [m](auto* one) { one->area = m->AnyArea(); });
     }},
    {"constraint removed",
     [](auto* m) { m->RemoveOne(&m->mission.constraints); }},
    {"constraint scoped",
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints, [m](auto* one) {
         one->windows = m->AnyWindows();
         one->agents = m->AnyAgents();
       });
     }},
    {"constraint expiring",  // Not in force in the last windows.
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints, [m](auto* one) {
         one->windows.clear();
         for (int t = 0; t <= m->Pick(kWindows); ++t) one->windows.push_back(t);
       });
     }},
    {"constraint's factor",
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints,
                    [m](auto* one) { one->attenuation = m->Any(0.0, 1.0); });
     }},
    {"constraint's buffer",
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints,
                    [m](auto* one) { one->buffer_cells = m->Any(0.0, 3.0); });
     }},
    {"constraint's metric",
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints, [m](auto* one) {
         one->buffer_metric = static_cast<kg_mission::BufferMetric>(m->Pick(2));
       });
     }},
    {"constraint's kind",
     [](auto* m) {
       m->ChangeOne(&m->mission.constraints, [m](auto* one) {
         one->kind = static_cast<kg_mission::ConstraintKind>(m->Pick(2));
       });
     }},
    {"constraint escalated",
     [](auto* m) {
       kg_mission::Agent& agent = m->AnyAgent();
       m->ChangeOne(&m->mission.constraints, [&](auto* one) {
         if (agent.must_avoid.erase(one->iri) == 0) {
           agent.must_avoid[one->iri] = {agent.iri};
         }
       });
     }},
    {"soft override",
     [](auto* m) {
       kg_mission::Policy& policy = m->AnyPolicy();
       m->ChangeOne(&m->mission.constraints, [&](auto* one) {
         policy.soft_overrides[one->iri] = m->Any(0.0, 1.0);
         policy.weight_iris[one->iri] = "ex:override";
       });
     }},
    {"alpha", [](auto* m) { m->AnyPolicy().alpha_base = m->Any(0, 1); }},
    {"beta", [](auto* m) { m->AnyPolicy().beta["ex:prior0"] = m->Any(-1, 1); }},
    {"beta_poi", [](auto* m) { m->AnyPolicy().beta_poi = m->Any(0, 1); }},
    {"gamma", [](auto* m) { m->AnyPolicy().gamma_front = m->Any(0, 1); }},
    {"lambda_time",
     [](auto* m) { m->AnyPolicy().lambda_time_per_s = m->Any(0, 1e-4); }},
    {"lambda_energy",
     [](auto* m) { m->AnyPolicy().lambda_energy_per_j = m->Any(0, 1e-5); }},
    {"lambda_risk", [](auto* m) { m->AnyPolicy().lambda_risk = m->Any(0, 1); }},
    {"lambda_uncertainty",
     [](auto* m) { m->AnyPolicy().lambda_uncertainty = m->Any(0, 1); }},
    {"lambda_turn",
     [](auto* m) { m->AnyPolicy().lambda_turn_per_rad = m->Any(0, 2); }},
    {"hazard range",
     [](auto* m) { m->AnyPolicy().hazard_range_m = m->Any(0, 6000); }},
    {"isolation weight",
     [](auto* m) { m->AnyPolicy().isolation_weight = m->Any(0, 1); }},
    {"normalisation",
     [](auto* m) {
       m->AnyPolicy().normalisation =
           static_cast<kg_mission::Normalisation>(m->Pick(3));
     }},
    {"confidence mode",
     [](auto* m) {
       m->AnyPolicy().confidence_mode =
           static_cast<kg_mission::ConfidenceMode>(m->Pick(3));
     }},
    {"front operator",
     [](auto* m) {
       m->AnyPolicy().front_operator =
           static_cast<kg_mission::FrontOperator>(m->Pick(2));
     }},
    {"layer scale",
     [](auto* m) {
       m->AnyPolicy().layer_scale =
           static_cast<kg_mission::LayerScale>(m->Pick(3));
     }},
    {"full scale",
     [](auto* m) {
       m->ChangeOne(&m->mission.value_layers,
                    [m](auto* one) { one->full_scale = m->Any(0.5, 3.0); });
     }},
    {"soft overlap",
     [](auto* m) {
       m->AnyPolicy().soft_overlap =
           static_cast<kg_mission::SoftOverlap>(m->Pick(2));
     }},
    {"paper literal",
     [](auto* m) { m->AnyPolicy().paper_literal = m->Pick(4) == 0; }},
    {"policy of another",
     [](auto* m) { m->AnyAgent().policy = m->AnyPolicy(); }},
    {"confidence",
     [](auto* m) {
       m->ChangeOne(&m->mission.windows,
                    [m](auto* one) { one->confidence = m->Any(0, 1); });
     }},
    {"window's times",
     [](auto* m) {
       const int at = 1 + m->Pick(kWindows - 1);
       const double border_s = at * 86400.0 + m->Any(-20000.0, 20000.0);
       m->mission.windows[at - 1].end_s = border_s;
       m->mission.windows[at].begin_s = border_s;
     }},
    {"event added", [](auto* m) { m->AddEvent(); }},
    {"event removed", [](auto* m) { m->RemoveOne(&m->mission.events); }},
    {"event changed",
     [](auto* m) {
       m->ChangeOne(&m->mission.events, [m](auto* one) {
         one->position = m->AnyPlace();
         one->value = m->Any(0, 5);
         one->capacity = m->Pick(4);
         one->windows = m->AnyWindows();
       });
     }},
    {"prior added", [](auto* m) { m->AddPrior(); }},
    {"prior changed",
     [](auto* m) {
       m->ChangeOne(&m->mission.priors, [m](auto* one) {
         one->area = m->AnyArea();
         one->windows = m->AnyWindows();
         one->agents = m->AnyAgents();
       });
     }},
    {"start", [](auto* m) { m->AnyAgent().start = m->AnyPlace(); }},
    {"heading",
     [](auto* m) { m->AnyAgent().start_heading_rad = m->Any(0, 6); }},
    {"capabilities",
     [](auto* m) {
       kg_mission::Capabilities& one = m->AnyAgent().capabilities;
       one.cruise_mps = m->Any(0.08, 0.2);
       one.boost_gain = m->Any(0.5, 1.0);
       one.energy_per_m_j = m->Any(1, 3);
       one.hotel_load_w = m->Any(0, 2);
       one.sensor_radius_m = m->Any(4000, 9000);
     }},
    {"energy budget",
     [](auto* m) {
       m->AnyAgent().capabilities.energy_budget_j = m->Any(1e5, 1e7);
     }},
    {"base travel",
     [](auto* m) {
       auto& base_m = m->AnyAgent().capabilities.base_travel_m;
       base_m =
           m->Toss() ? std::optional<double>(m->Any(4e3, 2e4)) : std::nullopt;
     }},
    {"coordination",
     [](auto* m) {
       kg_mission::CoordinationFacts& team = m->mission.coordination;
       team.waypoints_per_window = 2 + m->Pick(5);
       team.waypoint_spacing_m = m->Any(5e3, 1e4);
       team.separation_m = m->Any(0, 5e3);
     }},
    {"choice of the team",
     [](auto* m) {
       kg_mission::CoordinationFacts& team = m->mission.coordination;
       team.mode = m->Toss() ? "priced" : "greedy";
       team.gap_goal = m->Any(0, 1);
     }},
    {"choice of paths",
     [](auto* m) {
       kg_mission::Policy& policy = m->AnyAgent().policy;
       policy.diverse_paths = m->Toss();
       policy.churn_weight = m->Any(0, 2);
       policy.hazard_budget_s =
           m->Toss() ? std::optional<double>(m->Any(1e3, 1e5)) : std::nullopt;
     }},
    {"movement mode",
     [](auto* m) {
       m->mission.coordination.movement_mode = m->Toss() ? "edges" : "hops";
     }},
    {"files replaced",
     [](auto* m) {
       m->mission.files["ex:file"].sha256 = std::to_string(m->Pick(3));
     }},
    {"window passed", [](auto* m) { m->first_window = m->Pick(3); }},
    {"agent gone or back",
     [](auto* m) {
       if (m->mission.agents.size() == 3) {
         m->mission.agents.pop_back();
       } else {
         m->AddAgent("charlie");
       }
     }},
};

std::string Text(const Difference& found) {
  std::string text;
  for (const std::string& name : found.differs) text += name + "\n";
  return text;
}

std::vector<WindowWorld> WorldsOf(const Compilation& compilation,
                                  std::size_t agent) {
  std::vector<WindowWorld> worlds;
  const std::size_t windows = compilation.fields.size();
  for (std::size_t i = 0; i < windows; ++i) {
    worlds.push_back({compilation.tensors[agent * windows + i].get(),
                      &compilation.fields[i]->field});
  }
  return worlds;
}

// The graphs, or the error text if there are none.
struct Planned {
  NavGraphs graphs;
  std::string error;
};
Planned Plan(const Compilation& compilation, std::size_t agent,
             SeamCache* cache) {
  try {
    return {CompileNavGraphs(compilation.rules[agent],
                             WorldsOf(compilation, agent), cache),
            ""};
  } catch (const kg_base::InputError& error) {
    return {{}, error.what()};
  }
}

// Artifacts not reported as dirty must be unchanged; of a dirty tensor the
// masks and priors must be unchanged outside its box.
void ExpectDirtyAsTold(const Compilation& last, const Compilation& next) {
  for (const auto& tensor : next.tensors) {
    const DirtyArtifact entry{"tensor", tensor->agent_iri, tensor->window};
    const auto dirty = std::find(next.dirty.begin(), next.dirty.end(), entry);
    const bool is_dirty = dirty != next.dirty.end();
    if (is_dirty && !dirty->box) continue;
    const auto old = std::find_if(
        last.tensors.begin(), last.tensors.end(), [&](const auto& one) {
          return one->agent_iri == tensor->agent_iri &&
                 one->window == tensor->window;
        });
    ASSERT_NE(last.tensors.end(), old);
    for (const Layer layer :
         {Layer::kPolicy, Layer::kAttenuation, Layer::kFeasibility}) {
      const kg_base::Raster was = (*old)->Get(layer), is = tensor->Get(layer);
      for (std::size_t i = 0; i < is.size(); ++i) {
        const int row = static_cast<int>(i) / kSize;
        const int col = static_cast<int>(i) % kSize;
        if (is_dirty && row >= dirty->box->row && row < dirty->box->row_end &&
            col >= dirty->box->col && col < dirty->box->col_end) {
          continue;
        }
        ASSERT_TRUE(was[i] == is[i] || (was[i] != was[i] && is[i] != is[i]))
            << Name(layer) << " of " << tensor->agent_iri << " at " << row
            << "," << col;
      }
    }
  }
}

// The compilation, or the error text if it is rejected.
struct Compiled {
  std::shared_ptr<const Compilation> all;
  std::string error;
};
Compiled CompileOf(MissionCompiler* compiler, const LivingMission& living,
                   int step) {
  try {
    return {compiler->Compile(living.mission, step, living.first_window), ""};
  } catch (const kg_base::InputError& error) {
    return {nullptr, error.what()};
  }
}

TEST(Incremental, IsFullBitByBitAfterAnySequenceOfFactChanges) {
  std::set<std::string> kinds;
  std::size_t graphs = 0, boxes = 0, failed = 0;
  SeamCounts counts;
  for (unsigned seed = 1; seed <= 5; ++seed) {
    LivingMission living(seed);
    MissionCompiler compiler(living.Readers());
    std::map<std::string, SeamCache> caches;
    auto last = compiler.Compile(living.mission, 1, 0);
    for (int step = 2; step < 50; ++step) {
      std::string changes;
      for (unsigned i = 0; i < 1 + seed; ++i) {
        const std::string change = living.Change();
        kinds.insert(change);
        changes += change + "; ";
      }
      SCOPED_TRACE("seed " + std::to_string(seed) + ", step " +
                   std::to_string(step) + ": " + changes);
      MissionCompiler fresh(living.Readers());
      const Compiled next = CompileOf(&compiler, living, step);
      const Compiled anew = CompileOf(&fresh, living, step);
      ASSERT_EQ(anew.error, next.error);
      if (!next.all) continue;  // Rejected; the last one is unchanged.
      const Difference found = Compare(*anew.all, *next.all);
      ASSERT_EQ("", Text(found));
      EXPECT_EQ(next.all->fields.size() + next.all->tensors.size() +
                    next.all->rules.size() + 1,
                found.compared);
      ExpectDirtyAsTold(*last, *next.all);
      for (const DirtyArtifact& dirty : next.all->dirty) {
        boxes += dirty.box.has_value();
      }
      for (std::size_t a = 0; a < next.all->rules.size(); ++a) {
        SeamCache& cache = caches[next.all->rules[a].agent_iri];
        const Planned by_step = Plan(*next.all, a, &cache);
        const Planned from_nothing = Plan(*anew.all, a, nullptr);
        ASSERT_EQ(from_nothing.error, by_step.error);
        ASSERT_EQ("", Text(Compare(from_nothing.graphs, by_step.graphs)));
        graphs += by_step.graphs.size();
        failed += !by_step.error.empty();
        counts.graphs_kept += cache.counts.graphs_kept;
        counts.reaches_kept += cache.counts.reaches_kept;
        counts.flights_kept += cache.counts.flights_kept;
      }
      last = next.all;
    }
  }
  EXPECT_EQ(LivingMission::kinds(), kinds.size());
  EXPECT_GT(graphs, 800u);
  EXPECT_GT(boxes, 50u);
  EXPECT_GT(failed, 0u);
  EXPECT_GT(counts.graphs_kept, 100);
  EXPECT_GT(counts.reaches_kept, 100);
  EXPECT_GT(counts.flights_kept, 500);
}

TEST(Compare, NamesWhatDiffersAndWhatOnlyOneHas) {
  LivingMission living(9);
  const auto one =
      MissionCompiler(living.Readers()).Compile(living.mission, 1, 0);
  living.mission.agents[1].policy.alpha_base = 0.123;
  living.mission.agents.pop_back();
  living.mission.coordination.max_rounds = 99;
  const auto other =
      MissionCompiler(living.Readers()).Compile(living.mission, 1, 0);
  const Difference found = Compare(*one, *other);
  EXPECT_EQ(4u + 12u + 3u + 1u, found.compared);
  const auto names = [&](const std::string& name) {
    return std::count(found.differs.begin(), found.differs.end(), name);
  };
  EXPECT_EQ(1, names("tensor of ex:bravo, window 2"));
  EXPECT_EQ(1, names("tensor of ex:charlie, window 0"));
  EXPECT_EQ(1, names("seam rules of ex:charlie"));
  EXPECT_EQ(1, names("coordination rules"));
  EXPECT_EQ(0, names("tensor of ex:alpha, window 2"));
}

}  // namespace
}  // namespace kg_compiler
