// For every class of the paper and of the class tree: assert, find, validate,
// retract.

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "kg_core/facts/terms.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

// Adds an instance ex:new of `type` to the test mission; `stored_as` is set if
// `type` is an alternative name.
struct ClassCase {
  const char* name;
  const char* type;
  const char* facts;
  const char* stored_as = nullptr;
};

const ClassCase kClasses[] = {
    {"MissionEntity", "ex:MissionEntity", "rdfs:label \"x\""},
    {"Agent", "ex:Agent",
     "ex:id \"new\" ; ex:usesPolicy ex:safe ; ex:hasCapabilities ex:alpha_can"},
    {"Policy", "ex:Policy", "ex:alpha_base 1"},
    {"Event", "ex:Event",
     "ex:forWindow ex:w0 ; ex:value 1 ; geo:asWKT \"POINT(-93 26)\""},
    {"SpatiotemporalEntity", "ex:SpatiotemporalEntity", "rdfs:label \"x\""},
    {"TimeWindow", "ex:TimeWindow",
     "ex:index 2 ; ex:confidence 0.5 ; time:hasBeginning "
     "\"2026-06-04T00:00:00Z\"^^xsd:dateTime"},
    {"GridSpec", "ex:GridSpec",
     "ex:rows 25 ; ex:cols 50 ; ex:pixelSizeKm 4.45 ; geo:asWKT "
     "\"POLYGON((-92 24, -90 24, -90 25, -92 25, -92 24))\""},
    {"WorkField", "ex:WorkField",
     "ex:forWindow ex:w1 ; ex:gridRefU \"u\" ; ex:gridRefV \"v\" ; "
     "ex:firstTimeIndex 0 ; ex:lastTimeIndex 1 ; prov:wasDerivedFrom ex:file1"},
    {"WorkLayer", "ex:WorkLayer",
     "ex:forWindow ex:w1 ; ex:gridRefU \"u\" ; ex:gridRefV \"v\" ; "
     "ex:firstTimeIndex 0 ; ex:lastTimeIndex 1 ; prov:wasDerivedFrom ex:file1",
     "ex:WorkField"},
    {"CurrentField", "ex:CurrentField",
     "ex:forWindow ex:w1 ; ex:gridRefU \"u\" ; ex:gridRefV \"v\" ; "
     "ex:firstTimeIndex 0 ; ex:lastTimeIndex 1 ; ssn:observedProperty "
     "ex:seaWaterVelocity ; prov:wasDerivedFrom ex:file1"},
    {"CostField", "ex:CostField",
     "ex:forWindow ex:w1 ; ex:gridRef \"w\" ; ex:firstTimeIndex 0 ; "
     "ex:lastTimeIndex 1 ; sosa:observedProperty ex:waveHeight ; "
     "prov:wasDerivedFrom ex:file1"},
    {"ValueLayer", "ex:ValueLayer",
     "ex:forWindow ex:w1 ; ex:kind \"frontness\" ; ex:timeIndex 1 ; "
     "prov:wasDerivedFrom ex:file1"},
    {"BaseLayer", "ex:BaseLayer",
     "ex:forWindow ex:w1 ; ex:kind \"frontness\" ; ex:timeIndex 1 ; "
     "prov:wasDerivedFrom ex:file1",
     "ex:ValueLayer"},
    {"PriorLayer", "ex:PriorLayer",
     "ex:name \"new\" ; geo:asWKT \"POLYGON((0 0, 1 0, 1 1, 0 0))\""},
    {"Constraint", "ex:Constraint",
     "ex:kind \"no_go\" ; geo:asWKT \"POLYGON((0 0, 1 0, 1 1, 0 0))\""},
    {"CoolingConstraint", "ex:CoolingConstraint",
     "ex:kind \"soft\" ; ex:attenuation 0.5 ; ex:forAgent ex:alpha ; "
     "ex:forWindow ex:w1 ; geo:asWKT \"POLYGON((0 0, 1 0, 1 1, 0 0))\" ; "
     "ex:expires \"2026-06-04T00:00:00Z\"^^xsd:dateTime"},
    {"Artifact", "ex:Artifact", "prov:wasDerivedFrom ex:file1"},
    {"TensorArtifact", "ex:TensorArtifact",
     "ex:forAgent ex:alpha ; ex:forWindow ex:w1 ; ex:tensorKind \"WORK\" ; "
     "ex:hash \"00\""},
    {"HeatmapArtifact", "ex:HeatmapArtifact",
     "ex:forAgent ex:alpha ; ex:forWindow ex:w1 ; ex:tensorKind \"FUSED\" ; "
     "ex:hash \"00\" ; prov:wasDerivedFrom ex:layer1 , ex:safe"},
    {"NavGraph", "ex:NavGraph",
     "ex:forWindow ex:w1 ; ex:movementMode \"edges\""},
    {"Waypoint", "ex:Waypoint",
     "ex:inGraph ex:nav ; geo:asWKT \"POINT(-93 26)\" ; ex:score 1"},
    {"TraverseEdge", "ex:TraverseEdge",
     "ex:inGraph ex:nav ; ex:from ex:p2 ; ex:to ex:p1"},
    {"EdgeCost", "ex:EdgeCost",
     "ex:forEdge ex:edge ; ex:forAgent ex:bravo ; ex:costHours 1 ; "
     "ex:costEnergy 2 ; ex:costRisk 0"},
    {"Activity", "prov:Activity", "prov:used ex:file1"},
    {"CompilePhi2", "ex:CompilePhi2", "prov:used ex:layer1"},
    {"CompilePhi1", "ex:CompilePhi1", "prov:used ex:heat"},
    {"SelectRun", "ex:SelectRun", "prov:used ex:heat"},
    {"PlanRun", "ex:PlanRun",
     "ex:forWindow ex:w0 , ex:w1 ; ex:worldVersion 3 ; ex:status \"stale\""},
    {"AgentCapabilities", "ex:AgentCapabilities",
     "ex:cruiseSpeedKts 1 ; ex:maxSpeedKts 1 ; ex:energyPerKm 2 ; "
     "ex:energyBudget 500 ; ex:sensorRadiusKm 12 ; ex:boostGain 0.5"},
    {"AgentState", "ex:AgentState",
     "ex:forAgent ex:alpha ; ex:forWindow ex:w1 ; ex:headingDeg 90 ; "
     "geo:asWKT \"POINT(-93 26)\""},
    {"Assignment", "ex:Assignment",
     "ex:forAgent ex:bravo ; ex:forWindow ex:w1 ; prov:wasGeneratedBy ex:run ; "
     "ex:waypointWKT \"POINT(-93 26)\""},
    {"Rejection", "ex:Rejection",
     "ex:forAgent ex:bravo ; ex:kind \"late\" ; prov:wasGeneratedBy ex:run"},
    {"Price", "ex:Price",
     "ex:visits ex:seep ; ex:price 2 ; prov:wasGeneratedBy ex:run"},
    {"Commitment", "ex:Commitment",
     "ex:forAgent ex:bravo ; prov:wasGeneratedBy ex:run"},
};

