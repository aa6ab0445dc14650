#include "kg_core/shacl/path.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/rdf_list.h"

namespace kg_core::shacl {
namespace {

using PathKind = PropertyPath::Kind;

constexpr int kMaxPathNesting = 32;

// Kinds of path with one part, and the property that holds the part.
struct OnePart {
  const char* property;
  PathKind kind;
};
constexpr OnePart kOnePart[] = {
    {"inversePath", PathKind::kInverse},
    {"zeroOrMorePath", PathKind::kZeroOrMore},
    {"oneOrMorePath", PathKind::kOneOrMore},
    {"zeroOrOnePath", PathKind::kZeroOrOne},
};

Term Sh(const char* local) { return Iri(std::string(kSh) + local); }
Term RdfFirst() { return Iri(std::string(kRdf) + "first"); }

[[noreturn]] void Refuse(const std::string& what) {
  throw kg_base::InputError("path: " + what);
}

class PathReader {
 public:
  PathReader(const GraphView& view, const std::string& graph)
      : view_(view), graph_(graph) {}

  // https://www.w3.org/TR/shacl/#dfn-shacl-property-path
  PropertyPath Read(const Term& node, int depth) const {
    if (depth > kMaxPathNesting) Refuse("nested too deeply, or in itself");
    if (node.is_iri()) return PredicatePath(node);
    if (node.is_literal()) Refuse("expected no literal: " + ToTurtle(node));
    // A node with rdf:first is a sequence regardless of its other properties
    // (W3C test path-strange-001).
    if (FirstObject(view_, graph_, node, RdfFirst())) {
      return ReadParts(PathKind::kSequence, node, depth);
    }
    if (CountKinds(node) != 1) {
      Refuse(
          "expected a predicate, a list or exactly one of sh:inversePath, "
          "sh:alternativePath, sh:zeroOrMorePath, sh:oneOrMorePath, "
          "sh:zeroOrOnePath");
    }
    if (const auto list = One(node, "alternativePath")) {
      return ReadParts(PathKind::kAlternative, *list, depth);
    }
    PropertyPath path;
    for (const OnePart& row : kOnePart) {
      const auto part = One(node, row.property);
      if (!part) continue;
      path.kind = row.kind;
      path.parts.push_back(Read(*part, depth + 1));
    }
    return path;
  }

 private:
  std::optional<Term> One(const Term& node, const char* property) const {
    return FirstObject(view_, graph_, node, Sh(property));
  }

  std::size_t CountKinds(const Term& node) const {
    std::size_t count =
        Objects(view_, graph_, node, Sh("alternativePath")).size();
    for (const OnePart& row : kOnePart) {
      count += Objects(view_, graph_, node, Sh(row.property)).size();
    }
    return count;
  }

  PropertyPath ReadParts(PathKind kind, const Term& list, int depth) const {
    const auto members = ReadList(view_, graph_, list);
    if (!members || members->size() < 2) {
      Refuse("expected a list of two or more paths");
    }
    PropertyPath path;
    path.kind = kind;
    for (const Term& member : *members) {
      path.parts.push_back(Read(member, depth + 1));
    }
    return path;
  }

  const GraphView& view_;
  const std::string& graph_;
};

std::set<Term> WalkPredicate(const DataGraph& data, const Term& predicate,
                             const std::set<Term>& from, Direction direction) {
  std::set<Term> reached;
  for (const Term& node : from) {
    for (Term& next : Step(data, node, predicate, direction)) {
      reached.insert(std::move(next));
    }
  }
  return reached;
}

// Breadth-first closure, which includes the start nodes `reached`.
std::set<Term> Closure(const DataGraph& data, const PropertyPath& part,
                       std::set<Term> reached) {
  std::set<Term> front = reached;
  while (!front.empty()) {
    std::set<Term> next;
    for (const Term& node : Walk(data, part, front)) {
      if (reached.insert(node).second) next.insert(node);
    }
    front = std::move(next);
  }
  return reached;
}

}  // namespace

PropertyPath PredicatePath(const Term& predicate) {
  return {PathKind::kPredicate, predicate, {}};
}

PropertyPath Then(const PropertyPath& a, const PropertyPath& b) {
  return {PathKind::kSequence, {}, {a, b}};
}

PropertyPath Inverse(const PropertyPath& path) {
  if (path.kind == PathKind::kPredicate) {
    return {PathKind::kInverse, {}, {path}};
  }
  if (path.kind == PathKind::kInverse) return path.parts[0];
  PropertyPath inverse = path;
  for (PropertyPath& part : inverse.parts) part = Inverse(part);
  if (path.kind == PathKind::kSequence) {
    std::reverse(inverse.parts.begin(), inverse.parts.end());
  }
  return inverse;
}

std::string ToTurtle(const PropertyPath& path) {
  if (path.kind == PathKind::kPredicate) {
    return kg_core::ToTurtle(path.predicate);
  }
  for (const OnePart& row : kOnePart) {
    if (row.kind != path.kind) continue;
    return std::string("[ sh:") + row.property + " " + ToTurtle(path.parts[0]) +
           " ]";
  }
  std::string list = "( ";
  for (const PropertyPath& part : path.parts) list += ToTurtle(part) + " ";
  list += ")";
  if (path.kind == PathKind::kSequence) return list;
  return "[ sh:alternativePath " + list + " ]";
}

PropertyPath ReadPath(const GraphView& view, const std::string& graph,
                      const Term& node) {
  return PathReader(view, graph).Read(node, 0);
}

std::set<Term> Walk(const DataGraph& data, const PropertyPath& path,
                    const std::set<Term>& from) {
  switch (path.kind) {
    case PathKind::kPredicate:
      return WalkPredicate(data, path.predicate, from, Direction::kForward);
    case PathKind::kInverse: {
      const PropertyPath& part = path.parts[0];
      if (part.kind != PathKind::kPredicate) {
        return Walk(data, Inverse(part), from);
      }
      return WalkPredicate(data, part.predicate, from, Direction::kBackward);
    }
    case PathKind::kSequence: {
      std::set<Term> reached = from;
      for (const PropertyPath& part : path.parts) {
        reached = Walk(data, part, reached);
      }
      return reached;
    }
    case PathKind::kAlternative: {
      std::set<Term> reached;
      for (const PropertyPath& part : path.parts) {
        reached.merge(Walk(data, part, from));
      }
      return reached;
    }
    case PathKind::kZeroOrMore:
      return Closure(data, path.parts[0], from);
    // p+ is p followed by p*.
    case PathKind::kOneOrMore:
      return Closure(data, path.parts[0], Walk(data, path.parts[0], from));
    case PathKind::kZeroOrOne: {
      std::set<Term> reached = Walk(data, path.parts[0], from);
      reached.insert(from.begin(), from.end());
      return reached;
    }
  }
  return {};
}

}  // namespace kg_core::shacl
