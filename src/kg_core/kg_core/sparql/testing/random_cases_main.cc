// Prints random test cases with this engine's results, one JSON object per
// line, for comparison with another engine (scripts/second_opinion.py):
//
//     random_cases COUNT [FIRST_SEED]
//
//   {"seed": 1, "query": "PREFIX ...", "default": "<...> ... .\n",
//    "named": {"http://...g0": "..."}, "variables": ["a"],
//    "rows": [["<http://...n0>"], [null]]}
//
// Graphs are N-Triples, terms of rows N-Triples terms; triples of CONSTRUCT are
// rows of subject, predicate and object. Cases of more than 2,000 rows are left
// out.

#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/results.h"
#include "kg_core/sparql/testing/random_query.h"
#include "kg_core/sparql/testing/vector_view.h"

namespace kg_core::brute {
namespace {

constexpr std::size_t kMaxRows = 2000;
constexpr char kPrologue[] =
    "PREFIX ex: <http://example.org/mission/>\n"
    "PREFIX xsd: <http://www.w3.org/2001/XMLSchema#>\n";

// Literals of the types that expressions distinguish.
const std::vector<Text>& Literals() {
  static const std::vector<Text> literals = {
      "0",
      "1",
      "2",
      "-3",
      "1.5",
      "2.25",
      "\"1.5\"^^xsd:double",
      "\"a\"",
      "\"Ab\"",
      "\"a\"@en",
      "\"Ab\"@de",
      "\"2\"",
      "true",
      "false",
      "\"é\"",
      "\"2020-02-29T12:00:00\"^^xsd:dateTime",
      "\"2021-01-01T00:00:00\"^^xsd:dateTime"};
  return literals;
}

const std::vector<Text>& Expressions() {
  static const std::vector<Text> expressions = {
      "STR(?a)",
      "LANG(?b)",
      "DATATYPE(?b)",
      "STRLEN(STR(?b))",
      "UCASE(STR(?b))",
      "isIRI(?a)",
      "isLiteral(?b)",
      "isNumeric(?b)",
      "ABS(?b)",
      "CEIL(?b)",
      "FLOOR(?b)",
      "CONCAT(STR(?a), \"-\")",
      "SUBSTR(STR(?b), 2)",
      "CONTAINS(STR(?a), \"n1\")",
      "STRBEFORE(STR(?a), \"n\")",
      "STRAFTER(STR(?a), \"n\")",
      "REPLACE(STR(?b), \"[ab]\", \"x\")",
      "REGEX(STR(?a), \"n[01]$\")",
      "COALESCE(?d, ?a, 7)",
      "IF(BOUND(?a), ?b, ?c)",
      "?b + 1",
      "IF(DATATYPE(?b) = xsd:double, ?b, ?b + 2.5)",
      "?b - 1.5",
      "YEAR(?b)",
      "MONTH(?d)",
      "sameTerm(?a, ?b)",
      "?a = ?b",
      "isNumeric(?b) && ?b < 2",
      "?b IN (1, \"a\")",
      "?b NOT IN (1, ex:n0)",
      "STRDT(\"1\", xsd:integer) + 1",
      "STRSTARTS(STR(?a), STR(?a))",
      "LANGMATCHES(LANG(?b), \"*\")"};
  return expressions;
}

// A group whose ?a and ?b are bound, and up to two of the elements below. Left
// out are cases where rdflib 6.1 deviates from the recommendation: deeper
// nesting, literals as subjects in templates, paths from literals, comparison
// of terms of different kinds, subqueries that share a grouped variable, joins
// of VALUES with OPTIONAL, bags of paths that may have no length, canonical
// lexical forms. Neither does Oxigraph 0.5 multiply 0 by a decimal.
// brute_force_query.h covers the first, the W3C's tests the others.
class PlainGroup {
 public:
  explicit PlainGroup(Dice* dice) : dice_(*dice) {}

  Text Draw() {
    Text text = "{ ?a " + dice_.Predicate() + " ?b . ";
    const int extra = dice_.Below(3);
    for (int i = 0; i < extra; ++i) text += DrawElement();
    if (dice_.Below(3) == 0) text += "FILTER(" + Condition() + ") ";
    return text + "}";
  }

 private:
  Text Triple(const Text& subject, const Text& object) {
    return subject + " " + dice_.Predicate() + " " + object + " . ";
  }

  Text Condition() {
    const std::vector<Text> conditions = {
        "?a != ?b",
        "?b = " + dice_.Object(),
        "isNumeric(?b) && ?b < 2",
        "isIRI(?b) || isNumeric(?b) && ?b > 1",
        "!isIRI(?b) && ?b != " + dice_.Object(),
        "EXISTS { " + Triple("?b", "?x") + "}",
        "NOT EXISTS { " + Triple("?x", "?a") + "}"};
    return PickOne(conditions);
  }