bool Ask(const MissionWorld& world, const std::string& pattern) {
  return kg_core::RunQuery(*world.store.Read(), "ASK { " + pattern + " }",
                           kg_core::DefaultDataset(std::nullopt), {})
      .answer;
}

class ClassesTest : public testing::TestWithParam<ClassCase> {};

TEST_P(ClassesTest, AreAssertedFoundValidRetractedAndGone) {
  const ClassCase& c = GetParam();
  MissionWorld world(std::string(kTestFacts) + kTestArtifacts);
  const std::string stored = c.stored_as == nullptr ? c.type : c.stored_as;
  const std::string pattern = "ex:new a " + stored;
  EXPECT_FALSE(Ask(world, pattern));
  ASSERT_EQ(Joined(world.Add("ex:new a " + std::string(c.type) + " ; " +
                             c.facts + " .")),
            "");
  EXPECT_TRUE(Ask(world, pattern));
  EXPECT_TRUE(Validate(*world.store.Read()).empty());
  ASSERT_EQ(Joined(world.Remove({"ex:new", "", ""})), "");
  EXPECT_FALSE(Ask(world, pattern));
  EXPECT_FALSE(Ask(world, "ex:new ?p ?o"));
  EXPECT_TRUE(Validate(*world.store.Read()).empty());
}

INSTANTIATE_TEST_SUITE_P(Each, ClassesTest, testing::ValuesIn(kClasses),
                         [](const auto& info) {
                           return std::string(info.param.name);
                         });

// There is always exactly one mission: a new one replaces it.
TEST(MissionClassTest, IsAssertedFoundValidAndReplaced) {
  MissionWorld world;
  EXPECT_TRUE(Ask(world, "ex:m a ex:Mission"));
  kg_core::FactUpdate update;
  update.remove = {{"ex:m", "", ""}};
  EXPECT_FALSE(world.Commit(update).empty());
  update.turtle =
      "ex:m2 a ex:Mission ; ex:name \"next\" ; ex:hasWindow ex:w0 , ex:w1 ; "
      "ex:hasAgent ex:alpha .";
  ASSERT_EQ(Joined(world.Commit(update)), "");
  EXPECT_FALSE(Ask(world, "ex:m a ex:Mission"));
  EXPECT_TRUE(Ask(world, "ex:m2 a ex:Mission"));
  EXPECT_TRUE(Validate(*world.store.Read()).empty());
}

}  // namespace
}  // namespace kg_mission
