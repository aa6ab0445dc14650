#include "kg_core/mission/validator.h"

#include "kg_core/mission/class_tree.h"
#include "kg_core/mission/shacl_components.h"
#include "kg_core/mission/terms.h"

namespace kg_core {
namespace shacl {
namespace {

// Where the classes of things stand: facts, the vocabulary's own individuals,
// and what activities made.
constexpr const char* kTypeGraphs[] = {kFactsGraph, kVocabGraph, kProvGraph};

}  // namespace

Validation::Validation(const GraphView& view)
    : view_(view), shapes_(LoadShapes(view)) {}

const std::set<Term>& Validation::Classes(const Term& top) {
  const auto [entry, is_new] = classes_.try_emplace(top);
  if (is_new) entry->second = ClassAndSubclasses(view_, top);
  return entry->second;
}

bool Validation::IsInstance(const Term& node, const Term& wanted) {
  const std::set<Term>& classes = Classes(wanted);
  for (const char* graph : kTypeGraphs) {
    for (const Term& type : Objects(view_, graph, node, RdfType())) {
      if (classes.count(type) != 0) return true;
    }
  }
  return false;
}

// https://www.w3.org/TR/shacl/#targets
std::vector<Term> Validation::FocusNodes(const Shape& shape) {
  std::set<Term> nodes(shape.target_nodes.begin(), shape.target_nodes.end());
  for (const Term& target : shape.target_classes) {
    const std::vector<Term> found = InstancesOf(view_, kFactsGraph, target);
    nodes.insert(found.begin(), found.end());
  }
  return {nodes.begin(), nodes.end()};
}

void Validation::CheckShape(const Shape& shape, const Term& focus,
                            std::vector<Violation>& found) {
  const std::vector<Term> values =
      shape.has_path ? Objects(view_, kFactsGraph, focus, shape.path)
                     : std::vector<Term>{focus};
  for (const Constraint& constraint : shape.constraints) {
    constraint.component->check(
        {*this, shape, constraint, focus, values, found});
  }
}

bool Validation::Conforms(const Term& shape_id, const Term& node) {
  std::vector<Violation> found;
  CheckShape(shape(shape_id), node, found);
  return found.empty();
}

std::vector<Violation> Validation::Run() {
  std::vector<Violation> found;
  for (const auto& [id, shape] : shapes_) {
    for (const Term& focus : FocusNodes(shape)) CheckShape(shape, focus, found);
  }
  return found;
}

}  // namespace shacl

std::string Violation::Line() const {
  std::string line = ToTurtle(focus_node);
  if (!path.text.empty()) line += " " + ToTurtle(path);
  line += ": " + message;
  const bool has_value = value.is_literal() || !value.text.empty();
  if (has_value && value != focus_node) line += ", not " + ToTurtle(value);
  return line + " (" + ToTurtle(named_shape) + ")";
}

std::vector<Violation> Validate(const GraphView& view) {
  return shacl::Validation(view).Run();
}

}  // namespace kg_core
