#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>

#include "kg_base/common/sha256.h"
#include "kg_core/facts/terms.h"
#include "kg_core/facts/update_log.h"
#include "kg_core/facts/vocabulary.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/ingested_facts.h"
#include "kg_mission/mission/stage_update.h"
#include "kg_mission/mission/stage_vocabulary.h"
#include "kg_mission/mission/testing/mission_world.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::Fact;
using kg_core::FactUpdate;
using kg_core::FirstObject;
using kg_core::GeoTerm;
using kg_core::Has;
using kg_core::Iri;
using kg_core::Literal;
using kg_core::Objects;
using kg_core::Prov;
using kg_core::RdfType;
using kg_core::Subjects;
using kg_core::Term;
using kg_core::Transaction;
using kg_core::WktLiteral;

// Expects that a reason contains `said`.
void ExpectSaid(const std::vector<std::string>& reasons,
                const std::string& said) {
  EXPECT_NE(Joined(reasons).find(said), std::string::npos)
      << "wanted: " << said << "\ngot: " << Joined(reasons);
}

Term PolicyOfAlpha(const MissionWorld& world) {
  return FirstObject(*world.store.Read(), kg_core::kFactsGraph, Ex("alpha"),
                     Ex("usesPolicy"))
      .value_or(Term());
}

TEST(FactUpdateTest, SetReplacesAllValues) {
  MissionWorld world;
  EXPECT_EQ(Joined(world.Set({"ex:alpha", "ex:usesPolicy", "ex:fast"})), "");
  EXPECT_EQ(PolicyOfAlpha(world), Ex("fast"));
}

TEST(FactUpdateTest, SetOfTwoValuesKeepsBoth) {
  MissionWorld world;
  const Fact w0 = {"ex:seep", "ex:forWindow", "ex:w0"};
  const Fact w1 = {"ex:seep", "ex:forWindow", "ex:w1"};
  EXPECT_EQ(Joined(world.Commit({"", "test", {w0, w1}, {}, {}, ""})), "");
  EXPECT_EQ(Objects(*world.store.Read(), kg_core::kFactsGraph, Ex("seep"),
                    Ex("forWindow"))
                .size(),
            2u);
}

TEST(FactUpdateTest, SettingWhatIsSoChangesNothing) {
  MissionWorld world;
  Transaction transaction = world.store.Begin();
  const FactUpdate update = {
      "", "test", {{"ex:alpha", "ex:usesPolicy", "ex:safe"}}, {}, {}, ""};
  EXPECT_EQ(Joined(StageUpdate(update, transaction)), "");
  kg_core::LogUpdate(update, 0.0, transaction);
  EXPECT_TRUE(transaction.empty());
}

TEST(FactUpdateTest, RefusesAnUnknownPropertyAndNamesTheNearest) {
  MissionWorld world;
  ExpectSaid(world.Set({"ex:alpha", "ex:usePolicy", "ex:fast"}),
             "ex:usePolicy is not a property of the ontology, the nearest is "
             "ex:usesPolicy");
  ExpectSaid(world.Add("ex:alpha ex:mobilty \"glider\" ."), "ex:mobility");
}

TEST(FactUpdateTest, RefusesAnUnknownClassAndNamesTheNearest) {
  MissionWorld world;
  ExpectSaid(world.Add("ex:e a ex:Evnt ."), "the nearest is ex:Event");
}

TEST(FactUpdateTest, RefusesFactsAboutASubjectWithoutAClass) {
  MissionWorld world;
  ExpectSaid(world.Set({"ex:alpa", "ex:id", "\"alpa\""}),
             "ex:alpa: has facts but no class");
  ExpectSaid(world.Remove({"ex:seep", "a", "ex:Event"}), "no class");
}

TEST(FactUpdateTest, RefusesAPropertyOnTheWrongClass) {
  MissionWorld world;
  ExpectSaid(world.Set({"ex:alpha", "ex:cruiseSpeedKts", "0.8"}),
             "belongs to ex:AgentCapabilities, not to ex:Agent");
}

