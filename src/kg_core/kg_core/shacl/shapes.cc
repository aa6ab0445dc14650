#include "kg_core/shacl/shapes.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/rdf_list.h"
#include "kg_core/shacl/components.h"
#include "kg_core/shacl/parameters.h"

namespace kg_core::shacl {
namespace {

constexpr int kMaxShapeNesting = 64;

Term Sh(std::string_view local) { return Iri(kSh + std::string(local)); }
// Properties of a shape that are not constraints or are read elsewhere.
constexpr std::string_view kOtherProperties[] = {
    "path",
    "targetClass",
    "targetNode",
    "targetSubjectsOf",
    "targetObjectsOf",
    "message",
    "flags",
    "name",
    "severity",
    "deactivated",
    "defaultValue",
    "order",
    "group",
    "description",
    "ignoredProperties",
    "qualifiedValueShape",
    "qualifiedValueShapesDisjoint"};

constexpr std::string_view kTargets[] = {"targetClass", "targetNode",
                                         "targetSubjectsOf", "targetObjectsOf"};

class ShapeLoader {
 public:
  ShapeLoader(const GraphView& view, const std::string& graph)
      : view_(view), graph_(graph) {}

  ShapeGraph Load() {
    for (const char* type : {"NodeShape", "PropertyShape"}) {
      for (const Term& id : Subjects(view_, graph_, RdfType(), Sh(type))) {
        LoadShape(id, id);
      }
    }
    for (const std::string_view target : kTargets) {
      for (const Term& id : ListSubjects(Sh(target))) LoadShape(id, id);
    }
    FindSiblings();
    return std::move(shapes_);
  }

 private:
  std::vector<Term> ListObjects(const Term& subject,
                                std::string_view local) const {
    return Objects(view_, graph_, subject, Sh(local));
  }

  std::vector<Term> ListSubjects(const Term& property) const {
    std::vector<Term> found;
    Quad pattern;
    pattern.predicate = view_.Find(property);
    pattern.graph = view_.Find(Iri(graph_));
    if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) return found;
    view_.Match(pattern, [&](const Quad& quad) {
      found.push_back(view_.Get(quad.subject));
      return true;
    });
    return found;
  }

  // The value of a property with at most one value; rejects the shape if there
  // are more.
  std::optional<Term> One(const Shape& shape, std::string_view local) const {
    const std::vector<Term> values = ListObjects(shape.id, local);
    if (values.size() > 1) {
      RefuseShape(shape, "expected at most one sh:" + std::string(local));
    }
    if (values.empty()) return std::nullopt;
    return values[0];
  }

  bool IsTrue(const Shape& shape, std::string_view local) const {
    const auto value = One(shape, local);
    return value && ReadBoolean(shape, std::string(local), *value);
  }

  bool HasType(const Term& id, const Term& type) const {
    return Has(view_, graph_, id, RdfType(), type);
  }

  void LoadPath(Shape& shape) const {
    const auto path = One(shape, "path");
    if (!path && HasType(shape.id, Sh("PropertyShape"))) {
      RefuseShape(shape, "expected a sh:path, as it is a sh:PropertyShape");
    }
    if (!path) return;
    if (HasType(shape.id, Sh("NodeShape"))) {
      RefuseShape(shape, "expected no sh:path, as it is a sh:NodeShape");
    }
    try {
      shape.path = ReadPath(view_, graph_, *path);
    } catch (const kg_base::InputError& error) {
      RefuseShape(shape, std::string("sh:") + error.what());
    }
  }

  std::vector<Term> Iris(const Shape& shape, std::string_view local) const {
    std::vector<Term> values = ListObjects(shape.id, local);
    for (const Term& value : values) {
      if (value.is_iri()) continue;
      RefuseShape(shape, "expected an IRI as sh:" + std::string(local) +
                             ", not " + kg_core::ToTurtle(value));
    }
    return values;
  }

  // https://www.w3.org/TR/shacl/#targets
  void LoadTargets(Shape& shape) {
    shape.target_classes = Iris(shape, "targetClass");
    shape.target_subjects_of = Iris(shape, "targetSubjectsOf");
    shape.target_objects_of = Iris(shape, "targetObjectsOf");
    shape.target_nodes = ListObjects(shape.id, "targetNode");
    for (const Term& node : shape.target_nodes) {
      if (!node.is_blank()) continue;
      RefuseShape(shape, "expected no blank node as sh:targetNode");
    }
    if (shape.id.is_iri() && IsClass(shape.id)) {
      shape.target_classes.push_back(shape.id);
    }
  }

