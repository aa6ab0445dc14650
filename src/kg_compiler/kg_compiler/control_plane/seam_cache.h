// What planning for one agent keeps from one time to the next: its graphs, and
// within a window the arrival field and the flights of each place.
//
// What is kept of a place is valid while nothing changed that was read to make
// it: the terms it was flown on (WindowTraversal::Terms: motion, times, base
// travel, field, prices, hazard range), and the tensor's cells in the box that
// was read, compared bit by bit. So it does not matter who says what changed,
// or if anybody does: a planner that is sent another tensor knows as much as
// the knowledge graph.

#ifndef KG_COMPILER_CONTROL_PLANE_SEAM_CACHE_H_
#define KG_COMPILER_CONTROL_PLANE_SEAM_CACHE_H_

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "kg_compiler/control_plane/cropped_recurrence.h"
#include "kg_compiler/control_plane/nav_graphs.h"
#include "kg_compiler/control_plane/window_surface.h"
#include "kg_compiler/control_plane/window_traversal.h"

namespace kg_compiler {

// How much was done, and how much taken over.
struct SeamCounts {
  int graphs = 0, graphs_kept = 0;    // Of windows.
  int reaches = 0, reaches_kept = 0;  // Arrival fields, of the graphs built.
  int flights = 0, flights_kept = 0;  // Likewise; those refused included.
  double seams_s = 0.0;               // Spent on arrival fields and flights.
};

// The seams of one window, as they were kept. Immutable: copies share it.
struct KeptSeams {
  using Place = std::pair<double, double>;  // Longitude, latitude [deg].
  // What a place's arrival field gives.
  struct Arrivals {
    ReachMap reach;
    std::vector<int> landings;  // Cells one can be at and hold from arrival on.
    CellBox read;
    CellBox hazard;
  };
  struct Flown {
    std::shared_ptr<const FlownPath> flight;  // Null = it cannot be flown.
    int idle = 0;                             // Graphs since it was asked for.
  };
  struct Source {
    std::shared_ptr<const Arrivals> arrivals;
    std::map<Place, Flown> flights;
    int idle = 0;
  };

  std::string terms;
  std::string tensor_hash;
  SurfacePatch patch;  // Covers the sources' boxes.
  std::map<Place, Source> sources;
  PickMemo picks;
};

// Works a window's seams out, from what is kept of them where that holds. Holds
// a reference to the traversal, which must outlive it.
class SeamFlyer {
 public:
  // `last` may be null.
  SeamFlyer(const WindowTraversal& traversal, const std::string& tensor_hash,
            const KeptSeams* last, SeamCounts* counts);

  // Cells that one can be at coming from a place, holding station there from
  // arrival until the window ends; ascending.
  const std::vector<int>& Landings(kg_base::LonLat source);
  // Null = it cannot be flown.
  std::shared_ptr<const FlownPath> Fly(kg_base::LonLat source,
                                       kg_base::LonLat to);
  PickMemo* picks() { return &now_->picks; }

  // All of it, for the next time; what was not asked for three times is let go.
  // Nothing may be asked after it.
  std::shared_ptr<const KeptSeams> Keep();

 private:
  void TakeOver(const KeptSeams& last, bool same_tensor);
  KeptSeams::Source& SourceAt(kg_base::LonLat place);
  std::shared_ptr<const KeptSeams::Arrivals> Arrive(
      kg_base::LonLat source) const;

  const WindowTraversal& traversal_;
  SeamCounts* counts_;
  std::shared_ptr<KeptSeams> now_;
};

struct SeamCache {
  NavGraphs graphs;                                         // The last ones.
  std::map<int, std::shared_ptr<const KeptSeams>> windows;  // By index.
  SeamCounts counts;                                        // Of the last time.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_CACHE_H_
