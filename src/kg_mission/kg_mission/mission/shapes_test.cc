// The shipped shapes: conforming facts, and the messages for violations. See
// shacl_bad_test.cc for an example for each shape and property.

#include <gtest/gtest.h>

#include <string>

#include "kg_core/facts/terms.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

// Setting `fact` (empty value: removing the property) must be rejected by
// `shape` with a message that contains `said`.
struct BadFact {
  const char* shape;
  kg_core::Fact fact;
  const char* said;
};

const BadFact kBadFacts[] = {
    {"Mission", {"ex:m", "ex:name", ""}, "expected exactly one name"},
    {"Mission", {"ex:m", "ex:hasAgent", "ex:nobody"}, "not ex:nobody"},
    {"Mission", {"ex:m", "ex:waypointsPerWindow", "21"}, "integer in 1..20"},
    {"Mission", {"ex:m", "ex:teamMode", "\"lottery\""}, "\"auction\""},
    {"Mission", {"ex:m", "ex:gapGoal", "1.01"}, "share in [0, 1]"},
    {"Mission", {"ex:m", "ex:auctionEpsilon", "0"}, "more than 0"},
    {"Mission", {"ex:m", "ex:selectTimeLimitS", "60.5"}, "0 to 60"},
    {"Mission", {"ex:m", "ex:fairness", "\"none\""}, "max_min"},
    {"Mission", {"ex:m", "ex:fairnessWeight", "-1"}, "at least 0"},
    {"TimeWindow", {"ex:w1", "ex:confidence", "1.2"}, "confidence in [0, 1]"},
    {"TimeWindow", {"ex:w1", "ex:confidence", "-0.1"}, "confidence in [0, 1]"},
    {"TimeWindow", {"ex:w1", "ex:confidence", ""}, "exactly one confidence"},
    {"TimeWindow", {"ex:w1", "ex:index", "-1"}, "at least 0"},
    {"TimeWindow",
     {"ex:w0", "time:hasEnd", "\"2026-06-01T00:00:00Z\"^^xsd:dateTime"},
     "before time:hasEnd"},
    {"GridSpec", {"ex:grid", "ex:rows", "1"}, "number of rows"},
    {"GridSpec", {"ex:grid", "geo:asWKT", "\"POINT(1 2)\""}, "bounding box"},
    {"WorkField", {"ex:field", "ex:gridRefV", ""}, "northward component"},
    {"WorkField", {"ex:field", "ex:firstTimeIndex", "7"}, "time index, 0 to"},
    {"WorkField", {"ex:field", "ex:forWindow", "ex:alpha"}, "ex:TimeWindow"},
    {"ValueLayer",
     {"ex:layer1", "ex:kind", "\"Delta SST\""},
     "or \"frontness\""},
    {"ValueLayer", {"ex:layer1", "ex:fullScale", "0"}, "above 0"},
    {"ValueLayer", {"ex:layer1", "prov:wasDerivedFrom", ""}, "ex:SourceFile"},
    {"PriorLayer", {"ex:corridor", "ex:name", ""}, "exactly one name"},
    {"PriorLayer", {"ex:corridor", "geo:asWKT", "\"POINT(1 2)\""}, "one area"},
    {"PriorLayer", {"ex:corridor", "ex:gridRef", "\"a#b@0\""}, "either"},
    {"PriorLayer", {"ex:corridor", "ex:gridRef", "\"a@0\""}, "file#variable"},
    {"Mission", {"ex:m", "ex:movementMode", "\"walk\""}, "\"edges\""},
    {"Constraint", {"ex:sanctuary", "ex:kind", "\"hard\""}, "no_go"},
    {"Constraint", {"ex:sanctuary", "ex:attenuation", "-0.4"}, "in [0, 1]"},
    {"Constraint", {"ex:sanctuary", "ex:attenuation", ""}, "unless ex:kind"},
    {"Constraint", {"ex:sanctuary", "ex:gridRef", "\"land\""}, "either"},
    {"Constraint", {"ex:land", "ex:gridRef", ""}, "either"},
    {"Constraint", {"ex:land", "ex:gridRef", "\"sea\""}, "expected \"land\""},
    {"Constraint", {"ex:land", "ex:bufferCells", "-5"}, "number of cells"},
    {"Constraint", {"ex:land", "ex:bufferMetric", "\"taxi\""}, "chebyshev"},
    {"Constraint", {"ex:land", "ex:resampling", "\"bilinear\""}, "only way"},
    {"Constraint", {"ex:land", "ex:appliesIn", "ex:w9"}, "not ex:w9"},
    {"CoolingConstraint", {"ex:cool", "ex:expires", ""}, "xsd:dateTime"},
    {"DataSource", {"ex:sst", "ex:provides", "\"salinity\""}, "temperature"},
    {"DataSource", {"ex:sst", "ex:file", ""}, "exactly one file name"},
    {"SourceFile", {"ex:file1", "ex:sha256", "\"abc\""}, "64 hexadecimal"},
    {"Policy", {"ex:safe", "ex:alpha_base", "-1"}, "weight in [0, 100]"},
    {"Policy", {"ex:safe", "ex:lambda_risk", "1e9"}, "in [0, 1000]"},
    {"Policy", {"ex:safe", "ex:normalisation", "\"sum\""}, "minmax"},
    {"Policy", {"ex:safe", "ex:frontOperator", "\"scharr\""}, "central"},
    {"Policy", {"ex:safe", "ex:layerScale", "\"max\""}, "fixed"},
    {"Policy", {"ex:safe", "ex:softOverlap", "\"max\""}, "product"},
    {"Policy", {"ex:safe", "ex:hazardRangeKm", "0"}, "above 0"},
    {"Policy", {"ex:safe", "ex:isolationWeight", "-1"}, "in [0, 1000]"},
    {"Policy", {"ex:safe", "ex:riskBudgetHours", "0"}, "more than 0"},
    {"Policy", {"ex:safe", "ex:pathChoice", "\"any\""}, "diverse"},
    {"Policy", {"ex:safe", "ex:minimumDifference", "0"}, "at least 1"},
    {"Policy", {"ex:safe", "ex:churnWeight", "-1"}, "at least 0"},
    {"Policy", {"ex:safe", "ex:valueKind", "\"salt\""}, "frontness"},
    {"Policy", {"ex:safe", "ex:hasPriorWeight", "ex:w0"}, "ex:PriorWeight"},
    {"PriorWeight",
     {"<http://example.org/mission/safe/prior/corridor>", "ex:beta", "1000"},
     "[-100, 100]"},
    {"SoftOverride",
     {"<http://example.org/mission/safe/soft_override/sanctuary>",
      "ex:constraint", "ex:land"},
     "of kind \"soft\""},
    {"Event", {"ex:seep", "ex:value", ""}, "exactly one reward"},
    {"Event", {"ex:seep", "ex:capacity", "0"}, "at least 1"},
    {"Event", {"ex:seep", "geo:asWKT", "\"LINESTRING(0 0, 1 1)\""}, "position"},
    {"Agent", {"ex:alpha", "ex:usesPolicy", "ex:brave"}, "not ex:brave"},
    {"Agent", {"ex:alpha", "ex:hasCapabilities", ""}, "AgentCapabilities"},
    {"Agent", {"ex:alpha", "ex:id", "\"Alpha 1\""}, "lower-case letters"},
    {"Agent", {"ex:alpha", "ex:mustAvoid", "ex:w0"}, "ex:Constraint"},
    {"Rule", {"ex:rule", "rdfs:comment", ""}, "to be cited"},
    {"AgentCapabilities",
     {"ex:alpha_can", "ex:cruiseSpeedKts", "2"},
     "at most ex:maxSpeedKts"},
    {"AgentCapabilities", {"ex:alpha_can", "ex:energyBudget", "0"}, "above 0"},
    {"AgentState", {"ex:alpha_start", "ex:headingDeg", "360"}, "[0, 360)"},
    {"AgentState", {"ex:alpha_start", "ex:forAgent", ""}, "one ex:Agent"},
    {"TensorArtifact", {"ex:heat", "ex:tensorKind", "\"SUM\""}, "FUSED"},
    {"NavGraph", {"ex:nav", "ex:movementMode", "\"fly\""}, "hops"},
    {"Waypoint", {"ex:p1", "ex:inGraph", "ex:edge"}, "ex:NavGraph"},
    {"TraverseEdge", {"ex:edge", "ex:to", ""}, "ex:Waypoint"},
    {"EdgeCost", {"ex:cost", "ex:costHours", "-1"}, "at least 0"},
    {"PlanRun", {"ex:run", "ex:status", "\"fine\""}, "superseded"},
    {"Assignment", {"ex:as", "ex:waypointWKT", ""}, "POINT(lon lat)"},
};