  // https://www.w3.org/TR/shacl/#implicit-targetClass
  bool IsClass(const Term& id) {
    if (class_types_.empty()) {
      class_types_ =
          ClassesBelow(view_, {graph_}, Iri(std::string(kRdfs) + "Class"));
    }
    const std::vector<Term> types = Objects(view_, graph_, id, RdfType());
    return std::any_of(types.begin(), types.end(), [&](const Term& type) {
      return class_types_.count(type) != 0;
    });
  }

  void LoadWords(Shape& shape) const {
    shape.messages = ListObjects(shape.id, "message");
    for (const Term& message : shape.messages) {
      if (!message.is_literal()) {
        RefuseShape(shape, "expected a text as sh:message");
      }
      const bool plain = message.language.empty();
      if (shape.message.empty() || plain) shape.message = message.text;
    }
    shape.severity = One(shape, "severity").value_or(Sh("Violation"));
    if (!shape.severity.is_iri()) {
      RefuseShape(shape, "expected an IRI as sh:severity");
    }
    shape.deactivated = IsTrue(shape, "deactivated");
  }

  void ReadTerms(const Shape& shape, const Term& value,
                 Constraint& constraint) const {
    const ConstraintComponent& component = *constraint.component;
    constraint.terms = {value};
    if (component.kind == ParameterKind::kList ||
        component.kind == ParameterKind::kLanguages ||
        component.kind == ParameterKind::kShapeList) {
      auto members = ReadList(view_, graph_, value);
      if (!members) {
        RefuseShape(shape, std::string("expected an RDF list as sh:") +
                               component.parameter);
      }
      constraint.terms = std::move(*members);
    }
    // sh:flags belongs to sh:pattern in the same shape.
    const auto flags = One(shape, "flags");
    if (flags) constraint.flags = flags->text;
    CheckParameter(shape, constraint);
    if (component.kind == ParameterKind::kCount ||
        component.kind == ParameterKind::kQualified) {
      constraint.count = ReadCount(shape, component.parameter, value);
    }
  }

  // https://www.w3.org/TR/shacl/#ClosedConstraintComponent
  std::vector<Term> AllowedProperties(const Shape& shape) const {
    std::vector<Term> allowed;
    if (const auto ignored = One(shape, "ignoredProperties")) {
      const auto members = ReadList(view_, graph_, *ignored);
      if (!members) {
        RefuseShape(shape, "expected an RDF list as sh:ignoredProperties");
      }
      allowed = *members;
    }
    for (const Term& property : ListObjects(shape.id, "property")) {
      const auto path = FirstObject(view_, graph_, property, Sh("path"));
      if (path && path->is_iri()) allowed.push_back(*path);
    }
    return allowed;
  }

  void LoadConstraint(Shape& shape, const ConstraintComponent& component,
                      const Term& value) {
    if (component.property_only && !shape.path) {
      RefuseShape(shape, std::string("expected no sh:") + component.parameter +
                             " in a node shape");
    }
    // One() rejects a shape with two values.
    if (component.most_one) One(shape, component.parameter);
    Constraint constraint;
    constraint.component = &component;
    ReadTerms(shape, value, constraint);
    if (component.kind == ParameterKind::kTrue) {
      if (!ReadBoolean(shape, component.parameter, value)) return;
      if (component.parameter == std::string_view("closed")) {
        constraint.others = AllowedProperties(shape);
      }
    }
    if (component.kind == ParameterKind::kQualified) {
      const auto qualified = One(shape, "qualifiedValueShape");
      if (!qualified) return;
      if (!shape.path) {
        RefuseShape(shape,
                    "expected no sh:qualifiedValueShape in a node shape");
      }
      constraint.terms = {*qualified};
    }
    if (RefersToShapes(component.kind)) {
      for (const Term& term : constraint.terms) {
        LoadReferred(shape, constraint, term);
      }
    }
    shape.constraints.push_back(std::move(constraint));
  }

