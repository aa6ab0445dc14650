// Facts -> everything the planners and the selector need, for one world
// version, doing again only what changed.
//
// Every artifact has a hash of all that it is made of. Compile() works the
// hashes out first and reuses the artifact of the last compilation that has the
// same one: what is left is the dirty set. Tensors of one hash are compiled
// once, whoever's they are; those that differ, side by side on the machine's
// cores, each the same whatever else is compiled and in which order.

#ifndef KG_COMPILER_COMPILE_MISSION_COMPILER_H_
#define KG_COMPILER_COMPILE_MISSION_COMPILER_H_

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "kg_compiler/compile/raster_store.h"
#include "kg_compiler/control_plane/seam_rules.h"
#include "kg_compiler/data_plane/cell_box.h"
#include "kg_compiler/data_plane/data_plane.h"
#include "kg_compiler/data_plane/data_plane_cache.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

struct CoordinationRules {
  kg_mission::CoordinationFacts facts;
  std::map<std::string, int> event_capacity;  // By event IRI.
  // The windows in which an event rewards; none = it is over.
  std::map<std::string, std::set<int>> event_windows;
};

// Which artifacts this compilation made anew.
struct DirtyArtifact {
  std::string kind;   // "tensor", "work_field", "seam_rules", "coordination".
  std::string agent;  // IRI, or empty.
  int window = -1;    // -1: all, or what is not of one window.
  // Of a tensor: the cells that the changed facts speak of (dirty_box.h).
  // Nothing: any cell.
  std::optional<CellBox> box = std::nullopt;
};
// But for the box.
bool operator==(const DirtyArtifact& a, const DirtyArtifact& b);

// How many tensors there are, and what they took.
struct TensorCounts {
  std::size_t tensors = 0;   // Agents times windows.
  std::size_t distinct = 0;  // By what they are made of.
  std::size_t compiled = 0;  // Of these: not there from the last time.
};

struct Compilation {
  std::uint64_t world_version = 0;
  kg_mission::Mission mission;
  int first_window = 0;
  std::vector<std::shared_ptr<const WorkField>> fields;       // By window.
  std::vector<std::shared_ptr<const MissionTensor>> tensors;  // Agent, window.
  // What each tensor was made from; in their order.
  std::vector<std::shared_ptr<const WindowRasters>> rasters;
  std::map<std::string, HorizonScale> horizons;  // By agent IRI, of `horizon`.
  std::vector<SeamRules> rules;                  // By agent.
  CoordinationRules coordination;
  std::vector<DirtyArtifact> dirty;
  TensorCounts counts;
  // "fields" and "read" (value layers): from files, where not read before;
  // "tensors"; "rules".
  std::map<std::string, double> stage_seconds;
};

// A copy shares what has been made so far and goes its own way from there; it
// may be used by another thread.
class MissionCompiler {
 public:
  explicit MissionCompiler(kg_mission::FileCache* files);
  explicit MissionCompiler(RasterReaders readers);

  // Compiles windows >= first_window of `mission`. Throws InputError; then the
  // last compilation stays what it was. An artifact is dirty if its hash is not
  // the one it had in the last compilation, for the same agent and window.
  std::shared_ptr<const Compilation> Compile(const kg_mission::Mission& mission,
                                             std::uint64_t world_version,
                                             int first_window);

 private:
  RasterStore rasters_;
  std::shared_ptr<const Compilation> last_;
  // What MeasureHorizon found, by what it measured.
  std::map<std::string, ValueNormaliser> horizons_;
  std::shared_ptr<DataPlaneCache> cache_ = std::make_shared<DataPlaneCache>();
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_MISSION_COMPILER_H_