std::string AllFacts() { return std::string(kTestFacts) + kTestArtifacts; }

TEST(ShapesTest, ConformingWorldHasNoViolation) {
  MissionWorld world(AllFacts());
  const auto violations = Validate(*world.store.Read());
  EXPECT_TRUE(violations.empty()) << violations[0].Line();
}

TEST(ShapesTest, EveryBadFactIsRefusedByItsShapeInItsWords) {
  MissionWorld world(AllFacts());
  for (const BadFact& bad : kBadFacts) {
    const auto reasons =
        bad.fact.value.empty()
            ? world.Remove({bad.fact.subject, bad.fact.property, ""})
            : world.Set(bad.fact);
    const std::string said = Joined(reasons);
    const std::string shape = "(ex:" + std::string(bad.shape) + "Shape)";
    EXPECT_NE(said.find(bad.said), std::string::npos)
        << bad.fact.property << ": " << said;
    EXPECT_NE(said.find(shape), std::string::npos)
        << bad.fact.property << ": " << said;
  }
}

TEST(ShapesTest, TwoPoliciesAreRefusedAndTheAgentIsNamed) {
  MissionWorld world;
  const auto reasons = world.Add("ex:alpha ex:usesPolicy ex:fast .");
  EXPECT_NE(
      Joined(reasons).find("ex:alpha ex:usesPolicy: expected exactly one"),
      std::string::npos)
      << Joined(reasons);
}

TEST(ShapesTest, NotANumberIsNoConfidence) {
  MissionWorld world;
  EXPECT_FALSE(
      world.Set({"ex:w1", "ex:confidence", "\"NaN\"^^xsd:double"}).empty());
}

TEST(ShapesTest, NothingTypesAnEventAsALayer) {
  MissionWorld world;
  const auto view = world.store.Read();
  EXPECT_EQ(view->Find(kg_core::Rdfs("domain")), kg_core::kNoTerm);
  EXPECT_EQ(view->Find(kg_core::Rdfs("range")), kg_core::kNoTerm);
}

}  // namespace
}  // namespace kg_mission
