// The constraint components: what each one checks of a focus node and its value
// nodes. https://www.w3.org/TR/shacl/#core-components

#ifndef KG_CORE_MISSION_SHACL_COMPONENTS_H_
#define KG_CORE_MISSION_SHACL_COMPONENTS_H_

#include <map>
#include <set>
#include <vector>

#include "kg_core/mission/shacl_shapes.h"
#include "kg_core/mission/validator.h"
#include "kg_core/sparql/regex.h"

namespace kg_core::shacl {

// One validation of one state.
class Validation {
 public:
  explicit Validation(const GraphView& view);

  // Every focus node of every shape with a target.
  std::vector<Violation> Run();
  // Checks `focus` against one shape, with the shapes that it refers to.
  void CheckShape(const Shape& shape, const Term& focus,
                  std::vector<Violation>& found);
  bool Conforms(const Term& shape_id, const Term& node);

  const GraphView& view() const { return view_; }
  const Shape& shape(const Term& id) const { return shapes_.at(id); }
  sparql::RegexCache& regexes() { return regexes_; }
  // Is `node` of `wanted`, or of a class below it by rdfs:subClassOf?
  bool IsInstance(const Term& node, const Term& wanted);

 private:
  std::vector<Term> FocusNodes(const Shape& shape);
  const std::set<Term>& Classes(const Term& top);

  const GraphView& view_;
  ShapeGraph shapes_;
  sparql::RegexCache regexes_;
  std::map<Term, std::set<Term>> classes_;
};

// What a component's function sees.
struct Check {
  Validation& run;
  const Shape& shape;
  const Constraint& constraint;
  const Term& focus;
  const std::vector<Term>& values;  // Value nodes.
  std::vector<Violation>& found;

  const Term& parameter() const { return constraint.terms.front(); }
  void Report(const Term& value) const;  // Empty IRI: no value to blame.
};

}  // namespace kg_core::shacl

#endif  // KG_CORE_MISSION_SHACL_COMPONENTS_H_
