#include "kg_compiler/data_plane/data_plane.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>
#include <stdexcept>

#include "kg_base/geo/geodesy.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

using kg_mission::Agent;
using kg_mission::Constraint;
using kg_mission::ConstraintKind;
using kg_mission::Mission;

// Reference implementation of Eq. 1: double precision, a loop over cells, every
// term from its definition (GEOS predicates on cell boxes, geodesics, all-pairs
// distances).
class Reference {
 public:
  Reference(const Mission& mission, const Agent& agent, int window,
            const WindowRasters& rasters)
      : mission_(mission), agent_(agent), window_(window), in_(rasters) {
    for (const Constraint& c : mission_.constraints) {
      const bool hard = Factor(c) < 0;
      for (int row = -kBeyond; row < in_.grid.rows() + kBeyond; ++row) {
        for (int col = -kBeyond; col < Cols() + kBeyond; ++col) {
          inside_[c.iri].push_back(Inside(c, row, col, hard));
        }
      }
    }
    for (const kg_mission::PriorLayer& prior : mission_.priors) {
      for (int j = 0; j < Size(); ++j) {
        inside_[prior.iri].push_back(prior.area->Contains(Centre(j)));
      }
    }
    for (int i = 0; i < Size(); ++i) open_.push_back(FindOpen(i));
    most_value_ = MaxOpen([&](int j) { return double(in_.value[j]); });
    most_front_ = MaxOpen([&](int j) { return Front(j); });
  }

  bool Open(int i) const { return open_[i]; }
  bool FindOpen(int i) const {
    if (in_.land[i]) return false;
    for (const Constraint& c : mission_.constraints) {
      if (Factor(c) >= 0 || !c.AppliesTo(agent_.iri, window_)) continue;
      if (Extends(c, i)) return false;
    }
    return true;
  }
  double Soft(int i) const {
    double product = 1.0;
    for (const Constraint& c : mission_.constraints) {
      if (Factor(c) < 0 || !c.AppliesTo(agent_.iri, window_)) continue;
      if (Extends(c, i)) product *= Factor(c);
    }
    return product;
  }
  double Value(int i) const {
    const kg_mission::Policy& p = agent_.policy;
    double v = p.alpha_base * Positive(in_.value[i]) / most_value_;
    v += p.gamma_front * Positive(Front(i)) / most_front_;
    for (const kg_mission::PriorLayer& prior : mission_.priors) {
      if (p.beta.count(prior.iri)) v += p.beta.at(prior.iri) * Prior(prior, i);
    }
    for (const kg_mission::Event& e : mission_.events) {
      if (!std::count(e.windows.begin(), e.windows.end(), window_)) continue;
      const double z = kg_base::Distance_m(e.position, Centre(i)) / e.radius_m;
      v += p.beta_poi * e.value * std::exp(-z * z / 2);
    }
    return std::max(0.0, v) * Soft(i);
  }
  std::vector<double> Fused() const {
    std::vector<double> value, fused;
    double most = 0.0;
    for (int i = 0; i < Size(); ++i) {
      value.push_back(Value(i));
      if (Open(i)) most = std::max(most, value.back());
    }
    const double w = mission_.windows[window_].confidence;
    for (int i = 0; i < Size(); ++i) {
      fused.push_back(Open(i) && most > 0 ? w * value[i] / most : 0.0);
    }
    return fused;
  }

