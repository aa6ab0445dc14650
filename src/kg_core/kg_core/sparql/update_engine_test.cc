// Example updates on a small dataset; each test is named after the rule it
// checks.

#include "kg_core/sparql/update_engine.h"

#include <gtest/gtest.h>

#include <iterator>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/isomorphism.h"

namespace kg_core {
namespace {

constexpr char kWorld[] = R"ttl(
  ex:alpha a ex:Agent ; ex:speed 1 . ex:bravo a ex:Agent ; ex:speed 2 .
)ttl";
constexpr char kOther[] = "ex:old ex:speed 9 .";
constexpr char kPlan[] = "http://example.org/mission/graph/plan/1";

using Statements = std::vector<Statement>;

Statements GetContent(const GraphView& view) {
  Statements all;
  view.Match({}, [&](const Quad& q) {
    all.push_back({view.Get(q.subject), view.Get(q.predicate),
                   view.Get(q.object), view.Get(q.graph)});
    return true;
  });
  return all;
}

void AddAll(const std::string& turtle, const char* graph, Transaction* change) {
  for (const Statement& s : ParseTurtle(turtle, "test", Iri(graph))) {
    change->Add(s);
  }
}

// An in-memory store with an open transaction.
class World {
 public:
  World() : store_("") {
    Transaction first = store_.Begin();
    AddAll(kWorld, kFactsGraph, &first);
    AddAll(kOther, kPlan, &first);
    first.Commit(WorldChange::kYes);
    change_.emplace_back(store_.Begin());
  }
  Transaction& change() { return change_[0]; }
  Statements Content() { return GetContent(change().view()); }

  void Update(const std::string& text, const UpdateGraphs& graphs = {},
              const QueryLimits& limits = {}) {
    RunUpdate(text, graphs, limits, &change());
  }
  std::string GetError(const std::string& text, const UpdateGraphs& graphs = {},
                       const QueryLimits& limits = {}) {
    try {
      Update(text, graphs, limits);
    } catch (const kg_base::InputError& error) {
      return error.what();
    }
    return "no error";
  }

