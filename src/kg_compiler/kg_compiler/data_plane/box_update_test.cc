// Incremental updates are bit-identical to compiling from scratch; sparse masks
// equal those of the whole grid; every option agrees with the double-precision
// reference.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <future>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_compiler/data_plane/blend_recipe.h"
#include "kg_compiler/data_plane/compiled_tensor.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_compiler/data_plane/masks.h"
#include "kg_compiler/data_plane/patches.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

using kg_mission::Agent;
using kg_mission::ConstraintKind;
using kg_mission::Mission;

constexpr Layer kLayers[] = {Layer::kReward,      Layer::kUncertainty,
                             Layer::kPolicy,      Layer::kAttenuation,
                             Layer::kFeasibility, Layer::kFused};

// A window on a grid of several tiles, with coast, gaps and valid hashes.
class World {
 public:
  explicit World(unsigned seed, int rows = 53, int cols = 301)
      : rng_(seed), grid_(UnevenGrid(rng_, rows, cols)) {
    mission.windows = {TestWindow(0, 0.8)};
    mission.agents = {TestAgent("alpha")};
    RandomPolicy();
    NewRasters();
    for (int i = 0; i < 6; ++i) AddConstraint();
    for (int i = 0; i < 3; ++i) AddPrior();
    for (int i = 0; i < 2; ++i) AddEvent();
  }

  void NewRasters() {
    kg_base::Mask land(grid_.size(), 0);
    for (int r = 0; r < grid_.rows(); ++r) {
      const int shore = grid_.cols() / 6 + static_cast<int>(rng_() % 4);
      for (int c = 0; c < shore; ++c) land[grid_.Index({r, c})] = 1;
    }
    kg_base::Raster value = RandomRaster(rng_, grid_.size(), -0.5, 3.0);
    for (std::size_t i = 0; i < value.size(); ++i) {
      if (land[i] || rng_() % 500 == 0) value[i] = kGap;
    }
    if (rng_() % 2) value[rng_() % value.size()] = INFINITY;
    rasters = TestRasters(grid_, value, land);
    rasters.full_scale = 2.5;
    rasters.front_full_scale = 0.7;
    kg_base::Hasher hash;
    hash.Add(grid_.Hash());
    for (const auto cell : land) hash.Add(static_cast<double>(cell));
    rasters.land_hash = hash.Hex();
    hash.Add(value);
    rasters.content_hash = hash.Hex();
    auto prior = std::make_shared<kg_base::Raster>(
        RandomRaster(rng_, grid_.size(), -1.0, 1.0));
    (*prior)[7] = kGap;
    rasters.prior_rasters["ex:reef"] = prior;
    rasters.constraint_masks["ex:mask"] =
        std::make_shared<kg_base::Mask>(RandomMask(rng_, grid_.size(), 0.002));
  }

  void RandomPolicy() {
    kg_mission::Policy& policy = mission.agents[0].policy;
    policy.alpha_base = Chance(5) ? 0.0 : Uniform(rng_, 0.2, 1.5);
    policy.gamma_front = Chance(3) ? 0.0 : Uniform(rng_, 0.1, 1.5);
    policy.beta_poi = Uniform(rng_, 0.0, 0.5);
    policy.normalisation = static_cast<kg_mission::Normalisation>(rng_() % 3);
    policy.confidence_mode =
        static_cast<kg_mission::ConfidenceMode>(rng_() % 2);
    policy.front_operator = static_cast<kg_mission::FrontOperator>(rng_() % 2);
    policy.layer_scale = static_cast<kg_mission::LayerScale>(rng_() % 3);
    policy.soft_overlap = static_cast<kg_mission::SoftOverlap>(rng_() % 2);
    policy.paper_literal = Chance(8);
  }

