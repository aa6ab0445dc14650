// Seeded random small datasets and queries as SPARQL text, for the evaluator of
// brute_force_query.h and for comparison with other engines.

#ifndef KG_CORE_SPARQL_TESTING_RANDOM_QUERY_H_
#define KG_CORE_SPARQL_TESTING_RANDOM_QUERY_H_

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/sparql/testing/brute_force_query.h"

namespace kg_core::brute {

inline std::string ToSparql(const Group& group);

inline std::string ConditionText(const Condition& c) {
  if (c.op == "bound") return "BOUND(" + c.left + ")";
  if (c.op == "not") return "!(" + ConditionText(c.parts[0]) + ")";
  if (c.op == "exists") {
    std::string text = "EXISTS {";
    for (const Triple& t : c.triples) {
      text += " " + t[0] + " " + t[1] + " " + t[2] + " .";
    }
    return text + " }";
  }
  if (c.parts.empty()) return "(" + c.left + " " + c.op + " " + c.right + ")";
  return "(" + ConditionText(c.parts[0]) + " " + c.op + " " +
         ConditionText(c.parts[1]) + ")";
}

inline std::string ValuesText(const Element& e) {
  std::string text = "VALUES (";
  for (const Text& column : e.columns) text += column + " ";
  text += ") {";
  for (const Mapping& row : e.rows) {
    text += " (";
    for (const Text& column : e.columns) {
      text += (row.count(column) != 0 ? row.at(column) : "UNDEF") + " ";
    }
    text += ")";
  }
  return text + " }";
}

inline std::string ElementText(const Element& e) {
  if (e.kind == "optional") return "OPTIONAL " + ToSparql(e.groups[0]);
  if (e.kind == "minus") return "MINUS " + ToSparql(e.groups[0]);
  if (e.kind == "group") return ToSparql(e.groups[0]);
  if (e.kind == "graph") return "GRAPH " + e.graph + ToSparql(e.groups[0]);
  if (e.kind == "bind") return "BIND(" + e.value + " AS " + e.variable + ")";
  if (e.kind == "values") return ValuesText(e);
  if (e.kind == "union") {
    return ToSparql(e.groups[0]) + " UNION " + ToSparql(e.groups[1]);
  }
  if (e.kind == "select") {
    std::string text = "{ SELECT ";
    if (e.distinct) text += "DISTINCT ";
    for (const Text& column : e.columns) text += column + " ";
    return text + ToSparql(e.groups[0]) + " }";
  }
  return e.triple[0] + " " + e.triple[1] + " " + e.triple[2] + " .";
}

inline std::string ToSparql(const Group& group) {
  std::string text = " { ";
  for (const Element& e : group.elements) text += ElementText(e) + " ";
  for (const Condition& c : group.filters) {
    text += "FILTER(" + ConditionText(c) + ") ";
  }
  return text + "}";
}

// Draws datasets and queries; `literals` are the terms drawn besides nodes.
class Dice {
 public:
  explicit Dice(unsigned seed, std::vector<Text> literals = {"0", "1", "2"})
      : random_(seed), literals_(std::move(literals)) {}

  int Below(int n) {
    return static_cast<int>(random_() % static_cast<unsigned>(n));
  }
  Text Node() { return "ex:n" + std::to_string(Below(3)); }
  Text Object() {
    if (Below(3) > 0) return Node();
    return literals_[Below(static_cast<int>(literals_.size()))];
  }
  Text Predicate() { return Below(2) == 0 ? "ex:p" : "ex:q"; }
  Text Variable() { return std::string("?") + "abcd"[Below(4)]; }

  World DrawWorld() {
    World world;
    for (int g = 0; g < 3; ++g) {
      const Text name = "ex:g" + std::to_string(g);
      for (int i = 3 + Below(7); i > 0; --i) {
        const Triple triple{Node(), Predicate(), Object()};
        world.named[name].insert(triple);
        if (g < 2) world.default_graph.insert(triple);
      }
    }
    return world;
  }

  Triple DrawTriple() {
    return {Below(6) == 0 ? Node() : Variable(),
            Below(5) == 0 ? Variable() : Predicate(),
            Below(6) == 0 ? Object() : Variable()};
  }

  Condition DrawCondition(int depth) {
    Condition c;
    const int kind = Below(depth > 0 ? 8 : 4);
    if (kind == 0) {
      c.op = "bound";
      c.left = Variable();
    } else if (kind < 4) {
      c.op = Below(3) == 0 ? "<" : Below(2) == 0 ? "=" : "!=";
      c.left = Variable();
      c.right = Below(2) == 0 ? Variable() : Object();
    } else if (kind == 4) {
      c.op = "exists";
      for (int i = 1 + Below(2); i > 0; --i) c.triples.push_back(DrawTriple());
    } else if (kind == 5) {
      c.op = "not";
      c.parts = {DrawCondition(depth - 1)};
    } else {
      c.op = kind == 6 ? "&&" : "||";
      c.parts = {DrawCondition(depth - 1), DrawCondition(depth - 1)};
    }
    return c;
  }

  Group DrawGroup(int depth) {
    Group group;
    for (int i = Below(8) == 0 ? 0 : 1 + Below(3); i > 0; --i) {
      group.elements.push_back(DrawElement(depth));
    }
    for (int i = Below(6) / 4; i > 0; --i) {
      group.filters.push_back(DrawCondition(2));
    }
    return group;
  }

 private:
  Element DrawElement(int depth) {
    constexpr const char* kKinds[] = {"optional", "optional", "union", "minus",
                                      "graph",    "values",   "bind",  "select",
                                      "group",    "path"};
    Element e;
    e.kind = depth == 0 || Below(3) == 0 ? "triple" : kKinds[Below(10)];
    e.triple = DrawTriple();
    if (e.kind == "path") e.triple[1] = kPaths[Below(8)];
    e.graph = Below(2) == 0 ? Variable() : "ex:g" + std::to_string(Below(4));
    e.distinct = Below(2) == 0;
    e.value = Below(2) == 0 ? Variable() : Object();
    e.variable = "?e" + std::to_string(++bound_);
    if (depth > 0) e.groups = {DrawGroup(depth - 1), DrawGroup(depth - 1)};
    if (e.kind != "values" && e.kind != "select") return e;
    e.columns = {"?a", "?c"};
    for (int i = Below(3); i > 0; --i) {
      Mapping row;
      for (const Text& column : e.columns) {
        if (Below(3) > 0) row[column] = Object();
      }
      e.rows.push_back(row);
    }
    return e;
  }

  std::mt19937 random_;
  const std::vector<Text> literals_;
  int bound_ = 0;
};

}  // namespace kg_core::brute

#endif  // KG_CORE_SPARQL_TESTING_RANDOM_QUERY_H_