 private:
  static constexpr int kBeyond = 3;  // At least every buffer of the tests.
  int Size() const { return static_cast<int>(in_.grid.size()); }
  int Cols() const { return in_.grid.cols(); }
  kg_base::LonLat Centre(int i) const {
    return in_.grid.Centre({i / Cols(), i % Cols()});
  }
  // Is the cell inside, or within the buffer of a cell that is? Cells up to
  // kBeyond beyond the grid count as well.
  bool Extends(const Constraint& c, int i) const {
    const int wide = Cols() + 2 * kBeyond;
    const std::vector<bool>& inside = inside_.at(c.iri);
    for (int j = 0; j < static_cast<int>(inside.size()); ++j) {
      const double cells = std::hypot(j / wide - kBeyond - i / Cols(),
                                      j % wide - kBeyond - i % Cols());
      if (inside[j] && cells <= c.buffer_cells) return true;
    }
    return false;
  }
  static double Positive(double x) { return x > 0 ? x : 0.0; }
  // Factor of a constraint; negative = hard.
  double Factor(const Constraint& c) const {
    if (c.kind == ConstraintKind::kNoGo) return -1.0;
    const auto& overrides = agent_.policy.soft_overrides;
    const double f =
        overrides.count(c.iri) ? overrides.at(c.iri) : c.attenuation;
    return agent_.must_avoid.count(c.iri) ? -1.0 : f;
  }
  bool Inside(const Constraint& c, int row, int col, bool touched) const {
    if (c.is_land) {
      return in_.grid.Contains({row, col}) &&
             in_.land[in_.grid.Index({row, col})];
    }
    if (!touched) {
      return c.area->Contains(in_.grid.Position(
          {static_cast<double>(row), static_cast<double>(col)}));
    }
    const kg_base::LonLat sw = in_.grid.Position({row - 0.5, col - 0.5});
    const kg_base::LonLat ne = in_.grid.Position({row + 0.5, col + 0.5});
    return c.area->Intersects(
        Box(sw.lon_deg, sw.lat_deg, ne.lon_deg, ne.lat_deg));
  }
  double MaxOpen(const std::function<double(int)>& f) const {
    double most = 0.0;
    for (int i = 0; i < Size(); ++i) {
      if (Open(i)) most = std::max(most, Positive(f(i)));
    }
    return most > 0 ? most : 1.0;
  }
  double Prior(const kg_mission::PriorLayer& prior, int i) const {
    const std::vector<bool>& inside = inside_.at(prior.iri);
    if (inside[i]) return 1.0;
    double least = 1e30;
    for (int j = 0; j < Size(); ++j) {
      if (!inside[j]) continue;
      least = std::min(least, Distance(j, i));
    }
    return prior.edge_m > 0 ? std::exp(-0.5 * std::pow(least / prior.edge_m, 2))
                            : 0.0;
  }
  // Distance with the east-west scale of j's row, as in distance_transform.h.
  double Distance(int j, int i) const {
    const kg_base::LonLat a = Centre(j), b = Centre(i);
    return std::hypot(
        (b.lon_deg - a.lon_deg) / kg_base::LocalScale(a.lat_deg).lon_deg,
        kg_base::Distance_m(a, {a.lon_deg, b.lat_deg}));
  }
  double At(int r, int c) const {
    const bool on = r >= 0 && c >= 0 && r < in_.grid.rows() && c < Cols();
    return on ? in_.value[r * Cols() + c] : kGap;
  }
  // The weighted mean of the differences that exist in three parallel lines.
  double Component(int r, int c, bool east) const {
    double sum = 0, weights = 0;
    for (int k : {-1, 0, 1}) {
      const int r0 = east ? r + k : r, c0 = east ? c : c + k;
      if (r0 < 0 || c0 < 0 || r0 >= in_.grid.rows() || c0 >= Cols()) continue;
      int lo = -1, hi = 1;
      const auto at = [&](int n) {
        return east ? At(r0, c0 + n) : At(r0 + n, c0);
      };
      if (std::isnan(at(lo))) lo = 0;
      if (std::isnan(at(hi))) hi = 0;
      if (lo == hi || std::isnan(at(lo)) || std::isnan(at(hi))) continue;
      const kg_base::LonLat a = in_.grid.Centre(
          east ? kg_base::Cell{r0, c0 + lo} : kg_base::Cell{r0 + lo, c0});
      const kg_base::LonLat b = in_.grid.Centre(
          east ? kg_base::Cell{r0, c0 + hi} : kg_base::Cell{r0 + hi, c0});
      const double weight = k == 0 ? 2 : 1;
      sum += weight * (at(hi) - at(lo)) / (kg_base::Distance_m(a, b) / 1000);
      weights += weight;
    }
    return weights > 0 ? sum / weights : 0.0;
  }
  double Front(int i) const {
    if (std::isnan(in_.value[i])) return kGap;
    return std::hypot(Component(i / Cols(), i % Cols(), true),
                      Component(i / Cols(), i % Cols(), false));
  }

  const Mission& mission_;
  const Agent& agent_;
  int window_;
  const WindowRasters& in_;
  // Cells inside, by IRI of constraint or prior.
  std::map<std::string, std::vector<bool>> inside_;
  std::vector<bool> open_;
  double most_value_ = 1.0;
  double most_front_ = 1.0;
};