  void AddConstraint() {
    const std::string iri = "ex:c" + std::to_string(rng_());
    mission.constraints.push_back(AreaConstraint(
        iri, Chance(2) ? ConstraintKind::kNoGo : ConstraintKind::kSoft,
        AnyBox()));
    kg_mission::Constraint& added = mission.constraints.back();
    if (Chance(8)) {
      added.area.reset();
      added.is_land = true;
    } else if (Chance(8)) {
      added.iri = "ex:mask";
      added.area.reset();
      added.mask = kg_mission::RasterRef{"ex:masks", "m", 0};
    }
    added.attenuation = Uniform(rng_, 0, 1);
    added.buffer_cells = Chance(2) ? 0.0 : Uniform(rng_, 0, 4);
    added.buffer_metric = static_cast<kg_mission::BufferMetric>(rng_() % 2);
  }
  void AddPrior() {
    const std::string iri = "ex:p" + std::to_string(rng_());
    mission.priors.push_back({iri,
                              "p",
                              AnyBox(),
                              Chance(2) ? 0.0 : Uniform(rng_, 1e3, 1e4),
                              {},
                              {}});
    if (Chance(4)) {
      mission.priors.back().iri = "ex:reef";
      mission.priors.back().area.reset();
      mission.priors.back().raster = kg_mission::RasterRef{"ex:reefs", "p", 0};
    }
    mission.agents[0].policy.beta[mission.priors.back().iri] =
        Uniform(rng_, -0.5, 1);
  }
  void AddEvent() {
    kg_mission::Event event;
    event.iri = "ex:e" + std::to_string(rng_());
    event.position = AnyPlace();
    event.value = Uniform(rng_, 0, 2);
    event.radius_m = Uniform(rng_, 2e3, 2e4);
    event.windows = {0};
    mission.events.push_back(event);
  }

  // Changes one or a few facts at once.
  void Change() {
    do {
      ChangeOne();
    } while (Chance(3));
  }

  TensorInputs Inputs(DataPlaneCache* cache = nullptr) const {
    return {
        &mission, &mission.agents[0], &mission.windows[0], &rasters, nullptr,
        cache};
  }
  bool Chance(unsigned of) { return rng_() % of == 0; }
  kg_base::LonLat AnyPlace() {
    return {Uniform(rng_, grid_.west_deg(), grid_.east_deg()),
            Uniform(rng_, grid_.south_deg(), grid_.north_deg())};
  }
  kg_base::Geometry AnyBox() {
    const kg_base::LonLat corner = AnyPlace();
    return Box(corner.lon_deg, corner.lat_deg,
               corner.lon_deg + Uniform(rng_, 0.01, 1.0),
               corner.lat_deg + Uniform(rng_, 0.01, 0.5));
  }

  Mission mission;
  WindowRasters rasters;

 private:
  template <typename T>
  void Drop(std::vector<T>* list) {
    if (!list->empty()) list->erase(list->begin() + rng_() % list->size());
  }
  void ChangeOne() {
    switch (rng_() % 11) {
      case 0:
        return AddConstraint();
      case 1:
        return Drop(&mission.constraints);
      case 2:
        return AddPrior();
      case 3:
        return Drop(&mission.priors);
      case 4:
        return AddEvent();
      case 5:
        return Drop(&mission.events);
      case 6:
        if (!mission.constraints.empty()) {
          mission.constraints[rng_() % mission.constraints.size()].attenuation =
              Uniform(rng_, 0, 1);
        }
        return;
      case 7:
        mission.windows[0].confidence = Uniform(rng_, 0, 1);
        return;
      case 8:
        if (!mission.events.empty()) mission.events[0].position = AnyPlace();
        return;
      case 9:
        if (Chance(4)) RandomPolicy();
        return;
      case 10:
        if (Chance(6)) NewRasters();
        return;
    }
  }

  std::mt19937 rng_;
  kg_base::Grid grid_;
};

// Bitwise comparison: NaN equals NaN (land in feasibility).
bool SameBits(const kg_base::Raster& a, const kg_base::Raster& b) {
  return a.size() == b.size() &&
         std::equal(a.begin(), a.end(), b.begin(), [](float x, float y) {
           return x == y ? std::signbit(x) == std::signbit(y)
                         : std::isnan(x) && std::isnan(y);
         });
}

void ExpectSame(const MissionTensor& a, const MissionTensor& b) {
  EXPECT_EQ(a.hash, b.hash);
  for (const Layer layer : kLayers) {
    EXPECT_TRUE(SameBits(a.Get(layer), b.Get(layer))) << Name(layer);
  }
}

TEST(BoxUpdate, GivesTheBitsOfTheWholePassAfterAnySequenceOfChanges) {
  int none = 0, some = 0, all = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    World world(seed);
    DataPlaneCache cache;
    MissionTensor last = CompileTensor(world.Inputs(), nullptr);
    for (int step = 0; step < 25; ++step) {
      world.Change();
      DataPlaneCache* const shared = step % 2 ? &cache : nullptr;
      MissionTensor next = CompileTensor(world.Inputs(shared), &last);
      SCOPED_TRACE(std::to_string(seed) + " " + std::to_string(step));
      ExpectSame(CompileTensor(world.Inputs(), nullptr), next);
      const std::size_t cells = world.rasters.grid.size();
      ++(next.cells_computed == 0      ? none
         : next.cells_computed < cells ? some
                                       : all);
      last = std::move(next);
    }
  }
  EXPECT_GT(none, 20);
  EXPECT_GT(some, 60);
  EXPECT_GT(all, 20);
}

