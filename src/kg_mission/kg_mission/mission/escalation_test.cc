// Escalation of soft to hard constraints and operator rules on mission facts,
// through updates, shapes and the mission reader. Includes the example of
// docs/rules.md.

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_core/rules/inference.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/testing/mission_world.h"
#include "kg_mission/mission/validator.h"

namespace kg_mission {
namespace {

using kg_core::Ex;

using Zones = std::vector<std::string>;

// Local names of the constraints that the agent must avoid.
Zones AvoidedBy(const MissionWorld& world, const std::string& agent) {
  Zones zones;
  const Mission mission = ReadMission(*world.store.Read());
  for (const auto& [zone, sources] :
       mission.FindAgent(Ex(agent).text)->must_avoid) {
    EXPECT_FALSE(sources.empty());
    zones.push_back(zone.substr(std::string(kg_core::kEx).size()));
  }
  return zones;
}

std::vector<kg_core::Inference> WhyAvoids(const MissionWorld& world,
                                          const std::string& agent,
                                          const std::string& zone) {
  return kg_core::WhyInferred(*world.store.Read(),
                              {Ex(agent), Ex("mustAvoid"), Ex(zone)});
}

TEST(Escalation, NeedsAPolicyThatAllowsIt) {
  const MissionWorld world;
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones());
  EXPECT_EQ(AvoidedBy(world, "bravo"), Zones());
}

TEST(Escalation, FollowsThePolicyOfTheAgentAndOfNoOther) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Set({"ex:safe", "ex:escalateSoft", "true"})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), (Zones{"cool", "sanctuary"}));
  EXPECT_EQ(AvoidedBy(world, "bravo"), Zones());
  EXPECT_EQ(Joined(world.Set({"ex:alpha", "ex:usesPolicy", "ex:fast"})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones());
  EXPECT_EQ(Joined(world.Set({"ex:bravo", "ex:usesPolicy", "ex:safe"})), "");
  EXPECT_EQ(AvoidedBy(world, "bravo"), (Zones{"cool", "sanctuary"}));
  EXPECT_EQ(Joined(world.Set({"ex:safe", "ex:escalateSoft", "false"})), "");
  EXPECT_EQ(AvoidedBy(world, "bravo"), Zones());
}

TEST(Escalation, IsOfConstraintsThatAttenuateWithThePolicysOverride) {
  MissionWorld world;
  world.Set({"ex:safe", "ex:escalateSoft", "\"1\"^^xsd:boolean"});
  EXPECT_EQ(Joined(world.Set(
                {"ex:safe", "ex:softOverrides", "'{\"sanctuary\": 1.0}'"})),
            "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones{"cool"});
  EXPECT_EQ(Joined(world.Set({"ex:cool", "ex:attenuation", "1"})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones());
  EXPECT_EQ(Joined(world.Remove({"ex:safe", "ex:softOverrides", ""})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones{"sanctuary"});
}

TEST(Escalation, SaysWhichRuleAndBecauseOfWhichFacts) {
  MissionWorld world;
  world.Set({"ex:safe", "ex:escalateSoft", "true"});
  const auto why = WhyAvoids(world, "alpha", "sanctuary");
  ASSERT_EQ(why.size(), 1u);
  EXPECT_EQ(why[0].rule_iri, Ex("escalation").text);
  std::vector<std::string> properties;
  for (const kg_core::Triple& premise : why[0].premises) {
    properties.push_back(kg_core::ToTurtle(premise.predicate));
    EXPECT_TRUE(kg_core::Has(*world.store.Read(), kg_core::kFactsGraph,
                             premise.subject, premise.predicate,
                             premise.object));
  }
  std::sort(properties.begin(), properties.end());
  EXPECT_EQ(properties, (std::vector<std::string>{
                            "ex:attenuation", "ex:attenuation", "ex:constraint",
                            "ex:escalateSoft", "ex:hasSoftOverride", "ex:kind",
                            "ex:usesPolicy"}));
  const Mission mission = ReadMission(*world.store.Read());
  const auto& avoided = mission.FindAgent(Ex("alpha").text)->must_avoid;
  EXPECT_EQ(avoided.at(Ex("sanctuary").text), Zones{why[0].iri});
}

TEST(Escalation, IsAnsweredBySparqlDownToTheFacts) {
  MissionWorld world;
  world.Set({"ex:safe", "ex:escalateSoft", "true"});
  const kg_core::QueryResult result = kg_core::RunQuery(
      *world.store.Read(),
      "SELECT ?label ?s ?p ?o { ?i ex:conclusion [ rdf:subject ex:alpha ; "
      "rdf:predicate ex:mustAvoid ; rdf:object ex:cool ] ; "
      "ex:byRule/rdfs:label ?label ; prov:wasDerivedFrom ?f . "
      "?f rdf:subject ?s ; rdf:predicate ?p ; rdf:object ?o } ORDER BY ?s ?p",
      kg_core::DefaultDataset(std::nullopt), {});
  ASSERT_EQ(result.rows.size(), 4u);
  EXPECT_EQ(result.rows[0][0], kg_core::Literal("soft to hard"));
  EXPECT_EQ(result.rows[0][1], Ex("alpha"));
  EXPECT_EQ(result.rows[0][2], Ex("usesPolicy"));
  EXPECT_EQ(result.rows[0][3], Ex("safe"));
}

TEST(Escalation, StopsWhenTheRuleIsSwitchedOffByAFact) {
  MissionWorld world;
  world.Set({"ex:safe", "ex:escalateSoft", "true"});
  EXPECT_EQ(Joined(world.Set({"ex:escalation", "ex:enabled", "false"})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones());
  EXPECT_EQ(Joined(world.Remove({"ex:escalation", "ex:enabled", ""})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), (Zones{"cool", "sanctuary"}));
}

TEST(Escalation, AnOperatorMaySayItOfOneAgent) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Set({"ex:bravo", "ex:mustAvoid", "ex:sanctuary"})),
            "");
  EXPECT_EQ(AvoidedBy(world, "bravo"), Zones{"sanctuary"});
  const Mission mission = ReadMission(*world.store.Read());
  EXPECT_EQ(
      mission.FindAgent(Ex("bravo").text)->must_avoid.at(Ex("sanctuary").text),
      Zones{Ex("bravo").text});
  EXPECT_NE(Joined(world.Set({"ex:bravo", "ex:mustAvoid", "ex:w0"})), "");
}

TEST(Escalation, IsThereForFactsThatCameBeforeTheRule) {
  MissionWorld world(std::string(kTestFacts) +
                     "ex:safe ex:escalateSoft true .");
  EXPECT_EQ(AvoidedBy(world, "alpha"), (Zones{"cool", "sanctuary"}));
}

// Rules stated by an operator.

// The Turtle block in docs/rules.md.
std::string DocumentedRule() {
  std::ifstream file("../../docs/rules.md");
  const std::string text((std::istreambuf_iterator<char>(file)),
                         std::istreambuf_iterator<char>());
  const std::size_t begin = text.find("```turtle\n") + 10;
  return text.substr(begin, text.find("```", begin) - begin);
}

TEST(OperatorRules, TheDocumentedOneDoesWhatIsSaidOfIt) {
  MissionWorld world;
  const std::string rule = DocumentedRule();
  ASSERT_NE(rule.find("ex:construct"), std::string::npos);
  EXPECT_EQ(Joined(world.Add(rule)), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones());
  EXPECT_EQ(Joined(world.Set({"ex:alpha_can", "ex:energyBudget", "250"})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones{"sanctuary"});
  EXPECT_EQ(AvoidedBy(world, "bravo"), Zones{"sanctuary"});
  EXPECT_EQ(WhyAvoids(world, "alpha", "sanctuary").at(0).rule_iri,
            Ex("lowEnergy").text);
  EXPECT_EQ(Joined(world.Set({"ex:lowEnergy", "ex:enabled", "false"})), "");
  EXPECT_EQ(AvoidedBy(world, "alpha"), Zones());
}

std::string RuleThat(const std::string& construct) {
  return "ex:own a ex:Rule ; rdfs:label 'own' ; rdfs:comment 'For a test.' ; "
         "ex:construct '''" +
         construct + "''' .";
}

TEST(OperatorRules, ConclusionsAreReadLikeFacts) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Add(RuleThat(
                "CONSTRUCT { ?e ex:radiusKm 40 } WHERE { ?e a ex:Event }"))),
            "");
  EXPECT_EQ(ReadMission(*world.store.Read()).events.at(0).radius_m, 40000.0);
}