Mission RandomMission(std::mt19937& rng, const kg_base::Grid& grid) {
  Mission mission;
  for (int t = 0; t < 3; ++t) {
    mission.windows.push_back(TestWindow(t, std::exp(-0.12 * t)));
  }
  const auto box = [&](double size) {
    const double x = Uniform(rng, grid.west_deg(), grid.east_deg());
    const double y = Uniform(rng, grid.south_deg(), grid.north_deg());
    return Box(x, y, x + size, y + size);
  };
  mission.constraints.resize(4);
  mission.constraints[0] =
      AreaConstraint("ex:c0", ConstraintKind::kNoGo, box(0.1));
  mission.constraints[1] =
      AreaConstraint("ex:c1", ConstraintKind::kSoft, box(0.3));
  mission.constraints[1].attenuation = 0.4;
  mission.constraints[2] =
      AreaConstraint("ex:c2", ConstraintKind::kSoft, box(0.3));
  mission.constraints[2].attenuation = 0.7;
  mission.constraints[2].buffer_cells = 2;
  mission.constraints[2].windows = {1};
  mission.constraints[3].iri = "ex:c3";
  mission.constraints[3].is_land = true;
  mission.constraints[3].buffer_cells = 1.5;
  mission.constraints[3].agents = {"ex:alpha"};
  mission.priors.push_back({"ex:p0", "p0", box(0.2), 0.0, {}, {}});
  mission.priors.push_back({"ex:p1", "p1", box(0.2), 6000.0, {}, {}});
  mission.events.push_back({"ex:e0",
                            {Uniform(rng, grid.west_deg(), grid.east_deg()),
                             Uniform(rng, grid.south_deg(), grid.north_deg())},
                            2.0,
                            1,
                            9000.0,
                            {0, 1}});
  mission.agents = {TestAgent("alpha"), TestAgent("bravo")};
  for (Agent& agent : mission.agents) {
    agent.policy.alpha_base = Uniform(rng, 0.2, 2);
    agent.policy.gamma_front = Uniform(rng, 0.2, 2);
    agent.policy.beta_poi = Uniform(rng, -1, 1);
    agent.policy.beta = {{"ex:p0", Uniform(rng, -1, 1)}, {"ex:p1", 0.5}};
    agent.policy.soft_overrides = {{"ex:c1", 0.3}};
  }
  return mission;
}

WindowRasters RandomRasters(std::mt19937& rng, const kg_base::Grid& grid) {
  const kg_base::Mask land = RandomMask(rng, grid.size(), 0.05);
  kg_base::Raster value = RandomRaster(rng, grid.size(), -0.5, 3.0);
  for (std::size_t i = 0; i < value.size(); ++i) {
    if (land[i] || Uniform(rng, 0, 1) < 0.05) value[i] = kGap;
  }
  return TestRasters(grid, value, land);
}

TEST(DataPlane, AgreesWithTheStraightforwardImplementation) {
  std::mt19937 rng(1);
  for (int round = 0; round < 12; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 14, 18);
    Mission mission = RandomMission(rng, grid);
    if (round % 4 == 3) {
      mission.agents[0].must_avoid = {{"ex:c1", {"ex:i1"}},
                                      {"ex:c2", {"ex:i2"}}};
    }
    const WindowRasters rasters = RandomRasters(rng, grid);
    const int t = round % 3;
    for (const Agent& agent : mission.agents) {
      const kg_base::Raster got =
          CompileTensor(mission, agent, mission.windows[t], rasters)
              .Get(Layer::kFused);
      const std::vector<double> wanted =
          Reference(mission, agent, t, rasters).Fused();
      for (std::size_t i = 0; i < got.size(); ++i) {
        EXPECT_NEAR(wanted[i], got[i], 1e-6) << "cell " << i;
      }
    }
  }
}

Mission PlainMission(double confidence = 1.0) {
  Mission mission;
  mission.windows = {TestWindow(0, confidence)};
  mission.agents = {TestAgent("alpha")};
  return mission;
}

kg_base::Raster FusedOf(const Mission& mission, const WindowRasters& rasters) {
  return CompileTensor(mission, mission.agents[0], mission.windows[0], rasters)
      .Get(Layer::kFused);
}