TEST(BoxUpdate, ComputesTheBoxesOnlyAndLeavesTheTensorBeforeAsItWas) {
  World world(3, 200, 400);
  world.mission.constraints.clear();
  kg_mission::Policy& policy = world.mission.agents[0].policy;
  policy = kg_mission::Policy();
  policy.gamma_front = 0.5;
  const MissionTensor first = CompileTensor(world.Inputs(), nullptr);
  EXPECT_EQ(world.rasters.grid.size(), first.cells_computed);
  const kg_base::Raster before = first.Get(Layer::kFused);
  const kg_base::Grid& grid = world.rasters.grid;
  const auto at = [&](int row, int col) { return grid.Centre({row, col}); };
  world.mission.constraints = {
      AreaConstraint("ex:a", ConstraintKind::kSoft,
                     Box(at(40, 200).lon_deg, at(40, 200).lat_deg,
                         at(79, 239).lon_deg, at(79, 239).lat_deg))};
  world.mission.constraints[0].attenuation = 0.4;
  const MissionTensor second = CompileTensor(world.Inputs(), &first);
  EXPECT_GE(second.cells_computed,
            38u * 38u);  // Centres on the edge may round.
  EXPECT_LE(second.cells_computed, 40u * 40u);
  world.mission.windows[0].confidence = 0.3;  // V is unchanged.
  EXPECT_EQ(0u, CompileTensor(world.Inputs(), &second).cells_computed);
  EXPECT_EQ(0u, CompileTensor(world.Inputs(), &second).cells_computed);
  EXPECT_TRUE(SameBits(before, first.Get(Layer::kFused)));
  EXPECT_FALSE(SameBits(before, second.Get(Layer::kFused)));
}

TEST(BoxUpdate, DoesAllAgainWhereALayersScaleChanges) {
  World world(4);
  world.mission.constraints.clear();
  kg_mission::Policy& policy = world.mission.agents[0].policy;
  policy = kg_mission::Policy();
  const kg_base::Grid& grid = world.rasters.grid;
  const int peak = grid.cols() - 20;
  world.rasters.value[grid.Index({20, peak})] = 50.0f;
  const MissionTensor first = CompileTensor(world.Inputs(), nullptr);
  const kg_base::LonLat at = grid.Centre({20, peak});
  world.mission.constraints = {
      AreaConstraint("ex:a", ConstraintKind::kNoGo,
                     Box(at.lon_deg - 1e-3, at.lat_deg - 1e-3,
                         at.lon_deg + 1e-3, at.lat_deg + 1e-3))};
  const MissionTensor second = CompileTensor(world.Inputs(), &first);
  EXPECT_EQ(grid.size(), second.cells_computed);
  ExpectSame(CompileTensor(world.Inputs(), nullptr), second);
}

// The reference in double precision, with every option.
kg_base::Raster FusedByReference(const TensorInputs& in) {
  const ActiveFacts active =
      FindActiveFacts(*in.mission, *in.agent, *in.window);
  const TensorBlend made =
      BlendTensor(*in.agent, *in.window, *in.rasters, active, nullptr);
  kg_base::Raster fused(in.rasters->grid.size(), 0.0f);
  for (std::size_t i = 0; i < fused.size(); ++i) {
    if (!made.blend.counted[i]) continue;
    fused[i] =
        static_cast<float>(made.after * made.n.Apply(made.blend.masked[i]));
  }
  return fused;
}

TEST(FusedPass, AgreesWithTheDoublePrecisionReferenceForEveryOption) {
  for (unsigned seed = 1; seed <= 60; ++seed) {
    World world(seed, 40, 290);
    const MissionTensor tensor = CompileTensor(world.Inputs(), nullptr);
    const kg_base::Raster fused = tensor.Get(Layer::kFused);
    const kg_base::Raster wanted = FusedByReference(world.Inputs());
    for (std::size_t i = 0; i < fused.size(); ++i) {
      ASSERT_NEAR(wanted[i], fused[i], 1e-6) << seed << " cell " << i;
    }
  }
}

