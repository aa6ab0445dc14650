// Rules case by case: rejection, cited premises, termination.

#include "kg_core/rules/inference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_core/rules/testing/rule_store.h"
#include "kg_core/sparql/query_engine.h"

namespace kg_core {
namespace {

using Lines = std::vector<std::string>;

// The first reason why a rule with this text is rejected; empty if it is
// accepted.
std::string GetRefusal(const std::string& construct) {
  RuleStore store;
  const Lines reasons = store.AddRule("r", construct);
  EXPECT_LE(reasons.size(), 1u);
  return reasons.empty() ? "" : reasons[0];
}

// The premises of the only inference of a triple, as Turtle.
Lines CollectPremises(const RuleStore& store, const std::string& subject,
                      const std::string& property, const std::string& object) {
  const auto why = WhyInferred(
      *store.store.Read(), {ParseTurtleTerm(subject), ParseTurtleTerm(property),
                            ParseTurtleTerm(object)});
  EXPECT_EQ(why.size(), 1u);
  Lines premises;
  if (why.empty()) return premises;
  for (const Triple& t : why[0].premises) {
    premises.push_back(ToTurtle(t.subject) + " " + ToTurtle(t.predicate) + " " +
                       ToTurtle(t.object));
  }
  std::sort(premises.begin(), premises.end());
  return premises;
}

TEST(Inference, FollowsTheFactsAndGoesWithThem) {
  RuleStore store;
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a ex:p1 ?b } WHERE "
                          "{ ?a ex:p0 ?b }"),
            Lines());
  EXPECT_EQ(store.Change("ex:a ex:p0 ex:b ."), Lines());
  EXPECT_TRUE(store.Infers("ex:a", "ex:p1", "ex:b"));
  EXPECT_EQ(store.Change("", "ex:a ex:p0 ex:b ."), Lines());
  EXPECT_FALSE(store.Infers("ex:a", "ex:p1", "ex:b"));
  const auto view = store.store.Read();
  EXPECT_EQ(WriteTurtle(*view, kInferredGraph).find("ex:Inference"),
            std::string::npos);
}

TEST(Inference, GoesWithTheRuleAndWhenTheRuleIsSwitchedOff) {
  RuleStore store;
  const std::string rule = RuleStore::RuleTurtle(
      "r", "CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p0 ?b }");
  EXPECT_EQ(store.Change(rule + "ex:a ex:p0 ex:b ."), Lines());
  EXPECT_EQ(store.Change("ex:r ex:enabled false ."), Lines());
  EXPECT_FALSE(store.Infers("ex:a", "ex:p1", "ex:b"));
  EXPECT_EQ(store.Change("ex:r ex:enabled true .", "ex:r ex:enabled false ."),
            Lines());
  EXPECT_TRUE(store.Infers("ex:a", "ex:p1", "ex:b"));
  EXPECT_EQ(store.Change("", rule), Lines());
  EXPECT_FALSE(store.Infers("ex:a", "ex:p1", "ex:b"));
}

TEST(Inference, IsPartOfTheTransactionAndNotBeforeIt) {
  RuleStore store;
  store.AddRule("r", "CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p0 ?b }");
  {
    Transaction transaction = store.store.Begin();
    transaction.Add({Ex("a"), Ex("p0"), Ex("b"), Facts()});
    EXPECT_TRUE(StageInferences(transaction, RuleStore::FindForbidden).empty());
    EXPECT_TRUE(
        Has(transaction.view(), kInferredGraph, Ex("a"), Ex("p1"), Ex("b")));
    EXPECT_FALSE(store.Infers("ex:a", "ex:p1", "ex:b"));
  }
  EXPECT_FALSE(store.Infers("ex:a", "ex:p1", "ex:b"));
}

