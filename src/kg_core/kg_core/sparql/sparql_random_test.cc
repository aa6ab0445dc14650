// Compares the engine with a direct implementation of the algebra on thousands
// of small random datasets and queries; see brute_force_query.h.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/turtle.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/testing/brute_force_query.h"
#include "kg_core/sparql/testing/random_query.h"
#include "kg_core/sparql/testing/vector_view.h"

namespace kg_core {
namespace brute {
namespace {

bool IsVariable(const Text& text) { return text[0] == '?'; }

bool Compatible(const Mapping& a, const Mapping& b) {
  return std::all_of(a.begin(), a.end(), [&b](const auto& binding) {
    const auto other = b.find(binding.first);
    return other == b.end() || other->second == binding.second;
  });
}

bool Shares(const Mapping& a, const Mapping& b) {
  return std::any_of(a.begin(), a.end(), [&b](const auto& binding) {
    return b.count(binding.first) != 0;
  });
}

Mapping Merged(Mapping a, const Mapping& b) {
  a.insert(b.begin(), b.end());
  return a;
}

Bag Join(const Bag& left, const Bag& right) {
  Bag both;
  for (const Mapping& a : left) {
    for (const Mapping& b : right) {
      if (Compatible(a, b)) both.push_back(Merged(a, b));
    }
  }
  return both;
}

// The mapping that turns `pattern` into `triple`, if there is one.
std::optional<Mapping> Fit(const Triple& pattern, const Triple& triple) {
  Mapping mapping;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const Text wanted =
        IsVariable(pattern[i])
            ? mapping.emplace(pattern[i], triple[i]).first->second
            : pattern[i];
    if (wanted != triple[i]) return std::nullopt;
  }
  return mapping;
}

Bag MatchTriple(const Triple& pattern, const Triples& graph) {
  Bag bag;
  for (const Triple& triple : graph) {
    const std::optional<Mapping> mapping = Fit(pattern, triple);
    if (mapping) bag.push_back(*mapping);
  }
  return bag;
}

Pairs Links(const Triples& graph, const Text& predicate, bool same) {
  Pairs pairs;
  for (const Triple& t : graph) {
    if ((t[1] == predicate) == same) pairs.emplace_back(t[0], t[2]);
  }
  return pairs;
}

Pairs Inverted(Pairs pairs) {
  for (auto& pair : pairs) std::swap(pair.first, pair.second);
  return pairs;
}

Pairs Both(Pairs a, const Pairs& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

Pairs Chained(const Pairs& a, const Pairs& b) {
  Pairs pairs;
  for (const auto& x : a) {
    for (const auto& y : b) {
      if (x.second == y.first) pairs.emplace_back(x.first, y.second);
    }
  }
  return pairs;
}

Pairs Unique(Pairs pairs) {
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

// Transitive closure, by composing pairs until no new ones appear.
Pairs Closure(const Pairs& step) {
  Pairs all = Unique(step);
  while (true) {
    Pairs more = Unique(Both(all, Chained(all, step)));
    if (more.size() == all.size()) return all;
    all = std::move(more);
  }
}

Pairs Itself(const std::set<Text>& nodes) {
  Pairs pairs;
  for (const Text& node : nodes) pairs.emplace_back(node, node);
  return pairs;
}

Pairs PathPairs(const Text& path, const Triples& graph,
                const std::set<Text>& nodes) {
  const Pairs p = Links(graph, "ex:p", true);
  const Pairs q = Links(graph, "ex:q", true);
  if (path == "ex:p*") return Unique(Both(Itself(nodes), Closure(p)));
  if (path == "ex:p+") return Closure(p);
  if (path == "ex:q?") return Unique(Both(Itself(nodes), q));
  if (path == "(ex:p|^ex:q)*") {
    return Unique(Both(Itself(nodes), Closure(Both(p, Inverted(q)))));
  }
  if (path == "(ex:p/ex:q)+") return Closure(Chained(p, q));
  if (path == "!ex:p") return Links(graph, "ex:p", false);
  if (path == "(ex:p|ex:q)") return Both(p, q);
  return Both(Links(graph, "ex:q", false),
              Inverted(Links(graph, "ex:p", false)));  // !(ex:q|^ex:p)
}

Bag MatchPath(const Triple& pattern, const Triples& graph) {
  std::set<Text> nodes;
  for (const Triple& t : graph) nodes.insert({t[0], t[2]});
  for (const Text& end : {pattern[0], pattern[2]}) {
    if (!IsVariable(end)) nodes.insert(end);
  }
  Bag bag;
  for (const auto& pair : PathPairs(pattern[1], graph, nodes)) {
    const std::optional<Mapping> mapping =
        Fit({pattern[0], pattern[2]}, {pair.first, pair.second});
    if (mapping) bag.push_back(*mapping);
  }
  return bag;
}

using Truth = std::optional<bool>;  // nullopt: error.

std::optional<Text> GetValue(const Text& text, const Mapping& mapping) {
  if (!IsVariable(text)) return text;
  const auto found = mapping.find(text);
  if (found == mapping.end()) return std::nullopt;
  return found->second;
}

bool IsNumber(const Text& text) { return text[0] >= '0' && text[0] <= '9'; }

Truth Compare(const Text& op, const Text& a, const Text& b) {
  if (op == "=") return a == b;
  if (op == "!=") return a != b;
  if (!IsNumber(a) || !IsNumber(b)) return std::nullopt;
  return std::stoi(a) < std::stoi(b);
}

Truth Holds(const Condition& c, const Mapping& mapping, const Triples& graph) {
  if (c.op == "bound") return mapping.count(c.left) != 0;
  if (c.op == "not") {
    const Truth truth = Holds(c.parts[0], mapping, graph);
    return truth ? Truth(!*truth) : truth;
  }
  if (c.op == "exists") {
    Bag bag{mapping};
    for (const Triple& t : c.triples) bag = Join(bag, MatchTriple(t, graph));
    return !bag.empty();
  }
  if (c.op == "&&" || c.op == "||") {
    const bool decisive = c.op == "||";
    const Truth a = Holds(c.parts[0], mapping, graph);
    const Truth b = Holds(c.parts[1], mapping, graph);
    if ((a && *a == decisive) || (b && *b == decisive)) return decisive;
    if (!a || !b) return std::nullopt;
    return !decisive;
  }
  const std::optional<Text> left = GetValue(c.left, mapping);
  const std::optional<Text> right = GetValue(c.right, mapping);
  if (!left || !right) return std::nullopt;
  return Compare(c.op, *left, *right);
}

bool HoldAll(const std::vector<Condition>& filters, const Mapping& mapping,
             const Triples& graph) {
  return std::all_of(filters.begin(), filters.end(), [&](const Condition& c) {
    return Holds(c, mapping, graph).value_or(false);
  });
}

Bag EvaluateUnfiltered(const Group& group, const World& world,
                       const Triples& graph);

Bag LeftJoin(const Bag& left, const Group& group, const World& world,
             const Triples& graph) {
  Bag result;
  const Bag right = EvaluateUnfiltered(group, world, graph);
  for (const Mapping& a : left) {
    bool extended = false;
    for (const Mapping& b : right) {
      const Mapping both = Merged(a, b);
      if (!Compatible(a, b) || !HoldAll(group.filters, both, graph)) continue;
      extended = true;
      result.push_back(both);
    }
    if (!extended) result.push_back(a);
  }
  return result;
}

Bag Minus(const Bag& left, const Bag& right) {
  Bag result;
  for (const Mapping& a : left) {
    if (std::none_of(right.begin(), right.end(), [&a](const Mapping& b) {
          return Compatible(a, b) && Shares(a, b);
        })) {
      result.push_back(a);
    }
  }
  return result;
}

Bag InGraphs(const Element& e, const World& world) {
  Bag result;
  for (const auto& [name, triples] : world.named) {
    if (!IsVariable(e.graph) && e.graph != name) continue;
    Bag inside = Evaluate(e.groups[0], world, triples);
    if (IsVariable(e.graph)) inside = Join(inside, {{{e.graph, name}}});
    result.insert(result.end(), inside.begin(), inside.end());
  }
  return result;
}

Bag Projected(const Element& e, const Bag& bag) {
  Bag result;
  for (const Mapping& mapping : bag) {
    Mapping row;
    for (const Text& column : e.columns) {
      if (mapping.count(column) != 0) row[column] = mapping.at(column);
    }
    const bool again = std::count(result.begin(), result.end(), row) > 0;
    if (!e.distinct || !again) result.push_back(row);
  }
  return result;
}

Bag Extended(Bag bag, const Element& e) {
  for (Mapping& mapping : bag) {
    const std::optional<Text> value = GetValue(e.value, mapping);
    if (value) mapping[e.variable] = *value;
  }
  return bag;
}

Bag EvaluateElement(const Element& e, const World& world,
                    const Triples& graph) {
  if (e.kind == "triple") return MatchTriple(e.triple, graph);
  if (e.kind == "path") return MatchPath(e.triple, graph);
  if (e.kind == "values") return e.rows;
  if (e.kind == "graph") return InGraphs(e, world);
  Bag bag = Evaluate(e.groups[0], world, graph);
  if (e.kind == "select") return Projected(e, bag);
  if (e.kind == "union") {
    const Bag more = Evaluate(e.groups[1], world, graph);
    bag.insert(bag.end(), more.begin(), more.end());
  }
  return bag;
}

Bag EvaluateUnfiltered(const Group& group, const World& world,
                       const Triples& graph) {
  Bag bag{{}};
  for (const Element& e : group.elements) {
    if (e.kind == "optional") {
      bag = LeftJoin(bag, e.groups[0], world, graph);
    } else if (e.kind == "minus") {
      bag = Minus(bag, Evaluate(e.groups[0], world, graph));
    } else if (e.kind == "bind") {
      bag = Extended(std::move(bag), e);
    } else {
      bag = Join(bag, EvaluateElement(e, world, graph));
    }
  }
  return bag;
}

}  // namespace

Bag Evaluate(const Group& group, const World& world, const Triples& graph) {
  Bag result;
  for (const Mapping& mapping : EvaluateUnfiltered(group, world, graph)) {
    if (HoldAll(group.filters, mapping, graph)) result.push_back(mapping);
  }
  return result;
}

namespace {

VectorView MakeView(const World& world) {
  VectorView view;
  for (const auto& [name, triples] : world.named) {
    for (const Triple& t : triples) {
      view.Add(ParseTurtleTerm(t[0]), ParseTurtleTerm(t[1]),
               ParseTurtleTerm(t[2]), ParseTurtleTerm(name));
    }
  }
  return view;
}

std::string FormatLine(const Mapping& mapping) {
  std::string line;
  for (const auto& [name, value] : mapping) line += name + "=" + value + " ";
  return line;
}

std::vector<std::string> Lines(const Bag& bag) {
  std::vector<std::string> lines;
  for (const Mapping& mapping : bag) lines.push_back(FormatLine(mapping));
  std::sort(lines.begin(), lines.end());
  return lines;
}

Bag MakeBag(const QueryResult& result) {
  Bag bag;
  for (const auto& row : result.rows) {
    Mapping mapping;
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (row[i]) mapping["?" + result.variables[i]] = ToTurtle(*row[i]);
    }
    bag.push_back(mapping);
  }
  return bag;
}

TEST(SparqlRandom, AnswersAsTheDefinitionsOfTheAlgebraDo) {
  const Dataset dataset{{std::string(kEx) + "g0", std::string(kEx) + "g1"},
                        std::nullopt};
  std::size_t solutions = 0;
  for (unsigned seed = 1; seed <= 6000; ++seed) {
    Dice dice(seed);
    const World world = dice.DrawWorld();
    const Group group = dice.DrawGroup(3);
    const Bag expected = Evaluate(group, world, world.default_graph);
    if (expected.size() > 2000) continue;
    solutions += expected.size();
    const VectorView view = MakeView(world);
    const std::string text = "SELECT *" + ToSparql(group);
    ASSERT_EQ(Lines(MakeBag(RunQuery(view, text, dataset, {}))),
              Lines(expected))
        << "seed " << seed << "\n"
        << text;
    const std::string ask = "ASK" + ToSparql(group);
    ASSERT_EQ(RunQuery(view, ask, dataset, {}).answer, !expected.empty())
        << ask;
  }
  EXPECT_GT(solutions, 10000u);  // Not all results are empty.
}

}  // namespace
}  // namespace brute
}  // namespace kg_core