TEST(FusedPass, AtIsTheWholeLayersBitInEveryCell) {
  for (unsigned seed = 1; seed <= 8; ++seed) {
    World world(seed, 20, 280);
    const MissionTensor tensor = CompileTensor(world.Inputs(), nullptr);
    for (const Layer layer : kLayers) {
      kg_base::Raster one_by_one;
      for (std::size_t i = 0; i < world.rasters.grid.size(); ++i) {
        one_by_one.push_back(tensor.At(layer, i));
      }
      EXPECT_TRUE(SameBits(tensor.Get(layer), one_by_one)) << Name(layer);
    }
  }
}

TEST(FusedPass, GoesTheSlowWayWhereFloatsWouldOverflow) {
  for (const float huge : {1e38f, 3e37f, 1e-38f}) {
    World world(9, 20, 30);
    kg_mission::Policy& policy = world.mission.agents[0].policy;
    policy = kg_mission::Policy();
    policy.gamma_front = 0.7;
    for (float& x : world.rasters.value) x *= huge;
    const kg_base::Raster fused =
        CompileTensor(world.Inputs(), nullptr).Get(Layer::kFused);
    const kg_base::Raster wanted = FusedByReference(world.Inputs());
    for (std::size_t i = 0; i < fused.size(); ++i) {
      ASSERT_NEAR(wanted[i], fused[i], 1e-6) << huge;
    }
    EXPECT_GT(*std::max_element(fused.begin(), fused.end()), 0.5f);
  }
}

TEST(FusedPass, SaysWhichScaleIsMissingWhereItIsFixed) {
  World world(2);
  kg_mission::Policy& policy = world.mission.agents[0].policy;
  policy = kg_mission::Policy();
  policy.layer_scale = kg_mission::LayerScale::kFixed;
  world.rasters.full_scale.reset();
  EXPECT_THROW(CompileTensor(world.Inputs(), nullptr), kg_base::InputError);
  policy.alpha_base = 0.0;
  EXPECT_NO_THROW(CompileTensor(world.Inputs(), nullptr));
}

// Computed by hand: V = B + P, soft zone of 0.5 in the west, hard zone in the
// middle; w = 0.5.
TEST(PaperLiteral, MasksAndWeighsBeforeItNormalisesOverAllWater) {
  const kg_base::Grid grid = EvenGrid(0, 0, 1, 2, 3);
  World world(1);
  Mission& mission = world.mission;
  mission.windows = {TestWindow(0, 0.5)};
  mission.events.clear();
  mission.priors.clear();
  mission.agents = {TestAgent("alpha")};
  mission.agents[0].policy.paper_literal = true;
  mission.constraints = {
      AreaConstraint("ex:soft", ConstraintKind::kSoft, Box(-.4, -1, .4, 2)),
      AreaConstraint("ex:hard", ConstraintKind::kNoGo, Box(.9, -.1, 1.1, .1))};
  mission.constraints[0].attenuation = 0.5;
  world.rasters =
      TestRasters(grid, {-4, 100, 2, 8, 6, kGap}, {0, 0, 0, 0, 0, 1});
  // w V M: -1 0 1, 2 3 land; the forbidden cell is lifted above 0 (see A4).
  const kg_base::Raster wanted = {0.f, 0.25f, 0.5f, 0.75f, 1.f, 0.f};
  const MissionTensor tensor = CompileTensor(world.Inputs(), nullptr);
  const kg_base::Raster fused = tensor.Get(Layer::kFused);
  for (int i = 0; i < 6; ++i) EXPECT_NEAR(wanted[i], fused[i], 1e-6) << i;
  EXPECT_EQ(0.0f, tensor.At(Layer::kFeasibility, 1));
}

TEST(Patches, AreTheWholeGridsMasks) {
  for (unsigned seed = 1; seed <= 80; ++seed) {
    World world(seed, 30, 40);
    for (int i = 0; i < 8; ++i) world.AddConstraint();
    const ActiveFacts active = FindActiveFacts(
        world.mission, world.mission.agents[0], world.mission.windows[0]);
    for (const ActiveConstraint& constraint : active.constraints) {
      const MaskPatch patch = ConstraintPatch(world.rasters, constraint, "");
      kg_base::Mask whole(world.rasters.grid.size(), 0);
      for (int r = patch.box.row; r < patch.box.row_end; ++r) {
        std::copy(patch.Row(r), patch.Row(r) + patch.box.cols(),
                  &whole[world.rasters.grid.Index({r, patch.box.col})]);
      }
      EXPECT_EQ(ConstraintExtent(world.rasters, constraint), whole) << seed;
    }
  }
}

