#include "kg_core/facts/keys.h"

#include <gtest/gtest.h>

#include <string>

#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

MissionWorld& World() {
  static MissionWorld* const world =
      new MissionWorld(std::string(kTestFacts) + kTestArtifacts);
  return *world;
}

std::string Refusal(const std::string& turtle) {
  kg_core::Transaction transaction = World().store.Begin();
  return Joined(StageUpdate({"", "test", {}, {}, {}, turtle}, transaction));
}

TEST(KeysTest, OneCostForEachEdgeAndAgent) {
  const std::string cost =
      "ex:cost2 a ex:EdgeCost ; ex:costHours 6 ; "
      "ex:forEdge ex:edge ; ex:forAgent ";
  EXPECT_EQ(Refusal(cost + "ex:alpha ."),
            "ex:cost2: expected one ex:EdgeCost for each ex:forEdge and "
            "ex:forAgent, but ex:cost has the same\n");
  EXPECT_EQ(Refusal(cost + "ex:bravo ."), "");
}

TEST(KeysTest, OneAssignmentForEachAgentAndWindow) {
  const std::string assignment =
      "ex:as2 a ex:Assignment ; ex:forAgent ex:alpha ; ex:waypointWKT "
      "\"POINT(-93 26.2)\" ; prov:wasGeneratedBy ex:run ; ex:forWindow ";
  EXPECT_NE(Refusal(assignment + "ex:w0 .").find("but ex:as has the same"),
            std::string::npos);
  EXPECT_EQ(Refusal(assignment + "ex:w1 ."), "");
}

TEST(KeysTest, TwinsOfOneUpdateAreRefusedToo) {
  const std::string prior =
      " a ex:PriorLayer ; ex:name \"reef\" ; geo:asWKT "
      "\"POLYGON((-90 25, -89 25, -89 27, -90 25))\" . ";
  EXPECT_NE(Refusal("ex:a" + prior + "ex:b" + prior)
                .find("ex:a: expected one ex:PriorLayer for each ex:name"),
            std::string::npos);
}

TEST(KeysTest, AChangeThatMakesATwinIsRefused) {
  kg_core::Transaction transaction = World().store.Begin();
  kg_core::FactUpdate update;
  update.turtle =
      "ex:a a ex:PriorLayer ; ex:name \"reef\" ; geo:asWKT "
      "\"POLYGON((-90 25, -89 25, -89 27, -90 25))\" .";
  update.set = {{"ex:corridor", "ex:name", "\"reef\""}};
  EXPECT_NE(Joined(StageUpdate(update, transaction)).find("ex:name, but"),
            std::string::npos);
}

}  // namespace
}  // namespace kg_mission