// Computed by hand: B/4 everywhere, the corridor adds 0.5 in the middle column,
// the zone halves the top row, the south-west cell is forbidden; the largest
// open value is 0.5 + 6/8 = 1.25, and w = 0.8.
TEST(DataPlane, GivesTheThreeByThreeExampleWorkedByHand) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 3, 3);
  Mission mission = PlainMission(0.8);
  mission.agents[0].policy.beta = {{"ex:corridor", 0.5}};
  mission.priors.push_back(
      {"ex:corridor", "", Box(0.6, -1, 1.4, 3), 0, {}, {}});
  mission.constraints.resize(2);
  mission.constraints[0] =
      AreaConstraint("ex:a", ConstraintKind::kNoGo, Box(-0.1, -0.1, 0.1, 0.1));
  mission.constraints[1] =
      AreaConstraint("ex:b", ConstraintKind::kSoft, Box(-1, 1.6, 3, 3));
  mission.constraints[1].attenuation = 0.5;
  const WindowRasters rasters =
      TestRasters(grid, {100, 2, 4, 0, 6, 8, 2, 4, kGap}, kg_base::Mask(9, 0));
  const double hand[9] = {0,     0.25 + 0.5,        0.5,  //
                          0,     0.75 + 0.5,        1.0,  //
                          0.125, 0.5 * (0.5 + 0.5), 0.0};
  const kg_base::Raster fused = FusedOf(mission, rasters);
  for (int i = 0; i < 9; ++i) {
    EXPECT_NEAR(0.8 * hand[i] / 1.25, fused[i], 1e-6) << i;
  }
}

TEST(DataPlane, AttenuatesInsideASoftZoneByExactlyItsFactor) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 6, 6);
  Mission mission = PlainMission();
  mission.constraints.resize(1);
  mission.constraints[0] =
      AreaConstraint("ex:zone", ConstraintKind::kSoft, Box(-1, -1, 2.5, 9));
  mission.constraints[0].attenuation = 0.4;
  const WindowRasters rasters =
      TestRasters(grid, kg_base::Raster(36, 7.0f), kg_base::Mask(36, 0));
  const kg_base::Raster fused = FusedOf(mission, rasters);
  EXPECT_FLOAT_EQ(0.4f, fused[0] / fused[5]);
  EXPECT_FLOAT_EQ(1.0f, fused[5]);
  mission.agents[0].policy.soft_overrides["ex:zone"] = 0.1;
  EXPECT_FLOAT_EQ(0.1f, FusedOf(mission, rasters)[0]);
}

TEST(DataPlane, StaysInZeroToOneWithoutNaNForEveryOption) {
  std::mt19937 rng(5);
  for (int round = 0; round < 60; ++round) {
    const kg_base::Grid grid = UnevenGrid(rng, 10, 12);
    Mission mission = RandomMission(rng, grid);
    Agent& agent = mission.agents[0];
    agent.policy.normalisation =
        static_cast<kg_mission::Normalisation>(round % 3);
    agent.policy.confidence_mode =
        static_cast<kg_mission::ConfidenceMode>(round / 3 % 3);
    WindowRasters rasters = RandomRasters(rng, grid);
    const float odd[] = {1e38f, -1e38f, 1e-42f,
                         std::numeric_limits<float>::infinity()};
    rasters.value[rng() % rasters.value.size()] = odd[round % 4];
    const bool horizon = round / 3 % 3 == 2;
    const HorizonScale scale =
        MeasureHorizon(mission, agent, {rasters, rasters, rasters});
    const MissionTensor tensor =
        CompileTensor(mission, agent, mission.windows[1], rasters,
                      horizon ? &scale : nullptr);
    for (const Layer layer : {Layer::kFused, Layer::kReward}) {
      for (const float x : tensor.Get(layer)) {
        EXPECT_TRUE(x >= 0.0f && x <= 1.0f) << Name(layer) << " " << x;
      }
    }
  }
}

TEST(DataPlane, TurnsAConstantFieldIntoOnesByEveryNormalisation) {
  Mission mission = PlainMission();
  const WindowRasters rasters = TestRasters(
      EvenGrid(0, 0, 1, 4, 4), kg_base::Raster(16, 3.0f), kg_base::Mask(16, 0));
  for (int kind = 0; kind < 3; ++kind) {
    mission.agents[0].policy.normalisation =
        static_cast<kg_mission::Normalisation>(kind);
    EXPECT_EQ(kg_base::Raster(16, 1.0f), FusedOf(mission, rasters));
  }
}