TEST(Inference, LeavesTheGraphAloneIfNoRuleReadsWhatChanged) {
  RuleStore store;
  store.Change(RuleStore::RuleTurtle(
                   "r", "CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p0 ?b }") +
               "ex:a ex:p0 ex:b .");
  // Plants a marker in the inferred graph: if it survives, the graph was not
  // rewritten.
  Transaction mark = store.store.Begin();
  mark.Add({Ex("mark"), Ex("p3"), Ex("mark"), Iri(kInferredGraph)});
  mark.Commit(WorldChange::kYes);
  EXPECT_EQ(store.Change("ex:a ex:p2 ex:b . ex:a a ex:C0 ."), Lines());
  EXPECT_TRUE(store.Infers("ex:mark", "ex:p3", "ex:mark"));
  EXPECT_EQ(store.Change("ex:b ex:p0 ex:c ."), Lines());
  EXPECT_FALSE(store.Infers("ex:mark", "ex:p3", "ex:mark"));
}

TEST(Inference, RunsWhenAnythingChangesForARuleThatReadsEveryProperty) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a ex:p1 ?b } WHERE "
                "{ ?a ?p ?b . FILTER(?p IN (ex:p0, ex:p2)) }");
  store.Change("ex:a ex:p2 ex:b .");
  EXPECT_TRUE(store.Infers("ex:a", "ex:p1", "ex:b"));
}

TEST(Inference, SeesNoReasonsOfOthers) {
  RuleStore store;
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a ex:p1 ?b } WHERE "
                          "{ ?a ex:p0 ?b }"),
            Lines());
  EXPECT_EQ(store.AddRule("s",
                          "CONSTRUCT { ?a ex:p2 ?b } WHERE "
                          "{ ?a prov:wasDerivedFrom ?b }"),
            Lines());
  EXPECT_EQ(store.Change("ex:a ex:p0 ex:b ."), Lines());
  for (const Statement& s : Conclusions(*store.store.Read())) {
    EXPECT_EQ(s.predicate, Ex("p1"));
  }
}

TEST(Inference, CitesWhatWhereMatched) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a ex:p3 ?c } WHERE { ?a ex:p0 ?b . "
                "OPTIONAL { ?b ex:p1 ?c } FILTER NOT EXISTS { ?a a ex:C2 "
                "} { ?a a ex:C0 } UNION { ?a a ex:C1 } }");
  store.Change("ex:a ex:p0 ex:b ; a ex:C1 . ex:b ex:p1 ex:c . ex:x a ex:C0 .");
  EXPECT_EQ(
      CollectPremises(store, "ex:a", "ex:p3", "ex:c"),
      (Lines{"ex:a ex:p0 ex:b", "ex:a rdf:type ex:C1", "ex:b ex:p1 ex:c"}));
}

TEST(Inference, CitesAShortestWayOfAPath) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a ex:p3 ?b } WHERE { ?a a ex:C0 . "
                "?a (ex:p0|^ex:p1)+ ?b . ?b a ex:C1 }");
  store.Change(
      "ex:a a ex:C0 ; ex:p0 ex:x , ex:y . ex:x ex:p0 ex:z . "
      "ex:z ex:p0 ex:b . ex:b ex:p1 ex:y ; a ex:C1 .");
  EXPECT_EQ(CollectPremises(store, "ex:a", "ex:p3", "ex:b"),
            (Lines{"ex:a ex:p0 ex:y", "ex:a rdf:type ex:C0", "ex:b ex:p1 ex:y",
                   "ex:b rdf:type ex:C1"}));
}

TEST(Inference, CitesSequencesAndNegatedSetsWithinPaths) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a ex:p3 ?b } WHERE { ?a a ex:C0 . "
                "?a (ex:p0/!(ex:p1|^ex:p2))? ?b . ?b a ex:C1 }");
  store.Change(
      "ex:a a ex:C0 ; ex:p0 ex:x . ex:x ex:p1 ex:b ; ex:p2 ex:b . "
      "ex:b a ex:C1 .");
  EXPECT_EQ(CollectPremises(store, "ex:a", "ex:p3", "ex:b"),
            (Lines{"ex:a ex:p0 ex:x", "ex:a rdf:type ex:C0",
                   "ex:b rdf:type "
                   "ex:C1",
                   "ex:x ex:p2 ex:b"}));
}

