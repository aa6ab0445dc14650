// Every shipped mission parses, conforms and is read, with the numbers stated
// in its comments.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_update.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_core::Ex;

constexpr char kMissions[] = "../../config/missions";

std::map<std::string, std::string> MissionFiles() {
  std::map<std::string, std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(kMissions)) {
    const auto file = entry.path() / "mission.ttl";
    if (std::filesystem::exists(file)) {
      files[entry.path().filename().string()] = file.string();
    }
  }
  return files;
}

Mission Load(const std::string& file, MissionWorld& world) {
  kg_core::Transaction transaction = world.store.Begin();
  EXPECT_EQ(Joined(StageFactsFile(file, transaction)), "") << file;
  transaction.Commit(kg_core::WorldChange::kYes);
  EXPECT_TRUE(Validate(*world.store.Read()).empty()) << file;
  return ReadMission(*world.store.Read());
}

TEST(ShippedMissionsTest, GulfAndTampicoAreAmongThem) {
  const auto files = MissionFiles();
  EXPECT_EQ(files.count("gulf"), 1u);
  EXPECT_EQ(files.count("tampico"), 1u);
}

TEST(ShippedMissionsTest, EachConformsAndIsRead) {
  for (const auto& [name, file] : MissionFiles()) {
    MissionWorld world("");
    const Mission mission = Load(file, world);
    EXPECT_EQ(mission.name, name);
    EXPECT_FALSE(mission.windows.empty()) << name;
    EXPECT_FALSE(mission.agents.empty()) << name;
  }
}

TEST(ShippedMissionsTest, ConfidencesAreTheirGeneratorsValues) {
  for (const auto& [name, file] : MissionFiles()) {
    MissionWorld world("");
    const Mission mission = Load(file, world);
    const auto decay =
        kg_core::FirstObject(*world.store.Read(), kg_core::kFactsGraph,
                             kg_core::Iri(mission.iri), Ex("confidenceDecay"));
    if (!decay) continue;
    const double rate = kg_core::NumericValue(*decay).value();
    for (const TimeWindow& window : mission.windows) {
      EXPECT_NEAR(window.confidence, std::exp(-rate * window.index), 1e-6)
          << name << " window " << window.index;
    }
  }
}

TEST(ShippedMissionsTest, TheCaseStudyIsAsThePaperHasIt) {
  MissionWorld world("");
  const Mission gulf = Load(MissionFiles().at("gulf"), world);
  EXPECT_EQ(gulf.windows.size(), 7u);
  EXPECT_EQ(gulf.windows.front().begin_s, 1780358400.0);  // 2026-06-02T00Z.
  ASSERT_EQ(gulf.agents.size(), 3u);
  EXPECT_EQ(gulf.agents[0].id, "alpha");
  EXPECT_EQ(gulf.agents[1].id, "bravo");
  EXPECT_EQ(gulf.agents[2].id, "charlie");
  EXPECT_NE(gulf.agents[0].capabilities.cruise_mps,
            gulf.agents[1].capabilities.cruise_mps);
  for (const char* policy : {"fast", "safe", "naive", "front_plus", "poi_focus",
                             "sanct_soft", "front_poi"}) {
    EXPECT_TRUE(kg_core::Has(*world.store.Read(), kg_core::kFactsGraph,
                             Ex(policy), kg_core::RdfType(), Ex("Policy")))
        << policy;
  }
  for (const Constraint& constraint : gulf.constraints) {
    EXPECT_EQ(constraint.buffer_cells, constraint.is_land ? 5.0 : 0.0);
    EXPECT_EQ(constraint.attenuation, constraint.is_land ? 1.0 : 0.4);
  }
  EXPECT_EQ(gulf.constraints.size(), 2u);
  EXPECT_EQ(gulf.priors.size(), 1u);
  EXPECT_GE(gulf.events.size(), 5u);
}

TEST(ShippedMissionsTest, AnAgentCanBePutOnEachOfTheShippedPolicies) {
  MissionWorld world("");
  Load(MissionFiles().at("gulf"), world);
  for (const char* policy : {"fast", "safe", "naive", "front_plus", "poi_focus",
                             "sanct_soft", "front_poi"}) {
    EXPECT_EQ(Joined(world.Set(
                  {"ex:alpha", "ex:usesPolicy", std::string("ex:") + policy})),
              "");
  }
}

}  // namespace
}  // namespace kg_mission