 private:
  Store store_;
  std::vector<Transaction> change_;
};

// Checks the content of the facts and of the plan graph after `update`.
::testing::AssertionResult Leaves(const std::string& update,
                                  const std::string& facts,
                                  const std::string& plan) {
  World world;
  world.Update(update);
  Statements want = ParseTurtle(facts, "facts", Iri(kFactsGraph));
  for (Statement& s : ParseTurtle(plan, "plan", Iri(kPlan))) {
    want.push_back(std::move(s));
  }
  if (IsIsomorphic(world.Content(), want)) {
    return ::testing::AssertionSuccess();
  }
  return ::testing::AssertionFailure()
         << WriteTurtle(world.change().view(), kFactsGraph)
         << WriteTurtle(world.change().view(), kPlan);
}

const std::string kFacts = kWorld;

TEST(UpdateEngine, InsertsAndDeletesData) {
  EXPECT_TRUE(Leaves("INSERT DATA { ex:a ex:b 1, 2 . [] ex:c (1) }",
                     kFacts + "ex:a ex:b 1, 2 . [] ex:c (1) .", kOther));
  EXPECT_TRUE(Leaves("INSERT DATA { GRAPH <" + std::string(kPlan) +
                         "> { ex:a ex:b 1 } ex:c ex:d 2 }",
                     kFacts + "ex:c ex:d 2 .",
                     std::string(kOther) + "ex:a ex:b 1 ."));
  EXPECT_TRUE(Leaves("DELETE DATA { ex:alpha ex:speed 1 . ex:no ex:no 1 }",
                     "ex:alpha a ex:Agent . ex:bravo a ex:Agent ; ex:speed 2 .",
                     kOther));
  EXPECT_TRUE(Leaves("", kFacts, kOther));
  EXPECT_TRUE(
      Leaves("PREFIX a: <http://a/> INSERT DATA { a:a a:b a:c } ; "
             "PREFIX a: <http://b/> DELETE DATA { a:a a:b a:c } ;",
             kFacts + "<http://a/a> <http://a/b> <http://a/c> .", kOther));
}

// Refused, or without effect where the term is computed.
TEST(UpdateEngine, InsertsNoTermThatIsNoRdf) {
  const char* kUpdates[] = {
      "INSERT DATA { <a> ex:p 1 }",
      "INSERT DATA { ex:a <p> 1 }",
      "INSERT DATA { ex:a ex:p <o> }",
      "INSERT DATA { ex:a ex:p <> }",
      "INSERT DATA { ex:a ex:p 'x'^^<dt> }",
      "INSERT DATA { GRAPH <g> { ex:a ex:p 1 } }",
      "PREFIX z: <zz#> INSERT DATA { z:a ex:p 1 }",
      "BASE <b> INSERT DATA { <a> ex:p 1 }",
      "INSERT DATA { ex:a ex:p <http://h/a\\u0020b> }",
      "INSERT DATA { ex:a ex:p <http://h/\\U0000003E> }",
      "INSERT DATA { ex:a ex:p 'x'^^<http://h/\\u007C> }",
      "INSERT DATA { ex:a ex:p '\\uD800' }",
      "INSERT DATA { ex:a ex:p <http://h/\\uDFFF> }",
      "INSERT DATA { ex:a ex:p 'x'@en- }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(IRI('x') AS ?x) }",
      "INSERT { ?x ex:p 1 } WHERE { BIND(URI('') AS ?x) }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(IRI('http://h/\\u0001') AS ?x) }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(STRLANG('x', '') AS ?x) }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(STRLANG('x', 'e n') AS ?x) }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(STRLANG('x', 'en-') AS ?x) }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(STRDT('x', IRI('d')) AS ?x) }",
      "INSERT { ex:a ex:p ?x } WHERE { BIND(STRDT('x', rdf:langString) AS ?x) "
      "}",
  };
  for (const char* update : kUpdates) {
    Store store("");
    Transaction change = store.Begin();
    try {
      RunUpdate(update, {}, {}, &change);
    } catch (const kg_base::InputError&) {
    }
    EXPECT_TRUE(change.empty()) << update;
  }
}

TEST(UpdateEngine, ModifiesWhatMatchesAndSeesNotItsOwnChanges) {
  EXPECT_TRUE(Leaves(
      "DELETE { ?a ex:speed ?v } INSERT { ?a ex:speed ?w } "
      "WHERE { ?a ex:speed ?v BIND(?v + 1 AS ?w) }",
      "ex:alpha a ex:Agent ; ex:speed 2 . ex:bravo a ex:Agent ; ex:speed 3 .",
      kOther));
  // A quad that is both removed and added stays.
  EXPECT_TRUE(
      Leaves("DELETE { ?s ?p ?o } INSERT { ?s ?p ?o } "
             "WHERE { ?s ?p ?o }",
             kFacts, kOther));
  EXPECT_TRUE(Leaves("DELETE WHERE { ?a a ex:Agent ; ?p ?o }", "", kOther));
  EXPECT_TRUE(
      Leaves("DELETE WHERE { ?a ex:speed 1 . GRAPH ?g { ?o ex:speed 9 "
             "} }",
             "ex:alpha a ex:Agent . ex:bravo a ex:Agent ; ex:speed 2 .", ""));
}

TEST(UpdateEngine, LeavesOutWhatWouldBeNoTriple) {
  EXPECT_TRUE(
      Leaves("INSERT { ?v ex:of ?a . ?a ?v 1 . ?a ex:is ?none . "
             "GRAPH ?v { ex:a ex:b 1 } } WHERE { ?a ex:speed ?v }",
             kFacts, kOther));
}

TEST(UpdateEngine, GivesEachSolutionAndEachOperationFreshBlankNodes) {
  EXPECT_TRUE(
      Leaves("INSERT { _:x ex:of ?a } WHERE { ?a a ex:Agent } ; "
             "INSERT { _:x ex:of ex:alpha } WHERE {}",
             kFacts + "[] ex:of ex:alpha . [] ex:of ex:bravo . "
                      "[] ex:of ex:alpha .",
             kOther));
  // BNODE() too: labels are not shared between requests.
  World world;
  for (int i = 0; i < 3; ++i) {
    world.Update("INSERT { ?b ex:is 1 } WHERE { BIND(BNODE() AS ?b) }");
  }
  EXPECT_TRUE(IsIsomorphic(world.change().added(),
                           ParseTurtle("[] ex:is 1 . [] ex:is 1 . [] ex:is 1 .",
                                       "test", Iri(kFactsGraph))));
}

TEST(UpdateEngine, ReadsAndWritesTheGraphsOfWithAndUsing) {
  const std::string plan = "<" + std::string(kPlan) + "> ";
  EXPECT_TRUE(Leaves("WITH " + plan +
                         "DELETE { ?a ex:speed ?v } INSERT { ?a ex:was ?v } "
                         "WHERE { ?a ex:speed ?v }",
                     kFacts, "ex:old ex:was 9 ."));
  EXPECT_TRUE(Leaves("WITH " + plan + "INSERT { ?a ex:fast true } USING " +
                         "graph:facts WHERE { ?a ex:speed 2 }",
                     kFacts, std::string(kOther) + "ex:bravo ex:fast true ."));
  EXPECT_TRUE(Leaves("INSERT { ?a ex:in ?g } USING NAMED " + plan +
                         "WHERE { GRAPH ?g { ?a ex:speed ?v } }",
                     kFacts + "ex:old ex:in <" + kPlan + "> .", kOther));
}

TEST(UpdateEngine, ClearsAndMovesWholeGraphs) {
  const std::string plan = "GRAPH <" + std::string(kPlan) + "> ";
  EXPECT_TRUE(Leaves("CLEAR " + plan, kFacts, ""));
  EXPECT_TRUE(Leaves("DROP DEFAULT", "", kOther));
  EXPECT_TRUE(Leaves("CLEAR NAMED", kFacts, ""));
  EXPECT_TRUE(Leaves("DROP ALL", "", ""));
  EXPECT_TRUE(Leaves("DROP GRAPH ex:nothing", kFacts, kOther));
  EXPECT_TRUE(Leaves("CREATE GRAPH ex:new", kFacts, kOther));
  EXPECT_TRUE(Leaves("COPY " + plan + "TO DEFAULT", kOther, kOther));
  EXPECT_TRUE(Leaves("MOVE DEFAULT TO " + plan, "", kFacts));
  EXPECT_TRUE(Leaves("ADD DEFAULT TO " + plan, kFacts, kFacts + kOther));
  EXPECT_TRUE(Leaves("MOVE DEFAULT TO DEFAULT ; COPY " + plan + "TO " + plan,
                     kFacts, kOther));
  EXPECT_TRUE(
      Leaves("COPY SILENT ex:nothing TO DEFAULT ; CREATE SILENT " + plan,
             kFacts, kOther));
  EXPECT_TRUE(
      Leaves("LOAD SILENT <file:///etc/passwd> ; "
             "LOAD SILENT <http://x/> INTO GRAPH ex:g",
             kFacts, kOther));
}

TEST(UpdateEngine, SaysWhereTheMistakeIs) {
  const std::pair<const char*, const char*> kCases[] = {
      {"SELECT * { ?s ?p ?o }",
       "1:1: expected an update such as INSERT, DELETE, CLEAR or COPY, got "
       "SELECT"},
      {"LOAD <file:///etc/passwd>",
       "1:1: LOAD is not available: an update reads this store only"},
      {"CLEAR ALL ;\n LOAD <http://x/> INTO GRAPH ex:g",
       "2:2: LOAD is not available: an update reads this store only"},
      {"INSERT DATA { ?a ex:b 1 }", "1:15: INSERT DATA may not have variables"},
      {"DELETE DATA { _:a ex:b 1 }",
       "1:15: DELETE DATA may not have blank nodes"},
      {"DELETE { [] ex:b ?c } WHERE { ?a ex:b ?c }",
       "1:11: DELETE may not have blank nodes"},
      {"DELETE WHERE { ?a ex:b (1) }",
       "1:24: DELETE WHERE may not have blank nodes"},
      {"INSERT DATA { _:a ex:b 1 } ; INSERT DATA { _:a ex:b 1 }",
       "1:48: blank node _:a is used in two different graph patterns"},
      {"INSERT { ?a ex:b 1 } { ?a ex:c 2 }", "1:22: expected WHERE, got {"},
      {"INSERT { ?a ex:b 1 } WHERE { SERVICE <http://x/> {} }",
       "1:30: SERVICE is not available: a query reads this store only"},
      {"DELETE { ?a ex:b 1 } WHERE { FILTER(ex:f(1)) }",
       "1:37: function <http://example.org/mission/f> is not known"},
      {"CREATE DEFAULT", "1:8: expected GRAPH, got DEFAULT"},
      {"COPY ex:no TO DEFAULT", "1:1: the store has no graph ex:no"},
      {"CREATE GRAPH graph:facts",
       "1:1: CREATE: there is a graph graph:facts already"},
      {"INSERT DATA { ex:a ex:b 1 } INSERT DATA { ex:a ex:b 1 }",
       "1:29: expected ';' or the end of the update, got INSERT"},
  };
  for (const auto& [update, error] : kCases) {
    World world;
    EXPECT_EQ(world.GetError(update), error) << update;
    EXPECT_TRUE(world.change().empty()) << update;
  }
}

TEST(UpdateEngine, ChangesOnlyWhatMayBeChanged) {
  UpdateGraphs graphs;
  graphs.writable = {{kFactsGraph}};
  World world;
  const std::string refusal =
      " graph <" + std::string(kPlan) + "> may not be changed by an update";
  const std::string plan = "<" + std::string(kPlan) + ">";
  EXPECT_EQ(world.GetError("CLEAR ALL", graphs), "1:1:" + refusal);
  EXPECT_EQ(world.GetError("MOVE " + plan + " TO DEFAULT", graphs),
            "1:1:" + refusal);
  EXPECT_EQ(world.GetError("INSERT DATA { ex:a ex:b 1 } ; WITH " + plan +
                               " DELETE { ?s ?p ?o } WHERE { ?s ?p ?o }",
                           graphs),
            "1:31:" + refusal);
  EXPECT_TRUE(world.change().empty());
  world.Update("COPY " + plan + " TO DEFAULT", graphs);
  EXPECT_EQ(world.change().added().size(), 1u);
}

TEST(UpdateEngine, EndsWithinItsLimits) {
  World world;
  QueryLimits limits;
  limits.rows = 3;
  EXPECT_EQ(
      world.GetError("DELETE { ?s ?p ?o } WHERE { ?s ?p ?o }", {}, limits),
      "the update changes more quads than the limit of 3");
  EXPECT_EQ(world.GetError("ADD DEFAULT TO ex:g", {}, limits),
            "the update changes more quads than the limit of 3");
  limits = {};
  limits.seconds = 0.05;
  EXPECT_EQ(world.GetError(
                "INSERT { ?a ?b ?c } WHERE { ?a ?b ?c . ?d ?e ?f . ?g ?h ?i "
                ". ?j ?k ?l . ?m ?n ?o . ?p ?q ?r . ?s ?t ?u . ?v ?w ?x . "
                "?a1 ?a2 ?a3 . ?b1 ?b2 ?b3 FILTER(?a > ?b3) }",
                {}, limits),
            "the query took longer than the limit of 0.05 s");
  EXPECT_EQ(world.GetError(std::string(65537, ' ')),
            "the update is longer than the limit of 65536 bytes");
  EXPECT_TRUE(world.change().empty());
}

// Random operations on few terms, so that they overlap; graph "" is the default
// graph.
struct RandomUpdate {
  std::string text;
  using Triples = std::set<std::string>;
  Triples facts, plan;  // Expected content by the model.