TEST(DataPlane, LeavesAnAllZeroAndAnAllLandFieldAtZero) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 4, 4);
  const kg_base::Raster zero(16, 0.0f);
  EXPECT_EQ(zero, FusedOf(PlainMission(),
                          TestRasters(grid, zero, kg_base::Mask(16, 0))));
  EXPECT_EQ(zero,
            FusedOf(PlainMission(), TestRasters(grid, kg_base::Raster(16, kGap),
                                                kg_base::Mask(16, 1))));
}

TEST(DataPlane, KeepsForbiddenCellsExactlyZeroAndTheirPeaksOutOfTheScale) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 4, 4);
  kg_base::Raster value(16, 1.0f);
  value[5] = 1000.0f;
  Mission mission = PlainMission();
  mission.constraints.resize(1);
  mission.constraints[0] =
      AreaConstraint("ex:no", ConstraintKind::kNoGo, Box(.9, .9, 1.1, 1.1));
  const kg_base::Raster fused =
      FusedOf(mission, TestRasters(grid, value, kg_base::Mask(16, 0)));
  EXPECT_EQ(0.0f, fused[5]);
  EXPECT_EQ(1.0f, fused[4]);
}

// Before N, the finite difference with respect to a weight is its layer.
TEST(DataPlane, ChangesOneTermOnlyWithEachWeight) {
  std::mt19937 rng(8);
  const kg_base::Grid grid = UnevenGrid(rng, 9, 9);
  const Mission mission = RandomMission(rng, grid);
  const WindowRasters rasters = RandomRasters(rng, grid);
  const auto policy_layer =
      [&](const std::function<void(kg_mission::Policy*)>& f) {
        Agent agent = mission.agents[1];
        f(&agent.policy);
        return CompileTensor(mission, agent, mission.windows[0], rasters)
            .Get(Layer::kPolicy);
      };
  const auto same = policy_layer([](kg_mission::Policy*) {});
  EXPECT_EQ(same, policy_layer([](auto* p) { p->alpha_base += 1; }));
  EXPECT_EQ(same, policy_layer([](auto* p) { p->gamma_front += 1; }));
  const auto more = policy_layer([](auto* p) { p->beta["ex:p0"] += 1; });
  for (int i = 0; i < 81; ++i) {
    const bool in =
        mission.priors[0].area->Contains(grid.Centre({i / 9, i % 9}));
    EXPECT_NEAR(in ? 1.0 : 0.0, more[i] - same[i], 1e-6);
  }
}

TEST(DataPlane, WeighsLaterWindowsByTheirConfidenceUnlessToldPre) {
  const WindowRasters rasters =
      TestRasters(EvenGrid(0, 0, 1, 2, 2), {1, 2, 3, 4}, kg_base::Mask(4, 0));
  const double w[7] = {1.0,    0.8869, 0.7866, 0.6977,
                       0.6188, 0.5488, 0.4868};  // exp(-0.12 t).
  for (int t = 0; t < 7; ++t) {
    Mission mission = PlainMission(std::exp(-0.12 * t));
    EXPECT_NEAR(w[t], FusedOf(mission, rasters)[3], 5e-5);
    const MissionTensor tensor =
        CompileTensor(mission, mission.agents[0], mission.windows[0], rasters);
    EXPECT_NEAR(1.0 - w[t], tensor.Get(Layer::kUncertainty)[0], 5e-5);
    EXPECT_EQ(1.0f, tensor.Get(Layer::kReward)[3]);
    mission.agents[0].policy.confidence_mode = kg_mission::ConfidenceMode::kPre;
    EXPECT_FLOAT_EQ(1.0f, FusedOf(mission, rasters)[3]);
  }
}

