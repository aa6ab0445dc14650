// SHACL Core: one validation of one data graph against one graph of shapes.
// https://www.w3.org/TR/shacl/#validation

#ifndef KG_CORE_SHACL_VALIDATION_H_
#define KG_CORE_SHACL_VALIDATION_H_

#include <map>
#include <set>
#include <vector>

#include "kg_base/text/regex.h"
#include "kg_core/shacl/data_graph.h"
#include "kg_core/shacl/shape.h"
#include "kg_core/shacl/violation.h"

namespace kg_core::shacl {

class ShapeValidation {
 public:
  ShapeValidation(const DataGraph& data, const ShapeGraph& shapes)
      : data_(data), shapes_(shapes) {}

  // Validates every focus node of every shape with a target.
  std::vector<Violation> Run();
  std::vector<Term> FocusNodes(const Shape& shape);
  bool IsTarget(const Shape& shape, const Term& node);
  // Checks `focus` against one shape and the shapes that it refers to.
  void CheckShape(const Shape& shape, const Term& focus,
                  std::vector<Violation>& found);
  bool Conforms(const Term& shape_id, const Term& node);

  const DataGraph& data() const { return data_; }
  const Shape& shape(const Term& id) const { return shapes_.at(id); }
  kg_base::RegexCache& regexes() { return regexes_; }
  // True if `node` is an instance of `wanted` or of a subclass of it.
  bool IsInstance(const Term& node, const Term& wanted);

 private:
  bool HasTypeIn(const std::string& graph, const Term& node,
                 const Term& wanted);
  const std::set<Term>& Classes(const Term& top);

  const DataGraph& data_;
  const ShapeGraph& shapes_;
  kg_base::RegexCache regexes_;
  std::map<Term, std::set<Term>> classes_;
};

// Input and output of a component's check function.
struct ConstraintCheck {
  ShapeValidation& run;
  const Shape& shape;
  const Constraint& constraint;
  const Term& focus;
  const std::vector<Term>& values;  // Value nodes.
  std::vector<Violation>& found;

  const Term& parameter() const { return constraint.terms.front(); }
  // Empty IRI: no single value is at fault.
  Violation& Report(const Term& value) const;
};

}  // namespace kg_core::shacl

#endif  // KG_CORE_SHACL_VALIDATION_H_
