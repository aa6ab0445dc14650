// The strip between two neighbouring extremals during one step, and the time at
// which the front passes each place in it.
//
//   X(s, w) = (1-w) [(1-s) a0 + s b0] + w [(1-s) a1 + s b1]
//   t = begin + w length - y(s, w) / v
//
// in cell units; s from one extremal to the other, w from the step's begin to
// its end. The front is not the chord between the two: normals at its ends
// make it a cubic (Hermite), y ahead of the chord; v is its speed.

#ifndef KG_COMPILER_TRAVERSAL_SWEEP_H_
#define KG_COMPILER_TRAVERSAL_SWEEP_H_

#include <Eigen/Core>
#include <optional>

#include "kg_compiler/traversal/extremal.h"

namespace kg_compiler {

// An extremal during one step.
struct ExtremalStrand {
  ExtremalState begin, end;
  double heading_rad = 0.0;  // Heading at its root.
  bool dead = false;         // Ended in this step.
};

// A vector in cell units: x = columns, y = rows.
using CellOffset = Eigen::Vector2d;
inline double Cross(const CellOffset& a, const CellOffset& b) {
  return a.x() * b.y() - a.y() * b.x();
}
inline CellOffset PlaceOf(const ExtremalState& at) { return {at.col, at.row}; }
// The front's normal in cell units.
CellOffset NormalOf(const FlowSampler& flow, const ExtremalState& at);

// Midpoint of the front between two extremals, on a cubic through both that
// matches their normals; nullopt where the front is not smooth enough.
std::optional<ExtremalState> Halfway(const FlowSampler& flow,
                                     const ExtremalState& a,
                                     const ExtremalState& b);

class FrontSweep {
 public:
  FrontSweep(const FlowSampler& flow, const ExtremalStrand& a,
             const ExtremalStrand& b, double length_s);

  struct Share {
    double across = 0.0;  // s
    double along = 0.0;   // w
  };
  // Coordinates (s, w) of a place; nullopt if it is not in the strip.
  std::optional<Share> Find(const CellOffset& place) const;
  double Time_s(Share share) const;  // Seconds after the begin of the step.
  CellOffset BeginAt(double across) const { return a0_ + across * begin_edge_; }

  CellOffset low() const;  // Bounding box of the strip.
  CellOffset high() const;
  // Largest slope of the front against its chords, a measure of smoothness.
  double Slope() const;

 private:
  struct Bow {  // Deviation of the front from one chord.
    double length = 0.0, slope_a = 0.0, slope_b = 0.0;
    double Ahead(double s) const;
  };
  Bow BowOf(const CellOffset& chord, const CellOffset& normal_a,
            const CellOffset& normal_b) const;
  Share Refine(const CellOffset& place, Share share) const;

  CellOffset a0_, a1_, b0_, b1_;
  CellOffset begin_edge_, motion_, twist_;
  // Inverse determinants of the triangles on either side of the diagonal from
  // a0 to b1; 0 = none.
  double inverse_a_ = 0.0, inverse_b_ = 0.0;
  double length_s_;
  Bow begin_bow_, end_bow_;
  double s_per_cell_ = 0.0;  // 1 / v; 0 = no bow.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_SWEEP_H_