TEST(DataPlane, HoldsTheHorizonsWindowsToOneScale) {
  Mission mission = PlainMission();
  mission.windows.push_back(TestWindow(1, 0.5));
  Agent& agent = mission.agents[0];
  agent.policy.confidence_mode = kg_mission::ConfidenceMode::kHorizon;
  agent.policy.beta = {{"ex:p", 1.0}};
  mission.priors.push_back({"ex:p", "", Box(-1, -1, 2, 2), 0, {1}, {}});
  const WindowRasters rasters =
      TestRasters(EvenGrid(0, 0, 1, 2, 2), {1, 2, 3, 4}, kg_base::Mask(4, 0));
  const HorizonScale scale = MeasureHorizon(mission, agent, {rasters, rasters});
  EXPECT_DOUBLE_EQ(1.0, scale.range);  // Window 0: 1; window 1: 0.5 * 2.
  const auto at = [&](int t) {
    return CompileTensor(mission, agent, mission.windows[t], rasters, &scale)
        .Get(Layer::kFused);
  };
  EXPECT_FLOAT_EQ(0.25f, at(0)[0]);
  EXPECT_FLOAT_EQ(0.5f * 1.25f, at(1)[0]);
  EXPECT_THROW(CompileTensor(mission, agent, mission.windows[0], rasters),
               std::logic_error);
}

TEST(DataPlane, HashIsTheContentsAndNotTheAgentsName) {
  std::mt19937 rng(9);
  const kg_base::Grid grid = UnevenGrid(rng, 8, 8);
  Mission mission = RandomMission(rng, grid);
  mission.agents[1].policy = mission.agents[0].policy;
  mission.agents[1].policy.iri = "ex:another_name";
  const WindowRasters rasters = RandomRasters(rng, grid);
  const auto hash = [&](int agent, int t) {
    return TensorHash(mission, mission.agents[agent], mission.windows[t],
                      rasters);
  };
  EXPECT_NE(hash(0, 0), hash(1, 0));  // The land buffer names alpha.
  mission.constraints[3].agents.clear();
  EXPECT_EQ(hash(0, 0), hash(1, 0));
  EXPECT_EQ(hash(0, 0), CompileTensor(mission, mission.agents[0],
                                      mission.windows[0], rasters)
                            .hash);
  const std::string before0 = hash(0, 0), before1 = hash(0, 1);
  mission.constraints[2].attenuation = 0.65;  // In force in window 1 only.
  EXPECT_EQ(before0, hash(0, 0));
  EXPECT_NE(before1, hash(0, 1));
}

TEST(DataPlane, HashCoversExactlyTheInputsRead) {
  std::mt19937 rng(10);
  const kg_base::Grid grid = UnevenGrid(rng, 8, 8);
  const Mission base = RandomMission(rng, grid);
  WindowRasters rasters = RandomRasters(rng, grid);
  const auto hash = [&](const std::function<void(Mission*)>& change) {
    Mission mission = base;
    change(&mission);
    return TensorHash(mission, mission.agents[0], mission.windows[0], rasters);
  };
  const std::string same = hash([](Mission*) {});
  const std::vector<std::function<void(Mission*)>> read = {
      [](Mission* m) { m->windows[0].confidence = 0.9; },
      [](Mission* m) { m->agents[0].policy.alpha_base += 1e-9; },
      [](Mission* m) { m->agents[0].policy.gamma_front = 0; },
      [](Mission* m) { m->agents[0].policy.beta["ex:p1"] = 0.6; },
      [](Mission* m) { m->agents[0].policy.beta_poi = 0.1; },
      [](Mission* m) { m->agents[0].policy.soft_overrides["ex:c1"] = 0.2; },
      [](Mission* m) { m->agents[0].must_avoid["ex:c1"] = {"ex:i1"}; },
      [](Mission* m) {
        m->agents[0].policy.normalisation = kg_mission::Normalisation::kMinMax;
      },
      [](Mission* m) { m->constraints[0].buffer_cells = 1; },
      [](Mission* m) { m->constraints[0].area = Box(0, 0, 1, 1); },
      [](Mission* m) { m->priors[0].area = Box(0, 0, 1, 1); },
      [](Mission* m) { m->priors[1].edge_m = 1; },
      [](Mission* m) { m->events[0].value = 9; },
      [](Mission* m) { m->events[0].position.lon_deg += 0.01; },
      [](Mission* m) { m->events[0].windows = {2}; }};
  for (std::size_t i = 0; i < read.size(); ++i) {
    EXPECT_NE(same, hash(read[i])) << i;
  }
  const std::vector<std::function<void(Mission*)>> unread = {
      [](Mission* m) { m->constraints[2].attenuation = 0.1; },  // Window 1.
      [](Mission* m) { m->constraints[1].attenuation = 0.1; },  // Overridden.
      [](Mission* m) { m->agents[0].capabilities.cruise_mps = 9; },
      [](Mission* m) { m->agents[0].policy.lambda_time_per_s = 9; },
      [](Mission* m) { m->agents[1].policy.alpha_base = 9; },
      [](Mission* m) { m->windows[1].confidence = 0; },
      [](Mission* m) { m->events[0].capacity = 5; }};
  for (std::size_t i = 0; i < unread.size(); ++i) {
    EXPECT_EQ(same, hash(unread[i])) << i;
  }
}

