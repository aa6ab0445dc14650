// The fan of extremals from a departure, advanced in common steps of time and
// painted to the earliest arrival at each cell centre.
//
// Neighbours that part, or whose front bends, get another between them; those
// that come too late everywhere around are dropped, as are those closer than
// needed. An extremal ends on what is closed and at the grid's edge. Where one
// passes a corner of what is closed, or grazes its edge, a fan of its own sets
// out into the shadow, in order of time, as often as needed.

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
  explicit ExtremalFan(const VoyageRequest& voyage);  // Must outlive it.
  ReachMap Run();

 private:
  struct Ray {
    ExtremalState at;
    double heading_rad;
    int root;
    bool linked;  // The next in the list is its neighbour.
  };
  // A place from which a fan of its own may set out.
  struct Restart {
    double time_s;
    kg_base::GridPoint place;
    int root;            // From which it is reached,
    double heading_rad;  // leaving it so (give or take the spread),
    double spread_rad;
    double arriving_rad;  // and arriving so.
    int side;             // Of the shadow: 1 = left of the heading, -1 = right.
    int key;              // Of the corner; -1 = none.
  };
  struct Graze {
    Restart restart;
    kg_base::Cell shadow;  // Not reached yet if there is a shadow.
  };
  // A chain of extremals of one root being advanced by one step.
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
  // The extremal half way in heading, from its root on, at a stride's begin.
  ExtremalState Replay(int root, double heading_rad) const;
  std::optional<ExtremalState> Insert(const Stride& stride,
                                      const ExtremalStrand& a,
                                      const ExtremalStrand& b) const;
  // What lies between two neighbours: more of them where needed, else painted.
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
  std::vector<ExtremalStepper::Step> steps_;  // So far.
  struct FirstStep {
    ExtremalStepper::Step step;  // From the root's time to the next common one.
    std::size_t next;            // Of steps_.
  };
  std::vector<FirstStep> first_steps_;  // By root, but for the departure.
  double margin_s_ = 0.0;               // By which a ray may be late and live.
  double fastest_ = 1e-9;               // [cells/s], in the last step.
  std::vector<Ray> rays_, next_;
  std::vector<Restart> restarts_;  // Found in this step, not yet begun.
  std::vector<Graze> grazes_;
  std::unordered_set<int> rounded_;  // Corners, by key.
  // Of all places looked at.
  CellOffset low_ = CellOffset::Zero(), high_ = CellOffset::Zero();
  ReachMap reach_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_TRAVERSAL_FAN_H_
