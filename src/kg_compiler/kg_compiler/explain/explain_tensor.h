// Explains the value of a mission tensor: Eq. 1 at a cell, or summed over the
// cells of a footprint, in the order of the equation.
//
//   U = w N( max(0, V) M_soft ) M_hard,  N(y) = (y - low) / range in [0, 1]
//
//   contributions: each term of V over range; the change by the clamp at 0; the
//   reduction by each soft zone in force, in sequence; with `pre` and `horizon`
//   the reduction by w at this point; -low / range; the change by clamping N to
//   [0, 1]; with `post` the reduction by w; and for a forbidden cell the whole
//   remainder, attributed to the first constraint that forbids it (later ones
//   are listed with 0). With ex:softOverlap "min" a zone contributes only the
//   amount by which it lowers the minimum factor so far. With ex:paperLiteral
//   nothing is clamped and constraints remove the remainder before N.
//
// Terms from blend.h, constraints from masks.h, scale from BlendTensor(), i.e.
// the double-precision reference; the float32 tensor agrees with it to 1e-6.

#ifndef KG_COMPILER_EXPLAIN_EXPLAIN_TENSOR_H_
#define KG_COMPILER_EXPLAIN_EXPLAIN_TENSOR_H_

#include <string>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_compiler/explain/cited_facts.h"
#include "kg_compiler/explain/explanation.h"

namespace kg_compiler {

// Finds the inputs of a tensor in a compilation. Throws kg_base::InputError
// that lists the existing windows if there is no such tensor.
TensorInputs FindTensorInputs(const Compilation& compilation,
                              const kg_mission::Agent& agent, int window);
const MissionTensor& FindTensor(const Compilation& compilation,
                                const kg_mission::Agent& agent, int window);

class TensorExplainer {
 public:
  // Keeps pointers into `inputs` and a reference to `facts`.
  TensorExplainer(const TensorInputs& inputs, const CitedFacts& facts);

  // Explains U at a cell.
  Explanation ExplainCell(kg_base::Cell cell) const;
  // Explains the sum of U over cells (grid indices), i.e. a waypoint's score.
  // Throws kg_base::InputError for a cell off the grid.
  Explanation ExplainSum(const std::vector<int>& cells) const;

 private:
  struct Zone {
    ActiveConstraint constraint;
    kg_base::Mask inside;
  };
  // Description of a contribution without its value, in output order.
  struct Part {
    std::string term;
    std::string text;
    Facts facts;
    bool is_kept = false;  // Listed even if 0.
  };
  void AddTerms(const ActiveFacts& active);
  void AddZones(const ActiveFacts& active);
  void DescribeParts();
  void Describe(const BlendTerm& term);
  void DescribeSoft(const Zone& zone);
  void DescribeScale();
  void DescribeHard();
  Part ConfidencePart() const;
  // Adds the parts' values at a cell to `values`; their sum is U there.
  void Evaluate(std::size_t cell, std::vector<double>* values) const;
  void Forbid(std::size_t cell, double value, double* parts) const;
  Explanation Collect(const std::vector<double>& values) const;

  TensorInputs in_;
  const CitedFacts& facts_;
  double scale_ = 1.0;  // 1 / range; 1 if the field is 0 everywhere.
  TensorBlend made_;
  std::vector<BlendTerm> terms_;
  std::vector<std::vector<double>> term_values_;  // [term][cell].
  std::vector<Zone> soft_;
  std::vector<Zone> hard_;
  std::vector<Part> parts_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLAIN_TENSOR_H_