// The buffer of an area beyond one edge: the cells within reach of the cells
// that the area would cover if the grid went on.
TEST(Patches, ABufferGrowsFromBeyondEveryEdge) {
  World world(1, 20, 30);
  world.rasters.grid = EvenGrid(-92, 23, 0.05, 20, 30);
  world.rasters.land.assign(world.rasters.grid.size(), 0);
  const kg_base::Grid& grid = world.rasters.grid;
  struct Side {
    kg_base::Geometry area;  // Its nearest cells are the second beyond.
    std::function<int(kg_base::Cell)> cells_to_edge;
  };
  const double w = grid.west_deg(), e = grid.east_deg();
  const double s = grid.south_deg(), n = grid.north_deg();
  const std::vector<Side> sides = {
      {Box(w - 0.5, s, w - 0.07, n), [](kg_base::Cell c) { return c.col; }},
      {Box(e + 0.07, s, e + 0.5, n),
       [](kg_base::Cell c) { return 29 - c.col; }},
      {Box(w, s - 0.5, e, s - 0.07), [](kg_base::Cell c) { return c.row; }},
      {Box(w, n + 0.07, e, n + 0.5),
       [](kg_base::Cell c) { return 19 - c.row; }}};
  for (const Side& side : sides) {
    for (const double buffer : {0.0, 1.0, 2.0, 3.0, 7.0}) {
      kg_mission::Constraint zone =
          AreaConstraint("ex:z", ConstraintKind::kNoGo, side.area);
      zone.buffer_cells = buffer;
      const ActiveConstraint active{
          &zone, &kg_mission::EffectOf(zone.kind), 1.0, {}, ""};
      const kg_base::Mask whole = ConstraintExtent(world.rasters, active);
      const MaskPatch patch = ConstraintPatch(world.rasters, active, "");
      std::size_t closed = 0;
      for (int row = 0; row < 20; ++row) {
        for (int col = 0; col < 30; ++col) {
          const bool is_near = side.cells_to_edge({row, col}) + 2 <= buffer;
          EXPECT_EQ(whole[grid.Index({row, col})] != 0, is_near)
              << buffer << ": " << row << " " << col;
          closed += is_near;
        }
      }
      EXPECT_EQ(std::count(patch.inside.begin(), patch.inside.end(), 1),
                static_cast<std::ptrdiff_t>(closed));
    }
  }
}

TEST(Patches, OfASmallAreaAreSmall) {
  World world(1, 200, 300);
  const kg_base::LonLat at = world.rasters.grid.Centre({100, 150});
  kg_mission::Constraint zone = AreaConstraint(
      "ex:z", ConstraintKind::kNoGo,
      Box(at.lon_deg, at.lat_deg, at.lon_deg + 0.1, at.lat_deg + 0.1));
  zone.buffer_cells = 2;
  const MaskPatch patch = ConstraintPatch(
      world.rasters, {&zone, &kg_mission::EffectOf(zone.kind), 1.0, {}, ""},
      "");
  EXPECT_FALSE(patch.box.empty());
  EXPECT_LT(patch.box.size(), 15u * 15u);
}

TEST(DataPlaneCache, MakesEachThingOnceForAllAgentsAndThreads) {
  World world(5);
  for (int i = 1; i < 6; ++i) {
    world.mission.agents.push_back(world.mission.agents[0]);
    world.mission.agents[i].policy.alpha_base = 0.3 * i;
    world.mission.agents[i].policy.paper_literal = false;
  }
  DataPlaneCache cache;
  const auto compile = [&](int agent, DataPlaneCache* shared) {
    TensorInputs in = world.Inputs(shared);
    in.agent = &world.mission.agents[agent];
    return CompileTensor(in, nullptr);
  };
  const MissionTensor first = compile(1, &cache);
  const int made = cache.made();
  EXPECT_GT(made, 5);
  std::vector<std::future<MissionTensor>> tensors;
  for (int i = 2; i < 6; ++i) {
    tensors.push_back(std::async(std::launch::async, compile, i, &cache));
  }
  for (int i = 2; i < 6; ++i) {
    ExpectSame(compile(i, nullptr), tensors[i - 2].get());
  }
  EXPECT_EQ(made, cache.made());
}

}  // namespace
}  // namespace kg_compiler