TEST(Inference, CitesAllThatAnAggregateCounted) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a ex:count ?n } WHERE { SELECT ?a "
                "(COUNT(?b) AS ?n) { ?a ex:p0 ?b } GROUP BY ?a }");
  store.Change("ex:a ex:p0 ex:b , ex:c . ex:d ex:p0 ex:e .");
  EXPECT_EQ(CollectPremises(store, "ex:a", "ex:count", "2"),
            (Lines{"ex:a ex:p0 ex:b", "ex:a ex:p0 ex:c"}));
  store.Change("", "ex:a ex:p0 ex:c .");
  EXPECT_EQ(CollectPremises(store, "ex:a", "ex:count", "1"),
            Lines{"ex:a ex:p0 ex:b"});
  EXPECT_FALSE(store.Infers("ex:a", "ex:count", "2"));
}

TEST(Inference, TakesGroupsThatSatisfyHaving) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a a ex:C0 } WHERE { ?a ex:p0 ?b } "
                "GROUP BY ?a HAVING (COUNT(?b) > 1)");
  store.Change("ex:a ex:p0 ex:b , ex:c . ex:d ex:p0 ex:e .");
  EXPECT_TRUE(store.Infers("ex:a", "rdf:type", "ex:C0"));
  EXPECT_FALSE(store.Infers("ex:d", "rdf:type", "ex:C0"));
}

TEST(Inference, KeepsAFewReasonsOfManyTheSameOnes) {
  RuleStore store;
  store.limits.reasons = 3;
  store.AddRule("r", "CONSTRUCT { ex:a a ex:C0 } WHERE { ex:a ex:p0 ?b }");
  std::string facts;
  for (int i = 0; i < 9; ++i) {
    facts += "ex:a ex:p0 ex:b" + std::to_string(i) + " . ";
  }
  store.Change(facts);
  EXPECT_EQ(
      WhyInferred(*store.store.Read(), {Ex("a"), RdfType(), Ex("C0")}).size(),
      3u);
}

TEST(Inference, LeadsOnFromAConclusionToItsOwnReasons) {
  RuleStore store;
  store.AddRule("r", "CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p0 ?b }");
  store.AddRule("s", "CONSTRUCT { ?a ex:p2 ?b } WHERE { ?a ex:p1 ?b }");
  store.Change("ex:a ex:p0 ex:b .");
  const std::string last = StatementIri({Ex("a"), Ex("p2"), Ex("b")});
  const QueryResult rests_on =
      RunQuery(*store.store.Read(),
               "SELECT ?p { <" + last +
                   "> prov:wasDerivedFrom+ ?f . ?f a rdf:Statement "
                   "; rdf:predicate ?p FILTER NOT EXISTS { ?f "
                   "prov:wasDerivedFrom ?x } }",
               DefaultDataset(std::nullopt), {});
  ASSERT_EQ(rests_on.rows.size(), 1u);
  EXPECT_EQ(rests_on.rows[0][0], Ex("p0"));
}

TEST(Inference, NamesBlankNodesOfATemplateByWhatTheyStandFor) {
  RuleStore store;
  store.AddRule("r",
                "CONSTRUCT { ?a ex:p1 [ a ex:C0 ; ex:p2 ?a ] } WHERE "
                "{ ?a ex:p0 ?b }");
  store.Change("ex:a ex:p0 ex:b , ex:c .");
  const auto view = store.store.Read();
  const auto nodes = Objects(*view, kInferredGraph, Ex("a"), Ex("p1"));
  ASSERT_EQ(nodes.size(), 1u);  // The template does not mention ?b.
  EXPECT_TRUE(nodes[0].is_iri());
  EXPECT_TRUE(Has(*view, kInferredGraph, nodes[0], Ex("p2"), Ex("a")));
}

TEST(Inference, EndsThoughARuleSaysThatThereIsAlwaysOneMore) {
  RuleStore store;
  store.limits.rounds = 20;
  EXPECT_EQ(store.Change("ex:a a ex:C0 ."), Lines());
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a ex:p0 [ a ex:C0 ] } WHERE "
                          "{ ?a a ex:C0 }"),
            Lines{"ex:r: no end after the limit of 20 rounds"});
  EXPECT_EQ(Conclusions(*store.store.Read()).size(), 0u);
}

TEST(Inference, RefusesMoreConclusionsThanTheLimit) {
  RuleStore store;
  store.limits.conclusions = 8;
  store.Change("ex:a a ex:C0 . ex:b a ex:C0 . ex:c a ex:C0 .");
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a ex:p0 ?b } WHERE "
                          "{ ?a a ex:C0 . ?b a ex:C0 }"),
            Lines{"ex:r: more conclusions than the limit of 8"});
}