TEST(FactUpdateTest, RefusesValuesOfAnotherType) {
  MissionWorld world;
  ExpectSaid(world.Set({"ex:w1", "ex:confidence", "\"0.5\""}),
             "expected xsd:double, not \"0.5\"");
  ExpectSaid(world.Set({"ex:w1", "ex:confidence", "\"NaN\"^^xsd:double"}),
             "expected xsd:double");
  ExpectSaid(world.Set({"ex:w1", "ex:index", "1.0"}), "expected xsd:integer");
  ExpectSaid(world.Set({"ex:w1", "time:hasBeginning", "\"tomorrow\""}),
             "expected xsd:dateTime");
  ExpectSaid(
      world.Set({"ex:w1", "time:hasBeginning", "\"tomorrow\"^^xsd:dateTime"}),
      "expected xsd:dateTime");
  ExpectSaid(world.Set({"ex:alpha", "ex:usesPolicy", "\"fast\""}),
             "expected an instance of ex:Policy, not \"fast\"");
}

TEST(FactUpdateTest, DoublesMayBeWrittenAsIntegersAndDecimals) {
  MissionWorld world;
  for (const char* value : {"1", "0.5", "5e-1"}) {
    EXPECT_EQ(Joined(world.Set({"ex:w1", "ex:confidence", value})), "");
  }
}

TEST(FactUpdateTest, RefusesMalformedTermsAndTurtleWithThePlace) {
  MissionWorld world;
  ExpectSaid(world.Set({"ex:alpha", "ex:usesPolicy", "ex fast"}),
             "set ex:alpha ex:usesPolicy ex fast: ");
  ExpectSaid(world.Set({"nope:alpha", "ex:usesPolicy", "ex:fast"}), "nope");
  ExpectSaid(world.Add("ex:e a ex:Event\nex:value 3 ."), "update of test:2");
  ExpectSaid(world.Set({"\"alpha\"", "ex:usesPolicy", "ex:fast"}),
             "expected an IRI as subject");
}

TEST(FactUpdateTest, RefusesMalformedWktWithThePosition) {
  MissionWorld world;
  const auto reasons = world.Set(
      {"ex:sanctuary", "geo:asWKT", "\"POLYGON((-94 27, -93 x, -94 27))\""});
  ExpectSaid(reasons, "ex:sanctuary geo:asWKT: ");
  ExpectSaid(reasons, "2");  // A column number in the message.
  ExpectSaid(reasons, "expected");
}

TEST(FactUpdateTest, TakesSparqlUpdatesOfTheFactsAndRefusesThoseOfOtherGraphs) {
  MissionWorld world;
  FactUpdate update;
  update.sparql =
      "DELETE { ?a ex:usesPolicy ?p } INSERT { ?a ex:usesPolicy ex:safe } "
      "WHERE { ?a ex:usesPolicy ?p ; ex:id \"alpha\" }";
  EXPECT_EQ(Joined(world.Commit(update)), "");
  EXPECT_TRUE(Has(*world.store.Read(), kg_core::kFactsGraph, Ex("alpha"),
                  Ex("usesPolicy"), Ex("safe")));
  update.sparql = "DELETE WHERE { ?a ex:usesPolicy ?p }";
  ExpectSaid(world.Commit(update), "ex:usesPolicy");
  update.sparql = "DELETE WHERE {";
  ExpectSaid(world.Commit(update), "sparql: 1:");
  update.sparql = "CLEAR GRAPH graph:vocab";
  ExpectSaid(world.Commit(update), "sparql: ");
}

