#include "kg_core/shacl/validation.h"

#include <algorithm>
#include <string>
#include <utility>

#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core::shacl {
namespace {

using Place = TermId Quad::*;

// The subjects or objects of all statements with `predicate`.
std::vector<Term> Ends(const DataGraph& data, const Term& predicate,
                       Place place) {
  std::vector<Term> found;
  Quad pattern;
  pattern.predicate = data.view.Find(predicate);
  pattern.graph = data.view.Find(Iri(data.graph));
  if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) return found;
  data.view.Match(pattern, [&](const Quad& quad) {
    found.push_back(data.view.Get(quad.*place));
    return true;
  });
  return found;
}

}  // namespace

const std::set<Term>& ShapeValidation::Classes(const Term& top) {
  const auto [entry, is_new] = classes_.try_emplace(top);
  if (is_new) {
    entry->second = ClassesBelow(data_.view, data_.class_graphs, top);
  }
  return entry->second;
}

bool ShapeValidation::HasTypeIn(const std::string& graph, const Term& node,
                                const Term& wanted) {
  const std::set<Term>& classes = Classes(wanted);
  const std::vector<Term> types = Objects(data_.view, graph, node, RdfType());
  return std::any_of(types.begin(), types.end(), [&](const Term& type) {
    return classes.count(type) != 0;
  });
}

bool ShapeValidation::IsInstance(const Term& node, const Term& wanted) {
  const std::vector<std::string>& graphs = data_.class_graphs;
  return std::any_of(graphs.begin(), graphs.end(), [&](const auto& graph) {
    return HasTypeIn(graph, node, wanted);
  });
}

// https://www.w3.org/TR/shacl/#targets
std::vector<Term> ShapeValidation::FocusNodes(const Shape& shape) {
  std::set<Term> nodes(shape.target_nodes.begin(), shape.target_nodes.end());
  const auto add = [&](const std::vector<Term>& found) {
    nodes.insert(found.begin(), found.end());
  };
  for (const Term& target : shape.target_classes) {
    for (const Term& type : Classes(target)) {
      add(Subjects(data_.view, data_.graph, RdfType(), type));
    }
  }
  for (const Term& predicate : shape.target_subjects_of) {
    add(Ends(data_, predicate, &Quad::subject));
  }
  for (const Term& predicate : shape.target_objects_of) {
    add(Ends(data_, predicate, &Quad::object));
  }
  return {nodes.begin(), nodes.end()};
}

bool ShapeValidation::IsTarget(const Shape& shape, const Term& node) {
  const auto any = [](const std::vector<Term>& terms, auto holds) {
    return std::any_of(terms.begin(), terms.end(), holds);
  };
  const auto has_edge = [&](Direction direction) {
    return [&, direction](const Term& predicate) {
      return !Step(data_, node, predicate, direction).empty();
    };
  };
  return any(shape.target_nodes, [&](const Term& t) { return t == node; }) ||
         any(shape.target_classes,
             [&](const Term& target) {
               return HasTypeIn(data_.graph, node, target);
             }) ||
         any(shape.target_subjects_of, has_edge(Direction::kForward)) ||
         any(shape.target_objects_of, has_edge(Direction::kBackward));
}

void ShapeValidation::CheckShape(const Shape& shape, const Term& focus,
                                 std::vector<Violation>& found) {
  if (shape.deactivated) return;
  std::vector<Term> values = {focus};
  if (shape.path) {
    const std::set<Term> reached = Walk(data_, *shape.path, {focus});
    values.assign(reached.begin(), reached.end());
  }
  for (const Constraint& constraint : shape.constraints) {
    constraint.component->check(
        {*this, shape, constraint, focus, values, found});
  }
}

bool ShapeValidation::Conforms(const Term& shape_id, const Term& node) {
  std::vector<Violation> found;
  CheckShape(shape(shape_id), node, found);
  return found.empty();
}

std::vector<Violation> ShapeValidation::Run() {
  std::vector<Violation> found;
  for (const auto& [id, shape] : shapes_) {
    if (shape.deactivated) continue;
    for (const Term& focus : FocusNodes(shape)) CheckShape(shape, focus, found);
  }
  return found;
}

Violation& ConstraintCheck::Report(const Term& value) const {
  Violation violation;
  violation.focus_node = focus;
  violation.path = shape.path;
  violation.value = value;
  violation.source_shape = shape.id;
  violation.named_shape = shape.named;
  violation.severity = shape.severity;
  violation.component = std::string("sh:") + constraint.component->name;
  violation.message = shape.message;
  violation.messages = shape.messages;
  if (violation.message.empty()) {
    violation.message = std::string("does not conform to sh:") +
                        constraint.component->parameter;
  }
  found.push_back(std::move(violation));
  return found.back();
}

}  // namespace kg_core::shacl
