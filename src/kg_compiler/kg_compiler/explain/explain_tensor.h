// Why a mission tensor has the value it has: Eq. 1 at a cell, or summed over
// the cells of a footprint, in the order of the equation.
//
//   U = w N( max(0, V) M_soft ) M_hard,  N(y) = (y - low) / range in [0, 1]
//
//   contributions: each term of V over range; what the clamp at 0 adds; what
//   each soft zone in force takes off, one after the other; with `pre` and
//   `horizon` what w takes off here; -low / range; what holding N in [0, 1]
//   changes; with `post` what w takes off; and for a forbidden cell all that is
//   left, taken off by the first constraint that forbids it (those after it
//   are listed with 0). With ex:softOverlap "min" a zone takes off what it
//   lowers the least factor so far by. With ex:paperLiteral nothing is clamped
//   and constraints take off what is left before N.
//
// The terms are those of blend.h, the constraints those of masks.h, the scale
// that of BlendTensor(): the reference, in double precision, that the tensor's
// float32 agrees with to 1e-6.

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

// Of a compilation. Throws kg_core::InputError if it has no such tensor, saying
// which windows there are.
TensorInputs FindTensorInputs(const Compilation& compilation,
                              const kg_mission::Agent& agent, int window);
const MissionTensor& FindTensor(const Compilation& compilation,
                                const kg_mission::Agent& agent, int window);

class TensorExplainer {
 public:
  // Keeps pointers into `inputs` and a reference to `facts`.
  TensorExplainer(const TensorInputs& inputs, const CitedFacts& facts);

  // U at the cell.
  Explanation ExplainCell(kg_base::Cell cell) const;
  // The contributions to the sum of U over cells (indices of the grid): a
  // waypoint's score. Throws kg_core::InputError for a cell off the grid.
  Explanation ExplainSum(const std::vector<int>& cells) const;

 private:
  struct Zone {
    ActiveConstraint constraint;
    kg_base::Mask inside;
  };
  // What a contribution is before it has a value; parts come in this order.
  struct Part {
    std::string term;
    std::string text;
    Facts facts;
    bool is_kept = false;  // Also where it is 0.
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
  std::vector<std::vector<double>> term_values_;  // By term, by cell.
  std::vector<Zone> soft_;
  std::vector<Zone> hard_;
  std::vector<Part> parts_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_EXPLAIN_TENSOR_H_