// Mission and rasters that a test case may modify.
struct HashedWorld {
  Mission mission;
  WindowRasters rasters;
  kg_mission::Policy& policy() { return mission.agents[0].policy; }
  std::string Hash() const {
    return TensorHash(mission, mission.agents[0], mission.windows[0], rasters);
  }
};
using Change = void (*)(HashedWorld*);

void Nothing(HashedWorld*) {}
void NoFront(HashedWorld* w) { w->policy().gamma_front = 0.0; }
void NoValue(HashedWorld* w) {
  w->policy().gamma_front = w->policy().alpha_base = 0.0;
}
void Literal(HashedWorld* w) { w->policy().paper_literal = true; }
void Central(HashedWorld* w) {
  w->policy().front_operator = kg_mission::FrontOperator::kCentral;
}
void Unscaled(HashedWorld* w) {
  w->policy().layer_scale = kg_mission::LayerScale::kNone;
}
void Fixed(HashedWorld* w) {
  w->policy().layer_scale = kg_mission::LayerScale::kFixed;
}
void FixedWithoutFront(HashedWorld* w) {
  Fixed(w);
  NoFront(w);
}
void MinMax(HashedWorld* w) {
  w->policy().normalisation = kg_mission::Normalisation::kMinMax;
}
void Least(HashedWorld* w) {
  w->policy().soft_overlap = kg_mission::SoftOverlap::kMin;
}
void TwoZones(HashedWorld* w) { w->mission.constraints[2].windows.clear(); }
void OneZone(HashedWorld* w) { w->mission.constraints[2].windows = {1}; }
void FullScale(HashedWorld* w) { w->rasters.full_scale = 4.0; }
void FrontFullScale(HashedWorld* w) { w->rasters.front_full_scale = 4.0; }
void Square(HashedWorld* w) {
  w->mission.constraints[3].buffer_metric =
      kg_mission::BufferMetric::kChebyshev;
}
void SquareOfNothing(HashedWorld* w) {
  w->mission.constraints[0].buffer_metric =
      kg_mission::BufferMetric::kChebyshev;
}
void Hazard(HashedWorld* w) { w->policy().hazard_range_m = 1.0; }
void Isolation(HashedWorld* w) { w->policy().isolation_weight = 9.0; }

// Every option, where it affects the result and where it does not.
TEST(DataPlane, HashCoversAnOptionWhereItMatters) {
  std::mt19937 rng(31);
  const kg_base::Grid grid = UnevenGrid(rng, 8, 8);
  HashedWorld base{RandomMission(rng, grid), RandomRasters(rng, grid)};
  base.rasters.full_scale = 3.0;
  base.rasters.front_full_scale = 0.5;
  struct Case {
    const char* name;
    Change where, what;
    bool matters;
  };
  const std::vector<Case> cases = {
      {"literal", Nothing, Literal, true},
      {"normalisation", Nothing, MinMax, true},
      {"normalisation, literal", Literal, MinMax, false},
      {"operator", Nothing, Central, true},
      {"operator without F", NoFront, Central, false},
      {"scale", Nothing, Unscaled, true},
      {"scale without B and F", NoValue, Unscaled, false},
      {"scale, literal", Literal, Unscaled, false},
      {"full scale of windows", Nothing, FullScale, false},
      {"full scale, fixed", Fixed, FullScale, true},
      {"front's full scale of windows", Nothing, FrontFullScale, false},
      {"front's full scale, fixed", Fixed, FrontFullScale, true},
      {"that without F", FixedWithoutFront, FrontFullScale, false},
      {"buffer's metric", Nothing, Square, true},
      {"metric of no buffer", Nothing, SquareOfNothing, false},
      {"overlap of two zones", TwoZones, Least, true},
      {"overlap of one zone", OneZone, Least, false},
      {"hazard range", Nothing, Hazard, false},
      {"isolation", Nothing, Isolation, false}};
  for (const Case& c : cases) {
    HashedWorld before = base;
    c.where(&before);
    HashedWorld after = before;
    c.what(&after);
    EXPECT_EQ(c.matters, before.Hash() != after.Hash()) << c.name;
  }
}

