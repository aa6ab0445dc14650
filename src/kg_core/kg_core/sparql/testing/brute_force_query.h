// Queries as data and a brute force evaluator for tests: the definitions of
// https://www.w3.org/TR/sparql11-query/#sparqlAlgebra implemented literally, on
// maps from names to terms, sharing no code with the engine.

#ifndef KG_CORE_SPARQL_TESTING_BRUTE_FORCE_QUERY_H_
#define KG_CORE_SPARQL_TESTING_BRUTE_FORCE_QUERY_H_

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace kg_core::brute {

// "?name" is a variable, anything else a term as written ("ex:n0", "2").
using Text = std::string;
using Mapping = std::map<Text, Text>;  // From variable to term.
using Bag = std::vector<Mapping>;
using Triple = std::vector<Text>;  // Subject, predicate, object.
using Triples = std::set<Triple>;
using Pairs = std::vector<std::pair<Text, Text>>;

struct Group;

// A condition: "left op right", op one of = != <, "bound", "exists"; or and,
// or, not of others.
struct Condition {
  Text op;
  Text left;
  Text right;
  std::vector<Condition> parts;
  std::vector<Triple> triples;  // exists
};

struct Element {
  // "triple", "path", "optional", "union", "minus", "graph", "values", "bind",
  // "select", "group"
  Text kind;
  Triple triple;  // The predicate of a path is one of kPaths below.
  std::vector<Group> groups;
  Text graph;
  std::vector<Mapping> rows;
  Text variable;
  Text value;
  std::vector<Text> columns;
  bool distinct = false;
};

struct Group {
  std::vector<Element> elements;
  std::vector<Condition> filters;
};

struct World {
  Triples default_graph;
  std::map<Text, Triples> named;
};

inline constexpr const char* kPaths[] = {
    "ex:p*",        "ex:p+", "ex:q?",       "(ex:p|^ex:q)*",
    "(ex:p/ex:q)+", "!ex:p", "(ex:p|ex:q)", "!(ex:q|^ex:p)"};

Bag Evaluate(const Group& group, const World& world, const Triples& graph);

}  // namespace kg_core::brute

#endif  // KG_CORE_SPARQL_TESTING_BRUTE_FORCE_QUERY_H_