TEST(FactUpdateTest, PlainStringsBecomeWktAndGeometryNodesFollow) {
  MissionWorld world;
  const std::string wkt = "POLYGON((-95 27, -93 27, -93 28, -95 28, -95 27))";
  ASSERT_EQ(Joined(world.Set({"ex:sanctuary", "geo:asWKT", "\"" + wkt + "\""})),
            "");
  const auto view = world.store.Read();
  const auto node = FirstObject(*view, kg_core::kFactsGraph, Ex("sanctuary"),
                                GeoTerm("hasGeometry"));
  ASSERT_TRUE(node);
  EXPECT_EQ(Objects(*view, kg_core::kFactsGraph, *node, GeoTerm("asWKT")),
            std::vector<Term>{WktLiteral(wkt)});
  EXPECT_EQ(
      Objects(*view, kg_core::kFactsGraph, Ex("sanctuary"), GeoTerm("asWKT")),
      std::vector<Term>{WktLiteral(wkt)});
}

TEST(FactUpdateTest, AGeometryNodeGivesItsFeatureTheShortForm) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Add(
                "ex:reef a ex:Constraint ; ex:kind \"no_go\" ; geo:hasGeometry "
                "ex:reef_shape . ex:reef_shape a geo:Geometry ; geo:asWKT "
                "\"POLYGON((-91 27, -90 27, -90 28, -91 27))\" .")),
            "");
  EXPECT_TRUE(FirstObject(*world.store.Read(), kg_core::kFactsGraph, Ex("reef"),
                          GeoTerm("asWKT")));
}

TEST(FactUpdateTest, JsonBecomesTypedNodesAndIsKept) {
  MissionWorld world;
  const Term node = Iri(Ex("safe").text + "/prior/corridor");
  const auto beta = [&] {
    return FirstObject(*world.store.Read(), kg_core::kFactsGraph, node,
                       Ex("beta"));
  };
  ASSERT_TRUE(beta());
  EXPECT_EQ(kg_core::NumericValue(*beta()), 0.8);
  ASSERT_EQ(
      Joined(world.Set({"ex:safe", "ex:priors", "'{\"ex:corridor\": -2}'"})),
      "");
  EXPECT_EQ(kg_core::NumericValue(*beta()), -2.0);
  ASSERT_EQ(Joined(world.Remove({"ex:safe", "ex:priors", ""})), "");
  EXPECT_FALSE(beta());
  EXPECT_FALSE(FirstObject(*world.store.Read(), kg_core::kFactsGraph,
                           Ex("safe"), Ex("hasPriorWeight")));
}

TEST(FactUpdateTest, RefusesJsonThatIsNoneAndNamesThatNothingHas) {
  MissionWorld world;
  const auto set = [&](const std::string& json) {
    return world.Set({"ex:safe", "ex:priors", "'" + json + "'"});
  };
  ExpectSaid(set("{\"corridor\": 0.8"), "ex:safe ex:priors: not JSON at byte");
  ExpectSaid(set("[1]"), "expected a JSON object");
  ExpectSaid(set("{\"corridor\": \"high\"}"), "expected a number");
  ExpectSaid(set("{\"corridor\": 1, \"corridor\": 2}"), "stands twice");
  ExpectSaid(set("{\"coridor\": 0.8}"),
             "no ex:PriorLayer is named \"coridor\"; known: corridor");
  ExpectSaid(set("{\"corridor\": 1e400}"), "not JSON");
  ExpectSaid(world.Set({"ex:safe", "ex:softOverrides", "'{\"land\": 0.1}'"}),
             "of kind \"soft\"");
}