  void LoadReferred(const Shape& shape, const Constraint& constraint,
                    const Term& id) {
    LoadShape(id, shape.named);
    if (constraint.component->kind != ParameterKind::kPropertyShape) return;
    if (!shapes_.at(id).path) {
      RefuseShape(shape, "expected a shape with a sh:path as sh:property");
    }
  }

  void LoadProperty(Shape& shape, const Quad& quad) {
    const std::string& iri = view_.Get(quad.predicate).text;
    if (iri.compare(0, sizeof(kSh) - 1, kSh) != 0) return;
    const std::string local = iri.substr(sizeof(kSh) - 1);
    if (const ConstraintComponent* component = FindComponent(local)) {
      LoadConstraint(shape, *component, view_.Get(quad.object));
      return;
    }
    if (std::find(std::begin(kOtherProperties), std::end(kOtherProperties),
                  local) == std::end(kOtherProperties)) {
      RefuseShape(shape, "sh:" + local + " is not available");
    }
  }

  void LoadShape(const Term& id, const Term& around) {
    if (shapes_.count(id) != 0) return;
    Shape shape;
    shape.id = id;
    shape.named = id.is_iri() ? id : around;
    if (id.is_literal()) {
      RefuseShape(shape, "expected a shape, not " + kg_core::ToTurtle(id));
    }
    // Shapes on the current recursion path are open; meeting one again is a
    // cycle.
    if (!open_.insert(id).second) {
      RefuseShape(shape, "it refers to itself; recursion is not available");
    }
    if (open_.size() > kMaxShapeNesting) {
      RefuseShape(shape, "shapes are nested too deeply");
    }
    LoadPath(shape);
    LoadTargets(shape);
    LoadWords(shape);
    LoadProperties(shape);
    SortConstraints(shape);
    open_.erase(id);
    shapes_.emplace(id, std::move(shape));
  }

  // A shape without statements in the graph is taken as a misspelt name and
  // rejected.
  void LoadProperties(Shape& shape) {
    Quad pattern;
    pattern.subject = view_.Find(shape.id);
    pattern.graph = view_.Find(Iri(graph_));
    const bool is_described =
        pattern.subject != kNoTerm && pattern.graph != kNoTerm;
    bool any = false;
    if (is_described) {
      view_.Match(pattern, [&](const Quad& quad) {
        any = true;
        LoadProperty(shape, quad);
        return true;
      });
    }
    if (!any) RefuseShape(shape, "nothing describes it");
  }

  // Sorts by the component table, independent of the store's order.
  static void SortConstraints(Shape& shape) {
    std::sort(shape.constraints.begin(), shape.constraints.end(),
              [](const Constraint& a, const Constraint& b) {
                if (a.component != b.component) {
                  return a.component < b.component;
                }
                return a.terms < b.terms;
              });
  }

  // https://www.w3.org/TR/shacl/#dfn-sibling-shapes
  void FindSiblings() {
    for (auto& [id, shape] : shapes_) {
      if (!IsTrue(shape, "qualifiedValueShapesDisjoint")) continue;
      const auto own = One(shape, "qualifiedValueShape");
      if (!own) continue;
      const std::vector<Term> siblings = ListSiblings(id, *own);
      for (Constraint& constraint : shape.constraints) {
        if (constraint.component->kind == ParameterKind::kQualified) {
          constraint.others = siblings;
        }
      }
    }
  }

  std::vector<Term> ListSiblings(const Term& id, const Term& own) {
    std::set<Term> siblings;
    for (const Term& parent : Subjects(view_, graph_, Sh("property"), id)) {
      for (const Term& property : ListObjects(parent, "property")) {
        for (const Term& s : ListObjects(property, "qualifiedValueShape")) {
          if (s != own) siblings.insert(s);
        }
      }
    }
    for (const Term& sibling : siblings) {
      if (shapes_.count(sibling) == 0) LoadShape(sibling, id);
    }
    return {siblings.begin(), siblings.end()};
  }

  const GraphView& view_;
  const std::string& graph_;
  ShapeGraph shapes_;
  std::set<Term> open_;         // Shapes being read, outermost to innermost.
  std::set<Term> class_types_;  // rdfs:Class and its subclasses.
};

}  // namespace

ShapeGraph LoadShapes(const GraphView& view, const std::string& graph) {
  return ShapeLoader(view, graph).Load();
}

}  // namespace kg_core::shacl
