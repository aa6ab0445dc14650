// Cache of the planning for one agent between calls: its graphs, and within a
// window the arrival field and the flights of each place.
//
// The entry of a place is valid while its inputs are unchanged: the terms of
// its flights (WindowTraversal::Terms: motion, times, base travel, field,
// prices, hazard range), and the tensor's cells in the box that was read,
// compared bit by bit. Validity therefore does not depend on change
// notifications: a planner that receives another tensor can decide by itself.

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

// Numbers of items computed, and of items reused from the cache.
struct SeamCounts {
  int graphs = 0, graphs_kept = 0;    // Window graphs.
  int reaches = 0, reaches_kept = 0;  // Arrival fields of the graphs built.
  int flights = 0, flights_kept = 0;  // Flights, including infeasible ones.
  double seams_s = 0.0;  // Time spent on arrival fields and flights.
};

// Cached seams of one window. Immutable, shared between copies.
struct KeptSeams {
  using Place = std::pair<double, double>;  // Longitude, latitude [deg].
  // Arrival field of a place.
  struct Arrivals {
    ReachMap reach;
    // Cells where station can be held from arrival on.
    std::vector<int> landings;
    CellBox read;
    CellBox hazard;
  };
  struct Flown {
    std::shared_ptr<const FlownPath> flight;  // Null = infeasible.
    int idle = 0;  // Number of graphs built since its last use.
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

// Computes the seams of a window, reusing valid cache entries. Holds a
// reference to the traversal, which must outlive it.
class SeamFlyer {
 public:
  // `last` may be null.
  SeamFlyer(const WindowTraversal& traversal, const std::string& tensor_hash,
            const KeptSeams* last, SeamCounts* counts);

  // Indices of the cells reachable from a place at which station can be held
  // from arrival until the window ends; ascending.
  const std::vector<int>& Landings(kg_base::LonLat source);
  // Null = it cannot be flown.
  std::shared_ptr<const FlownPath> Fly(kg_base::LonLat source,
                                       kg_base::LonLat to);
  PickMemo* picks() { return &now_->picks; }

  // Returns all entries for the next call; entries not used for three graphs in
  // sequence are dropped. No other member may be called afterwards.
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
  NavGraphs graphs;  // Graphs of the last call.
  std::map<int, std::shared_ptr<const KeptSeams>> windows;  // By window index.
  SeamCounts counts;  // Counts of the last call.
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_SEAM_CACHE_H_