  void Add(std::mt19937* random) {
    const auto number = [random] { return std::to_string((*random)() % 3); };
    const std::string graph = "<" + std::string(kPlan) + ">";
    const std::string triple = "ex:s" + number() + " ex:p ex:o" + number();
    const std::string object = "ex:o" + number();
    switch ((*random)() % 6) {
      case 0:
        text += "INSERT DATA { " + triple + " }";
        facts.insert(triple);
        break;
      case 1:
        text += "DELETE DATA { GRAPH " + graph + " { " + triple + " } }";
        plan.erase(triple);
        break;
      case 2:
        text += "DELETE WHERE { ?s ex:p " + object + " }";
        Erase(object);
        break;
      case 3:
        text +=
            "INSERT { GRAPH " + graph + " { ?s ?p ?o } } WHERE { ?s ?p ?o }";
        plan.insert(facts.begin(), facts.end());
        break;
      case 4:
        text += "MOVE SILENT " + graph + " TO DEFAULT";
        if (plan.empty()) break;
        facts = std::move(plan);
        plan.clear();
        break;
      default:
        text += "COPY DEFAULT TO " + graph;
        plan = facts;
    }
    text += " ;\n";
  }

 private:
  void Erase(const std::string& object) {
    for (auto it = facts.begin(); it != facts.end();) {
      it = it->substr(it->size() - object.size()) == object ? facts.erase(it)
                                                            : std::next(it);
    }
  }
};

std::set<std::string> CollectTriples(const GraphView& view, const char* graph) {
  std::set<std::string> triples;
  for (const Statement& s : GetContent(view)) {
    if (s.graph.text != graph) continue;
    triples.insert(ToTurtle(s.subject) + " " + ToTurtle(s.predicate) + " " +
                   ToTurtle(s.object));
  }
  return triples;
}

TEST(UpdateEngine, AgreesWithSetsAndTakesBackWhatFails) {
  std::mt19937 random(5);
  for (int round = 0; round < 300; ++round) {
    World world;
    world.Update("DROP ALL");
    RandomUpdate update;
    for (int i = 0; i < 12; ++i) update.Add(&random);
    world.Update(update.text);
    EXPECT_EQ(CollectTriples(world.change().view(), kFactsGraph), update.facts)
        << update.text;
    EXPECT_EQ(CollectTriples(world.change().view(), kPlan), update.plan)
        << update.text;
    // The same update with a failing last operation appended.
    RandomUpdate more = update;
    more.text.clear();
    for (int i = 0; i < 6; ++i) more.Add(&random);
    EXPECT_EQ(world.GetError(more.text + "MOVE ex:none TO DEFAULT"),
              "7:1: the store has no graph ex:none");
    EXPECT_EQ(CollectTriples(world.change().view(), kFactsGraph), update.facts);
    EXPECT_EQ(CollectTriples(world.change().view(), kPlan), update.plan);
  }
}

TEST(BlankNodeGraphs, AreReadAndChangedAsOthers) {
  const Term graph = Blank("g");
  const auto fill = [&graph](World* world) {
    world->change().Add(
        {graph, Iri("http://h/made"), Literal("x"), Iri(kFactsGraph)});
    world->change().Add({Iri("http://h/s"), Iri("http://h/p"), graph, graph});
  };
  World world;
  fill(&world);
  const Statements before = world.Content();
  world.Update(
      "INSERT { GRAPH ?g { ?s <http://h/q> ?g } } WHERE { ?g <http://h/made> "
      "\"x\" GRAPH ?g { ?s ?p ?g } }");
  EXPECT_EQ(world.Content().size(), before.size() + 1);
  world.Update(
      "DELETE { GRAPH ?g { ?s ?p ?o } } WHERE { GRAPH ?g { ?s "
      "<http://h/q> ?x . ?s ?p ?o } }");
  EXPECT_EQ(world.Content().size(), before.size() - 1);
  World other;
  fill(&other);
  other.Update("CLEAR NAMED");
  for (const Statement& s : other.Content()) EXPECT_FALSE(s.graph.is_blank());
  World closed;
  fill(&closed);
  UpdateGraphs graphs;
  graphs.writable = {kFactsGraph};
  EXPECT_EQ(closed.GetError("DROP ALL", graphs),
            "1:1: graph _:g may not be changed by an update");
}

}  // namespace
}  // namespace kg_core
