#include "kg_core/shacl/changes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/shacl/validation.h"

namespace kg_core::shacl {
namespace {

Term SubClassOf() { return Iri(std::string(kRdfs) + "subClassOf"); }

// A step that validation takes from each node reached by `prefix`.
struct PathRead {
  PropertyPath prefix;
  std::optional<Term> predicate;  // nullopt: any predicate.
  Direction direction = Direction::kForward;
  bool is_class = false;  // Reads the class graphs.
};

class ReadFinder {
 public:
  explicit ReadFinder(const ShapeGraph& shapes) : shapes_(shapes) {}

  std::vector<PathRead> Find(const Shape& shape) {
    AddShape(shape, {});
    return std::move(reads_);
  }

 private:
  void AddShape(const Shape& shape, const PropertyPath& prefix) {
    if (shape.deactivated) return;
    PropertyPath values = prefix;
    if (shape.path) {
      AddPath(*shape.path, prefix);
      values = Then(prefix, *shape.path);
    }
    for (const Constraint& constraint : shape.constraints) {
      AddConstraint(constraint, prefix, values);
    }
  }

  void AddConstraint(const Constraint& constraint, const PropertyPath& prefix,
                     const PropertyPath& values) {
    const std::string_view name = constraint.component->parameter;
    if (name == "class") reads_.push_back({values, RdfType(), {}, true});
    if (name == "closed") reads_.push_back({values, std::nullopt, {}, false});
    for (const char* pair :
         {"equals", "disjoint", "lessThan", "lessThanOrEquals"}) {
      if (name != pair) continue;
      reads_.push_back({prefix, constraint.terms[0], {}, false});
    }
    if (!RefersToShapes(constraint.component->kind)) return;
    for (const Term& id : constraint.terms) AddShape(shapes_.at(id), values);
    for (const Term& id : constraint.others) AddShape(shapes_.at(id), values);
  }

  void AddPath(const PropertyPath& path, const PropertyPath& prefix) {
    switch (path.kind) {
      case PropertyPath::Kind::kPredicate:
        reads_.push_back({prefix, path.predicate, Direction::kForward, false});
        return;
      case PropertyPath::Kind::kInverse:
        AddInverse(path, prefix);
        return;
      case PropertyPath::Kind::kSequence: {
        PropertyPath before = prefix;
        for (const PropertyPath& part : path.parts) {
          AddPath(part, before);
          // The next part is read at the nodes reached by the parts so far.
          before = Then(before, part);
        }
        return;
      }
      case PropertyPath::Kind::kAlternative:
      case PropertyPath::Kind::kZeroOrOne:
        for (const PropertyPath& part : path.parts) AddPath(part, prefix);
        return;
      case PropertyPath::Kind::kZeroOrMore:
      case PropertyPath::Kind::kOneOrMore:
        AddPath(
            path.parts[0],
            Then(prefix, {PropertyPath::Kind::kZeroOrMore, {}, path.parts}));
        return;
    }
  }

  void AddInverse(const PropertyPath& path, const PropertyPath& prefix) {
    const PropertyPath& part = path.parts[0];
    if (part.kind != PropertyPath::Kind::kPredicate) {
      AddPath(Inverse(part), prefix);
      return;
    }
    reads_.push_back({prefix, part.predicate, Direction::kBackward, false});
  }

  const ShapeGraph& shapes_;
  std::vector<PathRead> reads_;
};

bool HasTarget(const Shape& shape) {
  return !shape.deactivated &&
         !(shape.target_classes.empty() && shape.target_nodes.empty() &&
           shape.target_subjects_of.empty() && shape.target_objects_of.empty());
}

bool IsIn(const std::vector<std::string>& graphs, const Term& graph) {
  return std::find(graphs.begin(), graphs.end(), graph.text) != graphs.end();
}

using Statements = std::vector<const Statement*>;

class TouchFinder {
 public:
  TouchFinder(const DataGraph& before_and_after, const ShapeGraph& shapes,
              const Statements& changes)
      : data_(before_and_after), shapes_(shapes), changes_(changes) {
    for (const Statement* s : changes) by_predicate_[s->predicate].push_back(s);
  }

  std::set<Term> Touched(const Shape& shape) const {
    std::set<Term> nodes;
    for (const PathRead& read : ReadFinder(shapes_).Find(shape)) {
      nodes.merge(Walk(data_, Inverse(read.prefix), Seen(read)));
    }
    AddTargets(shape, nodes);
    return nodes;
  }

 private:
  const Statements& Of(const Term& predicate) const {
    static const Statements kNone;
    const auto found = by_predicate_.find(predicate);
    return found == by_predicate_.end() ? kNone : found->second;
  }

  // The focus nodes from which `read` reaches one of the changes.
  std::set<Term> Seen(const PathRead& read) const {
    std::set<Term> nodes;
    for (const Statement* s : read.predicate ? Of(*read.predicate) : changes_) {
      const bool sees = read.is_class ? IsIn(data_.class_graphs, s->graph)
                                      : s->graph.text == data_.graph;
      if (!sees) continue;
      nodes.insert(read.direction == Direction::kForward ? s->subject
                                                         : s->object);
    }
    return nodes;
  }

  // Adds the nodes that the changes may have made targets.
  void AddTargets(const Shape& shape, std::set<Term>& nodes) const {
    if (!shape.target_classes.empty()) {
      AddEnds(RdfType(), Direction::kForward, nodes);
    }
    for (const Term& predicate : shape.target_subjects_of) {
      AddEnds(predicate, Direction::kForward, nodes);
    }
    for (const Term& predicate : shape.target_objects_of) {
      AddEnds(predicate, Direction::kBackward, nodes);
    }
  }

  void AddEnds(const Term& predicate, Direction direction,
               std::set<Term>& nodes) const {
    nodes.merge(Seen({{}, predicate, direction, false}));
  }

  const DataGraph& data_;
  const ShapeGraph& shapes_;
  const Statements& changes_;
  std::map<Term, Statements> by_predicate_;
};

}  // namespace

std::optional<TouchedNodes> FindTouched(const DataGraph& data,
                                        const ShapeGraph& shapes,
                                        const GraphChange& change) {
  Statements changes;
  for (const Statement& s : change.added) changes.push_back(&s);
  for (const Statement& s : change.removed) changes.push_back(&s);
  for (const Statement* s : changes) {
    if (s->predicate == SubClassOf() && IsIn(data.class_graphs, s->graph)) {
      return std::nullopt;
    }
  }
  const DataGraph both{data.view, data.graph, data.class_graphs,
                       &change.removed};
  const TouchFinder finder(both, shapes, changes);
  TouchedNodes touched;
  for (const auto& [id, shape] : shapes) {
    if (HasTarget(shape)) touched[id] = finder.Touched(shape);
  }
  return touched;
}

std::vector<Violation> ValidateTouched(const DataGraph& data,
                                       const ShapeGraph& shapes,
                                       const GraphChange& change) {
  ShapeValidation validation(data, shapes);
  const auto touched = FindTouched(data, shapes, change);
  if (!touched) return validation.Run();
  std::vector<Violation> found;
  for (const auto& [id, nodes] : *touched) {
    const Shape& shape = shapes.at(id);
    for (const Term& node : nodes) {
      if (!validation.IsTarget(shape, node)) continue;
      validation.CheckShape(shape, node, found);
    }
  }
  return found;
}

}  // namespace kg_core::shacl