// A raster is identified by its file's contents and the part that is read.
TEST(DataPlane, HashCoversWhatARasterIsReadFrom) {
  std::mt19937 rng(32);
  const kg_base::Grid grid = UnevenGrid(rng, 8, 8);
  Mission base = RandomMission(rng, grid);
  const WindowRasters rasters = RandomRasters(rng, grid);
  base.files["ex:f"] = {"ex:f", "a.nc", "1234"};
  base.files["ex:copy"] = {"ex:copy", "b.nc", "1234"};
  base.priors[0].area.reset();
  base.priors[0].raster = kg_mission::RasterRef{"ex:f", "p", 0};
  base.constraints[0].area.reset();
  base.constraints[0].mask = kg_mission::RasterRef{"ex:f", "m", 0};
  const auto hash = [&](const std::function<void(Mission*)>& change) {
    Mission mission = base;
    change(&mission);
    return TensorHash(mission, mission.agents[0], mission.windows[0], rasters);
  };
  const std::string same = hash([](Mission*) {});
  const auto refs = {+[](Mission* m) { return &*m->priors[0].raster; },
                     +[](Mission* m) { return &*m->constraints[0].mask; }};
  for (const auto& ref : refs) {
    EXPECT_EQ(same, hash([&](Mission* m) { ref(m)->file_iri = "ex:copy"; }));
    EXPECT_NE(same, hash([&](Mission* m) { ref(m)->variable = "other"; }));
    EXPECT_NE(same, hash([&](Mission* m) { ref(m)->time_index = 1; }));
    EXPECT_NE(same, hash([&](Mission* m) {
                ref(m)->resampling = kg_base::Resampling::kNearest;
              }));
  }
  EXPECT_NE(same, hash([](Mission* m) { m->files["ex:f"].sha256 = "5678"; }));
  EXPECT_EQ(same, hash([](Mission* m) { m->files["ex:f"].path = "c.nc"; }));
}

TEST(DataPlane, DerivesFromExactlyTheFactsItRead) {
  std::mt19937 rng(13);
  const kg_base::Grid grid = UnevenGrid(rng, 8, 8);
  Mission mission = RandomMission(rng, grid);
  const WindowRasters rasters = RandomRasters(rng, grid);
  const auto sources = [&](int agent, int t) {
    return CompileTensor(mission, mission.agents[agent], mission.windows[t],
                         rasters)
        .derived_from;
  };
  using List = std::vector<std::string>;
  EXPECT_EQ((List{"ex:c0", "ex:c1", "ex:e0", "ex:field", "ex:p0", "ex:p1",
                  "ex:policy", "ex:value", "ex:value_file", "ex:w0"}),
            sources(1, 0));
  EXPECT_EQ((List{"ex:alpha", "ex:c0", "ex:c1", "ex:c3", "ex:field", "ex:p0",
                  "ex:p1", "ex:policy", "ex:value", "ex:value_file", "ex:w2"}),
            sources(0, 2));
  mission.agents[1].must_avoid = {{"ex:c1", {"ex:i1", "ex:i2"}},
                                  {"ex:c9", {"ex:i9"}}};
  mission.agents[1].policy = kg_mission::Policy();
  mission.agents[1].policy.alpha_base = 0.0;
  EXPECT_EQ((List{"ex:c0", "ex:c1", "ex:field", "ex:i1", "ex:i2", "ex:w0"}),
            sources(1, 0));
}

TEST(DataPlane, RefusesRastersOfAnotherSize) {
  const Mission mission = PlainMission();
  WindowRasters rasters = TestRasters(EvenGrid(0, 0, 1, 2, 2),
                                      kg_base::Raster(4), kg_base::Mask(4));
  rasters.value.pop_back();
  EXPECT_THROW(FusedOf(mission, rasters), std::logic_error);
}

}  // namespace
}  // namespace kg_compiler