TEST(FactUpdateTest, OtherNamesAreStoredAsWhatTheyStandFor) {
  MissionWorld world(std::string(kTestFacts) + kTestArtifacts);
  const auto types = [&](const char* name) {
    return Objects(*world.store.Read(), kg_core::kFactsGraph, Ex(name),
                   RdfType());
  };
  const Term observed = Iri(std::string(kg_core::kSosa) + "observedProperty");
  EXPECT_EQ(types("layer1"), std::vector<Term>{Ex("ValueLayer")});
  ASSERT_EQ(Joined(world.Set({"ex:field", "a", "ex:WorkLayer"})), "");
  EXPECT_EQ(types("field"), std::vector<Term>{Ex("WorkField")});
  ASSERT_EQ(Joined(world.Set(
                {"ex:field", "ssn:observedProperty", "ex:seaWaterVelocity"})),
            "");
  EXPECT_EQ(
      Objects(*world.store.Read(), kg_core::kFactsGraph, Ex("field"), observed),
      std::vector<Term>{Ex("seaWaterVelocity")});
  ASSERT_EQ(Joined(world.Remove({"ex:field", "ssn:observedProperty", ""})), "");
  EXPECT_FALSE(FirstObject(*world.store.Read(), kg_core::kFactsGraph,
                           Ex("field"), observed));
  FactUpdate update;
  update.sparql =
      "INSERT DATA { ex:field ssn:observedProperty ex:seaWaterVelocity . "
      "ex:shape a geo:Geometry ; geo:asWKT \"POINT(1 2)\" }";
  ASSERT_EQ(Joined(world.Commit(update)), "");
  EXPECT_TRUE(Has(*world.store.Read(), kg_core::kFactsGraph, Ex("field"),
                  observed, Ex("seaWaterVelocity")));
  EXPECT_TRUE(Has(*world.store.Read(), kg_core::kFactsGraph, Ex("shape"),
                  GeoTerm("asWKT"), WktLiteral("POINT(1 2)")));
}

TEST(FactUpdateTest, AGeometryLinkToSomethingElseIsRefusedAndHarmsNothing) {
  MissionWorld world;
  FactUpdate update;
  update.turtle =
      "ex:sanctuary geo:hasGeometry ex:alpha ; geo:asWKT "
      "\"POLYGON((-95 27, -93 27, -93 28, -95 27))\" .";
  update.remove = {{"ex:sanctuary", "geo:asWKT", ""}};
  ExpectSaid(world.Commit(update), "ex:sanctuary geo:hasGeometry: expected");
  EXPECT_EQ(Joined(world.Commit(update)).find("ex:alpha ex:id"),
            std::string::npos);
}

TEST(FactUpdateTest, RefusesToRemoveWhatIsNotThere) {
  MissionWorld world;
  ExpectSaid(world.Remove({"ex:alpha", "ex:usesPolicy", "ex:fast"}),
             "there is no such fact");
  ExpectSaid(world.Remove({"ex:nobody", "", ""}), "there is no such fact");
}

TEST(FactUpdateTest, RemovesAWholeSubject) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Remove({"ex:seep", "", ""})), "");
  const auto view = world.store.Read();
  EXPECT_FALSE(FirstObject(*view, kg_core::kFactsGraph, Ex("seep"), RdfType()));
  EXPECT_FALSE(
      FirstObject(*view, kg_core::kFactsGraph, Ex("seep/geometry"), RdfType()));
}

TEST(FactUpdateTest, APolicyTakesItsTypedNodesWithIt) {
  MissionWorld world;
  ASSERT_EQ(Joined(world.Set({"ex:alpha", "ex:usesPolicy", "ex:fast"})), "");
  ASSERT_EQ(Joined(world.Remove({"ex:safe", "", ""})), "");
  const auto view = world.store.Read();
  EXPECT_TRUE(
      Subjects(*view, kg_core::kFactsGraph, RdfType(), Ex("PriorWeight"))
          .empty());
  EXPECT_TRUE(
      Subjects(*view, kg_core::kFactsGraph, RdfType(), Ex("SoftOverride"))
          .empty());
}

TEST(FactUpdateTest, RefusesToRemoveWhatOthersPointAt) {
  MissionWorld world;
  ExpectSaid(world.Remove({"ex:safe", "", ""}), "ex:alpha ex:usesPolicy");
  ExpectSaid(world.Remove({"ex:corridor", "", ""}), "ex:layer");
  ExpectSaid(world.Remove({"ex:m", "", ""}), "exactly one ex:Mission");
}

TEST(FactUpdateTest, ARefusedUpdateLeavesNothingBehind) {
  MissionWorld world;
  const auto before = world.store.world_version();
  const auto quads = world.store.quad_count();
  FactUpdate update;
  update.set = {{"ex:alpha", "ex:usesPolicy", "ex:fast"},
                {"ex:w1", "ex:confidence", "1.2"}};
  EXPECT_FALSE(world.Commit(update).empty());
  EXPECT_EQ(world.store.world_version(), before);
  EXPECT_EQ(world.store.quad_count(), quads);
  EXPECT_EQ(PolicyOfAlpha(world), Ex("safe"));
}