TEST(Inference, RefusesRulesThatTakeTooLong) {
  RuleStore store;
  store.limits.seconds = 0.05;
  std::string facts;
  for (int i = 0; i < 300; ++i) {
    facts += "ex:x" + std::to_string(i) + " a ex:C0 . ";
  }
  store.Change(facts);
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a a ex:C1 } WHERE { ?a a ex:C0 . "
                          "?b a ex:C0 . ?c a ex:C0 . ?d a ex:C0 "
                          "FILTER(CONCAT(STR(?a), STR(?b), STR(?c), STR(?d)) "
                          "= '') }"),
            Lines{"ex:r: the rules took longer than the limit of 0.05 s"});
}

TEST(Inference, RefusesToDoubtWhatFollowsFromTheDoubt) {
  const std::string reason = GetRefusal(
      "CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p0 ?b FILTER NOT EXISTS "
      "{ ?b ex:p1 ?a } }");
  EXPECT_EQ(reason,
            "ex:r: its NOT EXISTS, MINUS, OPTIONAL or aggregate reads ex:p1, "
            "which ex:r concludes, and that depends in turn on what ex:r "
            "concludes");
  RuleStore store;
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a a ex:C0 } WHERE { ?a ex:p0 ?b "
                          "MINUS { ?a a ex:C1 } }"),
            Lines());
  EXPECT_EQ(store
                .AddRule("s",
                         "CONSTRUCT { ?a a ex:C1 } WHERE "
                         "{ ?a a ex:C0 }")
                .size(),
            1u);
  EXPECT_EQ(store.AddRule("s",
                          "CONSTRUCT { ?a a ex:C2 } WHERE "
                          "{ ?a a ex:C0 }"),
            Lines());
  EXPECT_EQ(store
                .AddRule("t",
                         "CONSTRUCT { ?a ex:count ?n } WHERE { SELECT ?a "
                         "(COUNT(*) AS ?n) { ?a ?p ?b } GROUP BY ?a }")
                .size(),
            1u);
}

TEST(Inference, DoubtsWhatOtherRulesHaveConcluded) {
  RuleStore store;
  store.AddRule("a",
                "CONSTRUCT { ?a a ex:C2 } WHERE { ?a ex:p0 ?b "
                "FILTER NOT EXISTS { ?a a ex:C1 } }");
  store.AddRule("b", "CONSTRUCT { ?a a ex:C1 } WHERE { ?a ex:p1 ?b }");
  store.Change("ex:a ex:p0 ex:b . ex:c ex:p0 ex:d ; ex:p1 ex:e .");
  EXPECT_TRUE(store.Infers("ex:a", "rdf:type", "ex:C2"));
  EXPECT_FALSE(store.Infers("ex:c", "rdf:type", "ex:C2"));
}

