#include "kg_core/shacl/changes.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/shacl/validation.h"

namespace kg_core::shacl {
namespace {

Term RdfType() { return Iri(std::string(kRdf) + "type"); }
Term SubClassOf() { return Iri(std::string(kRdfs) + "subClassOf"); }

// A step that validation takes from each node that `prefix` reaches.
struct Read {
  Path prefix;
  std::optional<Term> predicate;  // Any if none.
  Direction direction = Direction::kForward;
  bool is_class = false;  // Reads the class graphs.
};

class ReadFinder {
 public:
  explicit ReadFinder(const ShapeGraph& shapes) : shapes_(shapes) {}

  std::vector<Read> Find(const Shape& shape) {
    AddShape(shape, {});
    return std::move(reads_);
  }

 private:
  void AddShape(const Shape& shape, const Path& prefix) {
    if (shape.deactivated) return;
    Path values = prefix;
    if (shape.path) {
      AddPath(*shape.path, prefix);
      values = Then(prefix, *shape.path);
    }
    for (const Constraint& constraint : shape.constraints) {
      AddConstraint(constraint, prefix, values);
    }
  }

  void AddConstraint(const Constraint& constraint, const Path& prefix,
                     const Path& values) {
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

  void AddPath(const Path& path, const Path& prefix) {
    switch (path.kind) {
      case Path::Kind::kPredicate:
        reads_.push_back({prefix, path.predicate, Direction::kForward, false});
        return;
      case Path::Kind::kInverse:
        AddInverse(path, prefix);
        return;
      case Path::Kind::kSequence: {
        Path before = prefix;
        for (const Path& part : path.parts) {
          AddPath(part, before);
          before = Then(before, part);
        }
        return;
      }
      case Path::Kind::kAlternative:
      case Path::Kind::kZeroOrOne:
        for (const Path& part : path.parts) AddPath(part, prefix);
        return;
      case Path::Kind::kZeroOrMore:
      case Path::Kind::kOneOrMore:
        AddPath(path.parts[0],
                Then(prefix, {Path::Kind::kZeroOrMore, {}, path.parts}));
        return;
    }
  }

  void AddInverse(const Path& path, const Path& prefix) {
    const Path& part = path.parts[0];
    if (part.kind != Path::Kind::kPredicate) {
      AddPath(Inverse(part), prefix);
      return;
    }
    reads_.push_back({prefix, part.predicate, Direction::kBackward, false});
  }

  const ShapeGraph& shapes_;
  std::vector<Read> reads_;
};

bool HasTarget(const Shape& shape) {
  return !shape.deactivated &&
         !(shape.target_classes.empty() && shape.target_nodes.empty() &&
           shape.target_subjects_of.empty() && shape.target_objects_of.empty());
}

bool IsIn(const std::vector<std::string>& graphs, const Term& graph) {
  return std::find(graphs.begin(), graphs.end(), graph.text) != graphs.end();
}

class Toucher {
 public:
  Toucher(const DataGraph& before_and_after, const ShapeGraph& shapes)
      : data_(before_and_after), shapes_(shapes) {}

  std::set<Term> Touched(const Shape& shape,
                         const std::vector<const Statement*>& changes) const {
    std::set<Term> nodes;
    for (const Read& read : ReadFinder(shapes_).Find(shape)) {
      nodes.merge(Walk(data_, Inverse(read.prefix), Seen(read, changes)));
    }
    for (const Statement* change : changes) AddTargets(shape, *change, nodes);
    return nodes;
  }

 private:
  // Where `read` would have begun to see one of the changes.
  std::set<Term> Seen(const Read& read,
                      const std::vector<const Statement*>& changes) const {
    std::set<Term> nodes;
    for (const Statement* s : changes) {
      if (read.predicate && s->predicate != *read.predicate) continue;
      const bool sees = read.is_class ? IsIn(data_.class_graphs, s->graph)
                                      : s->graph.text == data_.graph;
      if (!sees) continue;
      nodes.insert(read.direction == Direction::kForward ? s->subject
                                                         : s->object);
    }
    return nodes;
  }

  // What the change may have made a target.
  void AddTargets(const Shape& shape, const Statement& change,
                  std::set<Term>& nodes) const {
    if (change.graph.text != data_.graph) return;
    const auto is_in = [&](const std::vector<Term>& predicates) {
      return std::find(predicates.begin(), predicates.end(),
                       change.predicate) != predicates.end();
    };
    const bool typed =
        !shape.target_classes.empty() && change.predicate == RdfType();
    if (typed || is_in(shape.target_subjects_of)) nodes.insert(change.subject);
    if (is_in(shape.target_objects_of)) nodes.insert(change.object);
  }

  const DataGraph& data_;
  const ShapeGraph& shapes_;
};

}  // namespace

std::optional<TouchedNodes> FindTouched(const DataGraph& data,
                                        const ShapeGraph& shapes,
                                        const Change& change) {
  std::vector<const Statement*> changes;
  for (const Statement& s : change.added) changes.push_back(&s);
  for (const Statement& s : change.removed) changes.push_back(&s);
  for (const Statement* s : changes) {
    if (s->predicate == SubClassOf() && IsIn(data.class_graphs, s->graph)) {
      return std::nullopt;
    }
  }
  const DataGraph both{data.view, data.graph, data.class_graphs,
                       &change.removed};
  const Toucher toucher(both, shapes);
  TouchedNodes touched;
  for (const auto& [id, shape] : shapes) {
    if (HasTarget(shape)) touched[id] = toucher.Touched(shape, changes);
  }
  return touched;
}

std::vector<Violation> ValidateTouched(const DataGraph& data,
                                       const ShapeGraph& shapes,
                                       const Change& change) {
  Validation validation(data, shapes);
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