TEST(FactUpdateTest, RefusesAMissionThatCanNoLongerBeRead) {
  MissionWorld world;
  ExpectSaid(world.Remove({"ex:bravo_start", "", ""}),
             "ex:AgentState with ex:forAgent ex:bravo");
  ExpectSaid(world.Set({"ex:w1", "ex:index", "5"}), "run from 0");
}

TEST(FactUpdateTest, TheLogKeepsWhoWhatOldAndNew) {
  MissionWorld world;
  FactUpdate update;
  update.id = "u7";
  update.author = "Ann B";
  update.set = {{"ex:alpha", "ex:usesPolicy", "ex:fast"}};
  ASSERT_EQ(Joined(world.Commit(update)), "");
  const auto view = world.store.Read();
  const Term activity =
      Iri(kg_core::kLogGraph +
          ("/v" + std::to_string(world.store.world_version())));
  EXPECT_TRUE(
      Has(*view, kg_core::kProvGraph, activity, RdfType(), Prov("Activity")));
  EXPECT_TRUE(Has(*view, kg_core::kProvGraph, activity, Ex("author"),
                  Literal("Ann B")));
  EXPECT_TRUE(
      Has(*view, kg_core::kProvGraph, activity, Ex("updateId"), Literal("u7")));
  EXPECT_TRUE(Has(*view, kg_core::kProvGraph, activity,
                  Prov("wasAssociatedWith"), Ex("author/Ann%20B")));
  const auto changes =
      Subjects(*view, kg_core::kLogGraph, Ex("ofSubject"), Ex("alpha"));
  bool is_logged = false;
  for (const Term& change : changes) {
    is_logged |=
        Has(*view, kg_core::kLogGraph, change, Ex("inUpdate"), activity) &&
        Has(*view, kg_core::kLogGraph, change, Ex("ofProperty"),
            Ex("usesPolicy")) &&
        Has(*view, kg_core::kLogGraph, change, Ex("oldValue"), Ex("safe")) &&
        Has(*view, kg_core::kLogGraph, change, Ex("newValue"), Ex("fast"));
  }
  EXPECT_TRUE(is_logged);
}

TEST(FactUpdateTest, ManyReasonsAreCutShort) {
  MissionWorld world;
  FactUpdate update;
  for (int i = 0; i < 100; ++i) {
    update.add.push_back({"ex:alpha", "ex:nothing" + std::to_string(i), "1"});
  }
  EXPECT_EQ(world.Commit(update).size(), 21u);
}

TEST(FactUpdateTest, ReadsTheVocabularyOnceOnly) {
  MissionWorld world;
  Transaction again = world.store.Begin();
  StageVocabulary("ontology", again);
  EXPECT_TRUE(again.empty());
}

TEST(FactUpdateTest, TheLogNamesAuthorTimeIdAndFiles) {
  MissionWorld world;
  Transaction transaction = world.store.Begin();
  FactUpdate update;
  update.id = "u7";
  update.author = "operator";
  update.set = {{"ex:alpha", "ex:usesPolicy", "ex:fast"}};
  update.files = {{"", "/missions/m.ttl", std::string(64, 'a')}};
  ASSERT_EQ(Joined(StageUpdate(update, transaction)), "");
  kg_core::LogUpdate(update, 1.78e9, transaction);
  const kg_core::GraphView& view = transaction.view();
  const std::vector<Term> activities =
      Subjects(view, kg_core::kProvGraph, Ex("updateId"), Literal("u7"));
  ASSERT_EQ(activities.size(), 1u);
  EXPECT_TRUE(Has(view, kg_core::kProvGraph, activities[0], Ex("author"),
                  Literal("operator")));
  EXPECT_EQ(FirstObject(view, kg_core::kProvGraph, activities[0],
                        Prov("startedAtTime"))
                ->text,
            "2026-05-28T20:26:40Z");
  const auto file =
      FirstObject(view, kg_core::kProvGraph, activities[0], Prov("used"));
  ASSERT_TRUE(file);
  EXPECT_TRUE(Has(view, kg_core::kProvGraph, *file, Ex("path"),
                  Literal("/missions/m.ttl")));
  EXPECT_TRUE(Has(view, kg_core::kProvGraph, *file, Ex("sha256"),
                  Literal(std::string(64, 'a'))));
}