struct BadRule {
  const char* construct;
  const char* said;
};
const BadRule kBadRules[] = {
    {"CONSTRUCT { ?a ex:p0 ?b } WHERE { ?a ex:p1 ", "1:44: expected"},
    {"SELECT ?a { ?a ex:p0 ?b }", "expected CONSTRUCT"},
    {"CONSTRUCT { ?a ex:p0 ?c } WHERE { ?a ex:p1 ?b }",
     "?c is concluded, but WHERE never binds it"},
    {"CONSTRUCT { ?a ex:p0 ?b } WHERE { ?a ex:p1 ?c } GROUP BY ?a", "?b is"},
    {"CONSTRUCT { } WHERE { ?a ex:p1 ?b }", "a triple to conclude"},
    {"CONSTRUCT { ?a ex:p0 ?b } WHERE { ?a ex:p1 ?b } LIMIT 3", "LIMIT"},
    {"CONSTRUCT { ?a ex:p0 ?b } FROM graph:log WHERE { ?a ex:p1 ?b }", "FROM"},
    {"CONSTRUCT { ?a ex:p0 ?b } WHERE { GRAPH ?g { ?a ex:p1 ?b } }", "GRAPH"},
    {"CONSTRUCT { ?a ex:value ?b } WHERE { ?a ex:p1 ?c BIND(NOW() AS ?b) }",
     "NOW() is not for rules"},
    {"CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p1 ?b FILTER(rand() < 0.5) }",
     "RAND() is not for rules"},
    {"CONSTRUCT { ?a ex:value ?n } WHERE { SELECT ?a (SAMPLE(?b) AS ?n) "
     "{ ?a ex:p0 ?b } GROUP BY ?a }",
     "SAMPLE"},
    {"CONSTRUCT { ?a ex:value ?n } WHERE { SELECT ?a (COUNT(*) AS ?n) "
     "{ SELECT DISTINCT ?a ?b { ?a ex:p0/ex:p1 ?b } } GROUP BY ?a }",
     "COUNT(DISTINCT ?x)"},
    {"CONSTRUCT { ?a ex:p9 ?b } WHERE { ?a ex:p1 ?b }",
     "ex:r: ex:p9 is not a property of the ontology, the nearest is ex:p0"},
    {"CONSTRUCT { ?a a ex:C9 } WHERE { ?a ex:p1 ?b }",
     "ex:C9 is not a class of the ontology"},
    {"CONSTRUCT { ?a ex:p0 ?b } WHERE { ?a ex:p1 ?b FILTER(ex:f(?b)) }",
     "is not known"},
};

TEST(Inference, RefusesWhatIsNoRuleInOneLine) {
  for (const BadRule& bad : kBadRules) {
    const std::string reason = GetRefusal(bad.construct);
    EXPECT_NE(reason.find(bad.said), std::string::npos) << reason;
    EXPECT_EQ(reason.find("ex:r"), 0u) << reason;
    EXPECT_EQ(reason.find('\n'), std::string::npos) << reason;
  }
}

TEST(Inference, RefusesTwoTextsAndARuleThatIsOffButNoRule) {
  RuleStore store;
  EXPECT_EQ(store.Change("ex:r a ex:Rule ; ex:construct 'a' , 'b' .").size(),
            1u);
  EXPECT_EQ(store
                .Change("ex:r a ex:Rule ; ex:construct 'a' ; ex:enabled "
                        "false .")
                .size(),
            1u);
  EXPECT_EQ(store.Change("ex:r a ex:Rule .").size(), 1u);
}

TEST(Inference, RefusesAConclusionThatOnlyShowsWhenItIsMade) {
  RuleStore store;
  EXPECT_EQ(store.AddRule("r",
                          "CONSTRUCT { ?a ?p true } WHERE "
                          "{ ?a ex:p0 ?p }"),
            Lines());
  EXPECT_EQ(
      store.Change("ex:a ex:p0 ex:enabled ."),
      Lines{"ex:r may not conclude ex:enabled: a rule concludes no rules"});
  EXPECT_EQ(store.Change("ex:a ex:p0 ex:hasWindow ."),
            Lines{"ex:r may not conclude ex:hasWindow: files are read before "
                  "rules are run"});
}

TEST(Inference, AFactInPlaceOfAShippedRulesTextCounts) {
  RuleStore store;
  Transaction ship = store.store.Begin();
  for (const Statement& s :
       ParseTurtle(RuleStore::RuleTurtle(
                       "r", "CONSTRUCT { ?a ex:p1 ?b } WHERE { ?a ex:p0 ?b }"),
                   "shipped", Iri(kVocabGraph))) {
    ship.Add(s);
  }
  ASSERT_TRUE(StageInferences(ship, RuleStore::FindForbidden).empty());
  ship.Commit(WorldChange::kYes);
  store.Change("ex:a ex:p0 ex:b .");
  EXPECT_TRUE(store.Infers("ex:a", "ex:p1", "ex:b"));
  EXPECT_EQ(store.Change("ex:r ex:construct 'CONSTRUCT { ?a ex:p2 ?b } WHERE "
                         "{ ?a ex:p0 ?b }' ."),
            Lines());
  EXPECT_FALSE(store.Infers("ex:a", "ex:p1", "ex:b"));
  EXPECT_TRUE(store.Infers("ex:a", "ex:p2", "ex:b"));
}

}  // namespace
}  // namespace kg_core