TEST(OperatorRules, ConclusionsThatMakeTheFactsInvalidAreRefused) {
  MissionWorld world;
  const std::string second = Joined(world.Add(RuleThat(
      "CONSTRUCT { ?a ex:usesPolicy ex:fast } WHERE { ?a a ex:Agent }")));
  EXPECT_NE(second.find("ex:alpha ex:usesPolicy: expected exactly one"),
            std::string::npos)
      << second;
  EXPECT_NE(second.find("(concluded by ex:own)"), std::string::npos) << second;
  const std::string range = Joined(world.Add(RuleThat(
      "CONSTRUCT { ?a ex:mustAvoid 'north' } WHERE { ?a a ex:Agent }")));
  EXPECT_NE(range.find("expected an instance of ex:Constraint"),
            std::string::npos)
      << range;
  const std::string domain = Joined(world.Add(
      RuleThat("CONSTRUCT { ?a ex:index 7 } WHERE { ?a a ex:Agent }")));
  EXPECT_NE(domain.find("may not conclude ex:index"), std::string::npos)
      << domain;
  EXPECT_TRUE(Validate(*world.store.Read()).empty());
}

TEST(OperatorRules, AFactThatMakesAConclusionInvalidIsRefused) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Add(RuleThat(
                "CONSTRUCT { ?e ex:radiusKm 40 } WHERE { ?e a ex:Event }"))),
            "");
  const std::string reasons =
      Joined(world.Set({"ex:seep", "ex:radiusKm", "30"}));
  EXPECT_NE(reasons.find("(concluded by ex:own)"), std::string::npos)
      << reasons;
  EXPECT_EQ(Joined(world.Set({"ex:seep", "ex:radiusKm", "40"})), "");
}

TEST(OperatorRules, OneThatDoesNotParseIsRefusedInOneLine) {
  MissionWorld world;
  const auto reasons =
      world.Add(RuleThat("CONSTRUCT { ?a ex:mustAvoid ?z } WHERE { ?a }"));
  ASSERT_EQ(reasons.size(), 1u);
  EXPECT_EQ(reasons[0].find("ex:own ex:construct: 1:"), 0u) << reasons[0];
  EXPECT_EQ(Joined(world.Set({"ex:escalation", "ex:construct", "\"nonsense\""}))
                .find("ex:escalation ex:construct: 1:1: expected SELECT"),
            0u);
}

TEST(OperatorRules, AreNamedOnlyByPropertiesOfRules) {
  MissionWorld world;
  EXPECT_NE(Joined(world.Set({"ex:escalation", "ex:index", "1"})), "");
  EXPECT_NE(Joined(world.Set({"ex:nobody", "ex:enabled", "false"})), "");
}

}  // namespace
}  // namespace kg_mission
