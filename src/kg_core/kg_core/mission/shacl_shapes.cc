#include "kg_core/mission/shacl_shapes.h"

#include <algorithm>
#include <string>
#include <utility>

#include "kg_core/base/input_error.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core::shacl {
namespace {

constexpr int kDeepestNesting = 32;

Term Sh(std::string_view local) { return Iri(kSh + std::string(local)); }
Term Rdf(std::string_view local) { return Iri(kRdf + std::string(local)); }

// Properties of a shape that constrain nothing, or that are read elsewhere.
constexpr std::string_view kOtherProperties[] = {
    "path",     "targetClass",  "targetNode", "message", "flags",      "name",
    "severity", "defaultValue", "order",      "group",   "description"};

[[noreturn]] void Refuse(const Term& shape, const std::string& what) {
  throw InputError("shape " + ToTurtle(shape) + ": " + what);
}

class Loader {
 public:
  explicit Loader(const GraphView& view) : view_(view) {}

  ShapeGraph Load() {
    for (const char* target : {"targetClass", "targetNode"}) {
      for (const Term& id : SubjectsOf(Sh(target))) LoadShape(id, id, 0);
    }
    return std::move(shapes_);
  }

 private:
  std::vector<Term> ObjectsOf(const Term& subject, const Term& property) const {
    return Objects(view_, kVocabGraph, subject, property);
  }

  std::vector<Term> SubjectsOf(const Term& property) const {
    std::vector<Term> found;
    Quad pattern;
    pattern.predicate = view_.Find(property);
    pattern.graph = view_.Find(Iri(kVocabGraph));
    if (pattern.predicate == kNoTerm || pattern.graph == kNoTerm) return found;
    view_.Match(pattern, [&](const Quad& quad) {
      found.push_back(view_.Get(quad.subject));
      return true;
    });
    return found;
  }

  // https://www.w3.org/TR/shacl/#syntax-rule-path-metarule; predicates only.
  void LoadPath(Shape& shape) const {
    const std::vector<Term> paths = ObjectsOf(shape.id, Sh("path"));
    if (paths.empty()) return;
    if (paths.size() != 1 || !paths[0].is_iri()) {
      Refuse(shape.named, "sh:path must be one predicate");
    }
    shape.has_path = true;
    shape.path = paths[0];
  }

  std::vector<Term> ListMembers(const Term& shape, Term node) const {
    std::vector<Term> members;
    while (node != Rdf("nil")) {
      const auto first = FirstObject(view_, kVocabGraph, node, Rdf("first"));
      const auto rest = FirstObject(view_, kVocabGraph, node, Rdf("rest"));
      if (!first || !rest || members.size() > 10000) {
        Refuse(shape, "expected an RDF list");
      }
      members.push_back(*first);
      node = *rest;
    }
    return members;
  }

  void LoadConstraint(Shape& shape, const Component& component,
                      const Term& value, int depth) {
    Constraint constraint;
    constraint.component = &component;
    const bool is_list = component.kind == ParameterKind::kTermList ||
                         component.kind == ParameterKind::kShapeList;
    constraint.terms =
        is_list ? ListMembers(shape.named, value) : std::vector<Term>{value};
    const auto flags = FirstObject(view_, kVocabGraph, shape.id, Sh("flags"));
    if (flags) constraint.flags = flags->text;
    const bool is_shape = component.kind == ParameterKind::kShape ||
                          component.kind == ParameterKind::kShapeList;
    for (const Term& term : constraint.terms) {
      if (is_shape) LoadShape(term, shape.named, depth + 1);
    }
    shape.constraints.push_back(std::move(constraint));
  }

  void LoadProperty(Shape& shape, const Quad& quad, int depth) {
    const std::string& iri = view_.Get(quad.predicate).text;
    if (iri.compare(0, sizeof(kSh) - 1, kSh) != 0) return;
    const std::string local = iri.substr(sizeof(kSh) - 1);
    if (const Component* component = FindComponent(local)) {
      LoadConstraint(shape, *component, view_.Get(quad.object), depth);
      return;
    }
    if (std::find(std::begin(kOtherProperties), std::end(kOtherProperties),
                  local) == std::end(kOtherProperties)) {
      Refuse(shape.named, "sh:" + local + " is not available");
    }
  }

  void LoadShape(const Term& id, const Term& around, int depth) {
    if (shapes_.count(id) != 0) return;
    if (depth > kDeepestNesting) Refuse(around, "shapes are nested too deeply");
    Shape shape;
    shape.id = id;
    shape.named = id.is_iri() ? id : around;
    LoadPath(shape);
    shape.target_classes = ObjectsOf(id, Sh("targetClass"));
    shape.target_nodes = ObjectsOf(id, Sh("targetNode"));
    const auto message = FirstObject(view_, kVocabGraph, id, Sh("message"));
    if (message) shape.message = message->text;
    Quad pattern;
    pattern.subject = view_.Find(id);
    pattern.graph = view_.Find(Iri(kVocabGraph));
    if (pattern.subject == kNoTerm) Refuse(around, "a shape it names is empty");
    view_.Match(pattern, [&](const Quad& quad) {
      LoadProperty(shape, quad, depth);
      return true;
    });
    SortConstraints(shape);
    shapes_.emplace(id, std::move(shape));
  }

  // In the table's order, whatever order the store keeps.
  static void SortConstraints(Shape& shape) {
    std::sort(shape.constraints.begin(), shape.constraints.end(),
              [](const Constraint& a, const Constraint& b) {
                if (a.component != b.component)
                  return a.component < b.component;
                return a.terms < b.terms;
              });
  }

  const GraphView& view_;
  ShapeGraph shapes_;
};

}  // namespace

ShapeGraph LoadShapes(const GraphView& view) { return Loader(view).Load(); }

}  // namespace kg_core::shacl