  Text DrawElement() {
    const std::vector<Text> paths = {"ex:p+", "!ex:p", "(ex:p/ex:q)+", "^ex:q",
                                     "(ex:p|^ex:q)+"};
    const std::vector<Text> stars = {"ex:p*", "ex:q?", "(ex:p|^ex:q)*"};
    const std::vector<Text> elements = {
        Triple("?b", "?c"),
        Triple("?c", "?a"),
        "?a ?y ?c . ",
        "OPTIONAL { " + Triple("?a", "?d") + "} ",
        "OPTIONAL { " + Triple("?b", "?d") + "FILTER(?d != ?a) } ",
        "{ " + Triple("?a", "?c") + "} UNION { " + Triple("?c", "?b") + "} ",
        "MINUS { " + Triple("?a", dice_.Object()) + "} ",
        "MINUS { " + Triple("?x", "?a") + "} ",
        "VALUES ?a { ex:n0 ex:n1 } ",
        "VALUES (?a ?w) { (ex:n0 1) (ex:n1 2) } ",
        "?a " + PickOne(paths) + " ?e" + std::to_string(++drawn_) + " . ",
        "?f" + std::to_string(++drawn_) + " " + PickOne(paths) + " ex:n1 . ",
        "{ SELECT DISTINCT ?a ?d { " + Triple("?a", "?x") + "?a " +
            PickOne(stars) + " ?d } } ",
        "GRAPH ?g { " + Triple("?a", "?c") + "} ",
        "GRAPH ex:g2 { " + Triple("?c", "?a") + "} ",
        "{ SELECT ?z (COUNT(?x) AS ?k) { " + Triple("?z", "?x") +
            "} GROUP BY ?z } ",
        "{ SELECT DISTINCT ?a { " + Triple("?a", "?x") + "} } "};
    return PickOne(elements);
  }

  Text PickOne(const std::vector<Text>& texts) {
    return texts[dice_.Below(static_cast<int>(texts.size()))];
  }

  Dice& dice_;
  int drawn_ = 0;
};

Text DrawQuery(Dice* dice) {
  const Text group = PlainGroup(dice).Draw();
  switch (dice->Below(5)) {
    case 0:
      return "SELECT ?a (COUNT(*) AS ?n) (COUNT(DISTINCT ?b) AS ?m) "
             "(SUM(IF(isNumeric(?b), ?b, 0)) AS ?s) WHERE " +
             group + " GROUP BY ?a HAVING(COUNT(*) > 1)";
    case 1:
      return "CONSTRUCT { ?a ex:r ?b , ?c . ex:n0 ex:s ?b } WHERE " + group;
    case 2: {
      const auto& all = Expressions();
      const Text& drawn = all[dice->Below(static_cast<int>(all.size()))];
      return "SELECT * WHERE { " + group + " BIND(" + drawn + " AS ?v) }";
    }
    case 3:
      return "SELECT DISTINCT ?a ?c WHERE " + group;
    default:
      return "SELECT * WHERE " + group;
  }
}

void AddGraph(const Triples& triples, const Term& graph, VectorView* view,
              std::string* text) {
  for (const Triple& t : triples) {
    const Term subject = ParseTurtleTerm(t[0]);
    const Term predicate = ParseTurtleTerm(t[1]);
    const Term object = ParseTurtleTerm(t[2]);
    if (view != nullptr) view->Add(subject, predicate, object, graph);
    *text += ToNTriples(subject) + " " + ToNTriples(predicate) + " " +
             ToNTriples(object) + " .\n";
  }
}

nlohmann::json CollectRows(const QueryResult& result) {
  nlohmann::json rows = nlohmann::json::array();
  for (const auto& row : AsRows(result).rows) {
    nlohmann::json cells = nlohmann::json::array();
    for (const std::optional<Term>& cell : row) {
      cells.push_back(cell ? nlohmann::json(ToNTriples(*cell)) : nullptr);
    }
    rows.push_back(std::move(cells));
  }
  return rows;
}

void PrintCase(unsigned seed) {
  Dice dice(seed, Literals());
  const World world = dice.DrawWorld();
  const Text query = kPrologue + DrawQuery(&dice);
  nlohmann::json out = {{"seed", seed}, {"query", query}};
  VectorView view;
  std::string default_graph;
  AddGraph(world.default_graph, {}, nullptr, &default_graph);
  out["default"] = default_graph;
  for (const auto& [name, triples] : world.named) {
    const Term graph = ParseTurtleTerm(name);
    std::string text;
    AddGraph(triples, graph, &view, &text);
    out["named"][graph.text] = text;
  }
  const Dataset dataset{{std::string(kEx) + "g0", std::string(kEx) + "g1"},
                        std::nullopt};
  const QueryResult result = RunQuery(view, query, dataset, {});
  if (AsRows(result).rows.size() > kMaxRows) return;
  out["variables"] = AsRows(result).variables;
  out["rows"] = CollectRows(result);
  std::printf("%s\n", out.dump().c_str());
}

}  // namespace
}  // namespace kg_core::brute

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    std::fprintf(stderr, "usage: random_cases COUNT [FIRST_SEED]\n");
    return 2;
  }
  const auto count = static_cast<unsigned>(std::atol(argv[1]));
  const unsigned first =
      argc > 2 ? static_cast<unsigned>(std::atol(argv[2])) : 1;
  for (unsigned seed = first; seed < first + count; ++seed) {
    kg_core::brute::PrintCase(seed);
  }
}