TEST(FactUpdateTest, AVocabularyIsLoggedByItsFilesNotByItsTriples) {
  kg_core::Store store("");
  Transaction transaction = store.Begin();
  const std::vector<kg_core::SourceFile> files =
      StageVocabulary("ontology", transaction);
  kg_core::LogVocabulary(files, 1.78e9, transaction);
  const kg_core::GraphView& view = transaction.view();
  const std::vector<Term> loads =
      Subjects(view, kg_core::kProvGraph, RdfType(), Ex("LoadVocabulary"));
  ASSERT_EQ(loads.size(), 1u);
  const std::vector<Term> used =
      Objects(view, kg_core::kProvGraph, loads[0], Prov("used"));
  EXPECT_EQ(used.size(), files.size());
  for (const Term& file : used) {
    const auto path = FirstObject(view, kg_core::kProvGraph, file, Ex("path"));
    ASSERT_TRUE(path);
    EXPECT_TRUE(Has(view, kg_core::kProvGraph, file, Ex("sha256"),
                    Literal(kg_base::Sha256HexOfFile(path->text))));
  }
  kg_core::Quad logged;
  logged.graph = view.Find(Iri(kg_core::kLogGraph));
  EXPECT_EQ(logged.graph, kg_core::kNoTerm);
}

TEST(FactUpdateTest, IngestIsDueWhenSourcesOrWindowsChange) {
  MissionWorld world;
  const auto is_due = [&](const Fact& fact) {
    Transaction transaction = world.store.Begin();
    const FactUpdate update = {"", "test", {fact}, {}, {}, ""};
    EXPECT_EQ(Joined(StageUpdate(update, transaction)), "");
    return IngestIsDue(transaction);
  };
  EXPECT_FALSE(is_due({"ex:alpha", "ex:usesPolicy", "ex:fast"}));
  EXPECT_FALSE(is_due({"ex:w1", "ex:confidence", "0.5"}));
  EXPECT_TRUE(is_due({"ex:w1", "ex:durationHours", "12"}));
  Transaction transaction = world.store.Begin();
  FactUpdate update;
  update.turtle =
      "ex:s a ex:DataSource ; ex:file \"a.nc\" ; ex:provides \"current\" .";
  EXPECT_EQ(Joined(StageUpdate(update, transaction)), "");
  EXPECT_TRUE(IngestIsDue(transaction));
}

// Reference: the recursive definition.
int SlowDistance(const std::string& a, const std::string& b) {
  if (a.empty()) return static_cast<int>(b.size());
  if (b.empty()) return static_cast<int>(a.size());
  const std::string a1 = a.substr(1), b1 = b.substr(1);
  if (a[0] == b[0]) return SlowDistance(a1, b1);
  return 1 + std::min({SlowDistance(a1, b), SlowDistance(a, b1),
                       SlowDistance(a1, b1)});
}

TEST(EditDistanceTest, EqualsTheRecursiveDefinition) {
  std::mt19937 random(7);
  std::uniform_int_distribution<int> length(0, 6), letter('a', 'c');
  const auto word = [&] {
    std::string text(length(random), 'a');
    for (char& c : text) c = static_cast<char>(letter(random));
    return text;
  };
  for (int i = 0; i < 500; ++i) {
    const std::string a = word(), b = word();
    EXPECT_EQ(kg_core::EditDistance(a, b), SlowDistance(a, b)) << a << " " << b;
  }
}

}  // namespace
}  // namespace kg_mission
