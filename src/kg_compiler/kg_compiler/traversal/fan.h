// The fan of extremals from a departure, advanced in common time steps and
// rasterised to the earliest arrival at each cell centre.
//
// A ray is inserted between neighbours that diverge or whose front bends; rays
// that are late at all surrounding centres are dropped, as are rays closer than
// needed. An extremal ends at closed cells and at the edge of the grid. Where
// one passes a corner of a closed region, or grazes its edge, a new fan starts
// into the shadow, in order of time, repeatedly if needed. The fan ends at the
// deadline, or earlier if the rays circle for far more steps than would cover
// the grid: what they would still reach is not reached.

#ifndef KG_COMPILER_TRAVERSAL_FAN_H_
#define KG_COMPILER_TRAVERSAL_FAN_H_

#include <unordered_set>
#include <vector>

#include "kg_compiler/traversal/arrivals.h"
#include "kg_compiler/traversal/extremal.h"
#include "kg_compiler/traversal/reach.h"
#include "kg_compiler/traversal/sight.h"
#include "kg_compiler/traversal/sweep.h"
#include "kg_compiler/traversal/voyage.h"

namespace kg_compiler {

class ExtremalFan {
 public:
  explicit ExtremalFan(const VoyageRequest& voyage);  // Kept by reference.
  ReachMap Run();

 private:
  struct Ray {
    ExtremalState at;
    double heading_rad;
    int root;
    bool linked;  // The next ray in the list is its neighbour.
  };
  // A place from which a new fan may start.
  struct Restart {
    double time_s;
    kg_base::GridPoint place;
    int root;            // Root of the extremal that reaches the place.
    double heading_rad;  // At that root, +- spread_rad.
    double spread_rad;
    double arriving_rad;  // Heading on arrival at the place.
    int side;  // Side of the shadow: 1 = left of the heading, -1 = right.
    int key;   // Corner, 4 * cell index + diagonal; -1 = none (graze).
  };
  struct Graze {
    Restart restart;
    kg_base::Cell shadow;  // Cell not reached yet if there is a shadow.
  };
  // One time step of a chain of extremals that share a root.
  struct Stride {
    const ExtremalStepper::Step* step;
    double begin_s;
    int root;
  };

  bool Begin();
  double StepLength_s() const;
  void Advance(double length_s);
  void AdvanceChain(const Stride& stride, const std::vector<Ray>& rays,
                    std::size_t first);
  ExtremalStrand Advance(const Stride& stride, const ExtremalState& from,
                         double heading_rad);
  // Integrates the extremal that left `root` at a heading, up to the begin of
  // the current step.
  ExtremalState Replay(int root, double heading_rad) const;
  std::optional<ExtremalState> Insert(const Stride& stride,
                                      const ExtremalStrand& a,
                                      const ExtremalStrand& b) const;
  // Handles the strip between two neighbours: inserts rays where they are too
  // far apart, otherwise rasterises it.
  void Between(const Stride& stride, const ExtremalStrand& a,
               const ExtremalStrand& b, int depth);
  bool IsWide(const ExtremalStrand& a, const ExtremalStrand& b,
              const FrontSweep& sweep);
  void Paint(const Stride& stride, const ExtremalStrand& a,
             const ExtremalStrand& b, const FrontSweep& sweep);
  bool NearClosed(kg_base::Cell low, kg_base::Cell high);
  void PaintCell(const Stride& stride, const ExtremalStrand& a,
                 const ExtremalStrand& b, const FrontSweep& sweep,
                 kg_base::Cell cell, bool near_closed);
  void FindCorners(const Stride& stride, const ExtremalStrand& a,
                   const ExtremalStrand& b, const FrontSweep& sweep,
                   kg_base::Cell cell);
  void FindCornersBeside(const Stride& stride, const ExtremalStrand& strand);
  void AddCorner(const Stride& stride, Restart found, const CellOffset& from,
                 const ExtremalStrand& near);
  void FindGraze(const Stride& stride, const ExtremalStrand& alive,
                 const ExtremalStrand& dead);
  void Keep(const Stride& stride, const ExtremalStrand& strand);
  std::vector<Ray> ShadowRays(const Restart& restart);
  void Restarts(double end_s);
  bool IsLate(const ExtremalState& at) const;
  bool IsThin(const ExtremalState& a, const ExtremalState& b) const;
  void Thin();
  void Touch(const CellOffset& at);
  CellBox ReadBox() const;

  const VoyageRequest& voyage_;
  FlowSampler flow_;
  ExtremalStepper helm_;
  const kg_base::Grid& grid_;
  LineOfSight sight_;
  ArrivalTiles arrivals_;
  double latest_s_;
  double now_s_ = 0.0;
  std::size_t work_ = 0;  // Steps of single rays completed so far.
  std::vector<ExtremalStepper::Step> steps_;  // Common steps completed so far.
  struct FirstStep {
    // From the root's time to the next common time.
    ExtremalStepper::Step step;
    std::size_t next;  // Index into steps_ of the step that follows.
  };
  // Indexed by root - 1 (no entry for the departure).
  std::vector<FirstStep> first_steps_;
  double margin_s_ = 0.0;  // Delay at which a ray is still kept.
  double fastest_ = 1e-9;  // Largest speed in the last step [cells/s].
  std::vector<Ray> rays_, next_;
  std::vector<Restart> restarts_;  // Found in this step, not yet started.
  std::vector<Graze> grazes_;
  // Keys of the corners already used as roots.
  std::unordered_set<int> rounded_;
  // Bounding box of all positions visited, in cell units.
  CellOffset low_ = CellOffset::Zero(), high_ = CellOffset::Zero();
  ReachMap reach_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_FAN_H_
