#include "kg_compiler/compile/raster_store.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_compiler/testing/test_world.h"

namespace kg_compiler {
namespace {

using kg_base::Raster;
using kg_mission::LayerScale;
using kg_mission::Mission;
using kg_mission::Policy;

constexpr int kWindows = 4;
const kg_base::Grid kGrid = EvenGrid(-91, 24, 0.04, 6, 5);

Mission TestMission() {
  Mission mission;
  mission.files["ex:file"] = {"ex:file", "/file.nc", "sha"};
  mission.files["ex:habitat"] = {"ex:habitat", "/habitat.nc", "sha2"};
  for (int t = 0; t < kWindows; ++t) {
    const std::string name = std::to_string(t);
    mission.windows.push_back(TestWindow(t, 1.0));
    mission.work_fields.push_back({"ex:field" + name, t, "ex:file", t, t + 1});
    mission.value_layers.push_back(
        {"ex:value" + name, t, "delta_sst", "ex:file", t + 1, t});
  }
  for (const char* name : {"reefs", "kelp"}) {
    kg_mission::PriorLayer prior;
    prior.iri = std::string("ex:") + name;
    prior.raster = kg_mission::RasterRef{"ex:habitat", name, 0};
    mission.priors.push_back(prior);
  }
  kg_mission::Constraint farm;
  farm.iri = "ex:farm";
  farm.mask = kg_mission::RasterRef{"ex:habitat", "farm", 0};
  farm.windows = {1, 2};
  mission.constraints = {farm};
  return mission;
}

Policy Weighing(const std::vector<std::string>& priors) {
  Policy policy;
  policy.iri = "ex:policy";
  for (const std::string& prior : priors) policy.beta[prior] = 0.5;
  return policy;
}

// Counts the reads, by name.
struct Files {
  RasterReaders Readers() {
    return {
        [this](const Mission&, const kg_mission::WorkFieldRef& ref) {
          read.insert(ref.iri);
          return UniformFlow(grid_of.count(ref.iri) ? grid_of[ref.iri] : kGrid,
                             0.1, 0.2);
        },
        [this](const Mission&, const kg_mission::ValueLayer& layer,
               const kg_base::Grid& grid) {
          read.insert(layer.iri);
          return Raster(grid.size(), static_cast<float>(layer.time_index));
        },
        [this](const Mission&, const std::string& iri,
               const kg_mission::RasterRef& ref, const kg_base::Grid& grid) {
          read.insert(iri);
          Raster values(grid.size(), static_cast<float>(ref.time_index));
          values[0] = 3.0f;
          values[1] = kNoValue;
          return values;
        }};
  }
  static constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();
  std::map<std::string, kg_base::Grid> grid_of;
  std::multiset<std::string> read;
};

std::shared_ptr<const WindowRasters> RastersOf(RasterStore* store,
                                               const Mission& mission,
                                               const Policy& policy,
                                               int window) {
  return store->Rasters(mission, policy, *store->Field(mission, window));
}

template <typename Function>
std::string Refusal(const Function& function) {
  try {
    function();
  } catch (const kg_base::InputError& error) {
    return error.what();
  }
  return "";
}

TEST(RasterStore, WindowsAndPoliciesShareWhatTheyReadFromFiles) {
  Files files;
  RasterStore store(files.Readers());
  const Mission mission = TestMission();
  std::set<const void*> reefs, farms;
  for (int window = 0; window < kWindows; ++window) {
    for (const auto& priors : std::vector<std::vector<std::string>>{
             {"ex:reefs"}, {"ex:reefs", "ex:kelp"}, {}}) {
      const auto rasters = RastersOf(&store, mission, Weighing(priors), window);
      EXPECT_EQ(rasters->prior_rasters.size(), priors.size());
      if (!priors.empty()) {
        reefs.insert(rasters->prior_rasters.at("ex:reefs").get());
      }
      EXPECT_EQ(rasters->constraint_masks.count("ex:farm"),
                window == 1 || window == 2 ? 1u : 0u);
      for (const auto& mask : rasters->constraint_masks) {
        farms.insert(mask.second.get());
      }
    }
  }
  EXPECT_EQ(reefs.size(), 1u);
  EXPECT_EQ(farms.size(), 1u);
  EXPECT_EQ(files.read.count("ex:reefs"), 1u);
  EXPECT_EQ(files.read.count("ex:kelp"), 1u);
  EXPECT_EQ(files.read.count("ex:farm"), 1u);
}

TEST(RasterStore, PriorsAreAsTheyAreAndMasksInsideOrNot) {
  Files files;
  RasterStore store(files.Readers());
  const auto rasters =
      RastersOf(&store, TestMission(), Weighing({"ex:reefs"}), 1);
  const Raster& reefs = *rasters->prior_rasters.at("ex:reefs");
  EXPECT_EQ(reefs[0], 3.0f);
  EXPECT_TRUE(std::isnan(reefs[1]));
  const kg_base::Mask& farm = *rasters->constraint_masks.at("ex:farm");
  EXPECT_EQ(farm[0], 1);
  EXPECT_EQ(farm[1], 0);
  EXPECT_EQ(farm[2], 0);
}

// The reader gets the way of resampling and a grid that holds the buffer.
TEST(RasterStore, MasksOfForbiddenPlacesAreTouchedAndReadAsFarAsTheirBuffer) {
  std::map<std::string, std::vector<std::pair<kg_base::Resampling, int>>> read;
  RasterReaders readers;
  readers.field = [](const Mission&, const kg_mission::WorkFieldRef&) {
    return UniformFlow(kGrid, 0.1, 0.2);
  };
  readers.raster = [&](const Mission&, const std::string& iri,
                       const kg_mission::RasterRef& ref,
                       const kg_base::Grid& grid) {
    read[iri].emplace_back(ref.resampling, grid.rows());
    return Raster(grid.size(), 1.0f);
  };
  Policy policy = Weighing({});
  policy.alpha_base = 0.0;
  Mission mission = TestMission();
  mission.agents = {TestAgent("alpha")};
  kg_mission::Constraint hard = mission.constraints[0];
  hard.windows = {};
  hard.mask->resampling = kg_base::Resampling::kNearest;
  hard.buffer_cells = 2.5;
  kg_mission::Constraint soft = hard;
  soft.iri = "ex:soft";
  soft.kind = kg_mission::ConstraintKind::kSoft;
  soft.buffer_cells = 0.0;
  mission.constraints = {hard, soft};
  using kg_base::Resampling;
  const auto calm = RasterStore(readers).Rasters(
      mission, policy, *RasterStore(readers).Field(mission, 0));
  const std::vector<std::pair<Resampling, int>> touched = {
      {Resampling::kTouched, 6 + 2 * 3}};
  EXPECT_EQ(read["ex:farm"], touched);
  EXPECT_EQ(read["ex:soft"].size(), 1u);
  EXPECT_TRUE(calm->avoided_masks.empty());
  read.clear();
  mission.agents[0].must_avoid["ex:soft"] = {"ex:alpha"};
  const auto avoided = RasterStore(readers).Rasters(
      mission, policy, *RasterStore(readers).Field(mission, 0));
  const std::vector<std::pair<Resampling, int>> both = {
      {Resampling::kNearest, 6}, {Resampling::kTouched, 6}};
  EXPECT_EQ(read["ex:soft"], both);
  EXPECT_EQ(avoided->avoided_masks.count("ex:soft"), 1u);
}

TEST(RasterStore, APriorThatIsNotWeighedIsNotRead) {
  Files files;
  RasterStore store(files.Readers());
  Policy policy = Weighing({"ex:reefs"});
  policy.beta["ex:reefs"] = 0.0;
  Mission mission = TestMission();
  mission.priors[1].windows = {3};
  const auto rasters = RastersOf(&store, mission, policy, 0);
  EXPECT_TRUE(rasters->prior_rasters.empty());
  EXPECT_TRUE(RastersOf(&store, mission, Weighing({"ex:kelp"}), 0)
                  ->prior_rasters.empty());
  EXPECT_EQ(files.read.count("ex:reefs") + files.read.count("ex:kelp"), 0u);
}

TEST(RasterStore, ReadsOnlyChangedRastersAgain) {
  Mission mission = TestMission();
  const Policy policy = Weighing({"ex:reefs", "ex:kelp"});
  Files files;
  RasterStore store(files.Readers());
  const auto before = RastersOf(&store, mission, policy, 1);
  store.ForgetUnused();
  const auto change = [&](auto make) {
    Mission changed = TestMission();
    make(&changed);
    files.read.clear();
    RasterStore copy = store;  // As in a what-if query.
    return RastersOf(&copy, changed, policy, 1);
  };
  change([](Mission* m) { m->priors[0].raster->time_index = 1; });
  EXPECT_EQ(files.read.count("ex:reefs"), 1u);
  EXPECT_EQ(files.read.count("ex:kelp"), 0u);
  change([](Mission* m) {
    m->priors[0].raster->resampling = kg_base::Resampling::kNearest;
  });
  EXPECT_EQ(files.read.count("ex:reefs"), 1u);
  change([](Mission* m) { m->files["ex:habitat"].sha256 = "new"; });
  EXPECT_EQ(files.read.count("ex:reefs") + files.read.count("ex:kelp") +
                files.read.count("ex:farm"),
            3u);
  EXPECT_EQ(change([](Mission*) {}), before);
  EXPECT_EQ(files.read.size(), 0u);
}

TEST(RasterStore, ForgetsRastersNotAskedFor) {
  const Mission mission = TestMission();
  Files files;
  RasterStore store(files.Readers());
  const Policy policy = Weighing({"ex:reefs"});
  RastersOf(&store, mission, policy, 1);
  store.ForgetUnused();
  RastersOf(&store, mission, Weighing({}), 1);
  store.ForgetUnused();  // Reefs were not used.
  RastersOf(&store, mission, policy, 1);
  EXPECT_EQ(files.read.count("ex:reefs"), 2u);
  EXPECT_EQ(files.read.count("ex:farm"), 1u);
}

// A29.
TEST(RasterStore, TheValueLayerIsOfThePolicysKindAndTheNewest) {
  Mission mission = TestMission();
  mission.value_layers.push_back({"ex:newer", 1, "delta_sst", "ex:file", 7, 6});
  mission.value_layers.push_back({"ex:plain", 1, "sst", "ex:file", 9, 9});
  Files files;
  RasterStore store(files.Readers());
  Policy policy = Weighing({});
  EXPECT_EQ(RastersOf(&store, mission, policy, 1)->value_iri, "ex:newer");
  EXPECT_EQ(RastersOf(&store, mission, policy, 0)->value_iri, "ex:value0");
  policy.value_kind = "sst";
  EXPECT_EQ(RastersOf(&store, mission, policy, 1)->value_iri, "ex:plain");
  EXPECT_NE(Refusal([&] {
              RastersOf(&store, mission, policy, 0);
            }).find("no ex:ValueLayer has it"),
            std::string::npos);
  mission.value_layers.push_back({"ex:twin", 1, "sst", "ex:file", 9, 9});
  EXPECT_NE(Refusal([&] {
              RastersOf(&store, mission, policy, 1);
            }).find("two ex:ValueLayers of one time have it"),
            std::string::npos);
  policy.alpha_base = policy.gamma_front = 0.0;
  EXPECT_EQ(RastersOf(&store, mission, policy, 1)->value_iri, "");
}

TEST(RasterStore, TheNewestOfSeveralFilesIsKnownByItsTimeNotItsIndex) {
  Mission mission = TestMission();
  mission.files["ex:other"] = {"ex:other", "/other.nc", "sha3"};
  mission.value_layers.push_back({"ex:late", 1, "delta_sst", "ex:other", 1, 0});
  Files files;
  RasterStore store(files.Readers());
  const auto chosen = [&] {
    return RastersOf(&store, mission, Weighing({}), 1)->value_iri;
  };
  EXPECT_NE(Refusal(chosen).find("two ex:ValueLayers of one time"),
            std::string::npos);  // Step 1 of one, step 2 of another.
  mission.value_layers[1].time_s = 1000.0;
  mission.value_layers.back().time_s = 2000.0;
  EXPECT_EQ(chosen(), "ex:late");
  std::reverse(mission.value_layers.begin(), mission.value_layers.end());
  EXPECT_EQ(chosen(), "ex:late");
}

TEST(RasterStore, AFixedScaleMustBeStatedForTheLayerRead) {
  Mission mission = TestMission();
  Files files;
  RasterStore store(files.Readers());
  Policy policy = Weighing({});
  policy.layer_scale = LayerScale::kFixed;
  const auto refusal = [&] {
    return Refusal([&] { RastersOf(&store, mission, policy, 2); });
  };
  EXPECT_EQ(refusal(),
            "<ex:value2> ex:fullScale: expected a number above 0, because "
            "policy <ex:policy> has ex:layerScale \"fixed\"");
  mission.value_layers[2].full_scale = 2.5;
  EXPECT_EQ(refusal(), "");
  policy.gamma_front = 0.1;
  EXPECT_NE(refusal().find("<ex:value2> ex:frontFullScale"), std::string::npos);
  mission.value_layers[2].front_full_scale = 0.1;
  EXPECT_EQ(refusal(), "");
  const auto rasters = RastersOf(&store, mission, policy, 2);
  EXPECT_EQ(rasters->full_scale, 2.5);
  EXPECT_EQ(rasters->front_full_scale, 0.1);
  policy.alpha_base = policy.gamma_front = 0.0;
  mission.value_layers.clear();
  EXPECT_EQ(refusal(), "");
}

TEST(RasterStore, AllWindowsAreOnOneGrid) {
  const Mission mission = TestMission();
  Files files;
  files.grid_of["ex:field2"] = EvenGrid(-91, 24, 0.05, 6, 5);
  RasterStore store(files.Readers());
  store.Field(mission, 0);
  store.Field(mission, 1);
  const std::string said = Refusal([&] { store.Field(mission, 2); });
  EXPECT_NE(said.find("<ex:field2>: expected the grid of <ex:field0>"),
            std::string::npos)
      << said;
  EXPECT_NE(said.find(kGrid.Text()), std::string::npos) << said;
  EXPECT_NE(said.find(files.grid_of["ex:field2"].Text()), std::string::npos);
  // A rejected field is not cached, and a new forecast may have a new grid.
  EXPECT_NE(Refusal([&] { store.Field(mission, 2); }), "");
  Mission other = mission;
  other.files["ex:file"].sha256 = "another";
  for (int t = 0; t < kWindows; ++t) {
    files.grid_of["ex:field" + std::to_string(t)] =
        EvenGrid(-91, 24, 0.05, 6, 5);
  }
  for (int t = 0; t < kWindows; ++t) {
    EXPECT_EQ(Refusal([&] { store.Field(other, t); }), "") << t;
  }
}

}  // namespace
}  // namespace kg_compiler
