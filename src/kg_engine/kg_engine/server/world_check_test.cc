#include "kg_engine/server/world_check.h"

#include <filesystem>
#include <string>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/temporary_folder.h"
#include "kg_engine/server/mission_server.h"
#include "kg_engine/server/testing/test_mission.h"

namespace kg_engine {
namespace {

class WorldCheckTest : public testing::Test {
 protected:
  WorldCheckTest() {
    folders_.mission = folder_ / "mission";
    folders_.state = folder_ / "state";
    folders_.ontology = "../kg_mission/ontology";
    WriteTestMission(folders_.mission);
  }

  static void Set(const std::string& subject, const std::string& property,
                  const std::string& value, MissionServer* server) {
    kg_core::FactUpdate update;
    update.author = "operator";
    update.set = {{subject, property, value}};
    const Decision decision = server->Apply(update);
    ASSERT_TRUE(decision.accepted) << decision.reasons.at(0);
  }

  kg_base::TemporaryFolder folder_;
  MissionFolders folders_;
};

TEST_F(WorldCheckTest, FindsAWorldThatWasCompiledChangeByChangeInOrder) {
  MissionServer server(folders_);
  const std::vector<std::vector<std::string>> changes = {
      {"ex:alpha", "ex:usesPolicy", "ex:safe"},
      {"ex:w1", "ex:confidence", "0.5"},
      {"ex:land", "ex:bufferCells", "3"},
      {"ex:bloom", "ex:value", "4"},
      {"ex:alpha", "ex:usesPolicy", "ex:fast"}};
  for (const auto& change : changes) {
    server.BeginCycle();
    Set(change[0], change[1], change[2], &server);
    // The facts are ahead of the last cycle by one change.
    const auto answer = CheckWorld(server.present(), server.files());
    EXPECT_TRUE(answer.ok) << answer.text;
    EXPECT_EQ(answer.world_version, server.world_version());
    EXPECT_EQ(answer.compared, 2u + 2u + 1u + 1u);
    EXPECT_GT(answer.compile_s, 0.0);
    EXPECT_GE(answer.total_s, answer.compile_s);
  }
}

TEST_F(WorldCheckTest, NamesWhatIsHeldOtherwise) {
  MissionServer server(folders_);
  server.BeginCycle();
  Present present = server.present();
  // A compiler that has read a different flow field in the second window.
  const kg_compiler::RasterReaders files =
      kg_compiler::ReadersOf(server.files());
  present.compiler = kg_compiler::MissionCompiler(kg_compiler::RasterReaders{
      [&](const kg_mission::Mission& mission,
          const kg_mission::WorkFieldRef& ref) {
        kg_base::VectorField field = files.field(mission, ref);
        if (ref.window == 1) {
          field.slices[0].east_mps[field.grid.size() - 1] += 0.25f;
        }
        return field;
      },
      files.value});
  const auto answer = CheckWorld(present, server.files());
  EXPECT_FALSE(answer.ok);
  EXPECT_TRUE(answer.errors.empty());
  ASSERT_EQ(answer.differs.size(), 2u) << answer.text;
  EXPECT_NE(answer.differs[0].find("of window 1"), std::string::npos);
  EXPECT_EQ(answer.differs[1].rfind("seam rules of ", 0), 0u);
  EXPECT_NE(answer.text.find("differs: "), std::string::npos);
}

TEST_F(WorldCheckTest, SaysWhyAWorldCannotBeChecked) {
  MissionServer server(folders_);
  server.BeginCycle();
  Present present = server.present();
  std::filesystem::remove(folders_.mission + "/ocean.nc");
  kg_mission::FileCache files(folders_.mission, "");
  const auto answer = CheckWorld(present, &files);
  EXPECT_FALSE(answer.ok);
  EXPECT_EQ(answer.errors.size(), 1u) << answer.text;
}

TEST_F(WorldCheckTest, HoldsAStoresFactsAgainstTheTensorsItSaysWereMade) {
  {
    MissionServer server(folders_);
    server.BeginCycle();
    server.Save();
  }
  MissionServer server(folders_);
  auto answer = CheckStore(*server.Read(), server.files());
  EXPECT_TRUE(answer.ok) << answer.text;
  EXPECT_EQ(answer.compared, 2u);
  Set("ex:w1", "ex:confidence", "0.5", &server);  // No cycle afterwards.
  answer = CheckStore(*server.Read(), server.files());
  EXPECT_FALSE(answer.ok);
  ASSERT_EQ(answer.differs.size(), 1u) << answer.text;
  EXPECT_NE(answer.differs[0].find("window 1"), std::string::npos);
}

}  // namespace
}  // namespace kg_engine
