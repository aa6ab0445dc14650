// Compiles facts into all inputs of the planners and the selector, for one
// world version, recomputing only what changed.
//
// Every artifact has a hash of all its inputs. Compile() computes the hashes
// first and reuses artifacts of the last compilation with equal hashes; the
// others are the dirty set. Tensors with equal hashes are compiled once, even
// for different agents; distinct ones are compiled in parallel, with results
// independent of other tensors and of the order.

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
  // The windows in which an event gives reward; empty = it is over.
  std::map<std::string, std::set<int>> event_windows;
};

// An artifact that this compilation recomputed.
struct DirtyArtifact {
  std::string kind;   // "tensor", "work_field", "seam_rules", "coordination".
  std::string agent;  // IRI, or empty.
  int window = -1;    // -1: all, or not specific to one window.
  // Tensors only: the cells affected by the changed facts (dirty_box.h);
  // nullopt: any cell.
  std::optional<CellBox> box = std::nullopt;
};
// Compares all members except the box.
bool operator==(const DirtyArtifact& a, const DirtyArtifact& b);

// Numbers of tensors and of those compiled.
struct TensorCounts {
  std::size_t tensors = 0;   // Agents times windows.
  std::size_t distinct = 0;  // Distinct hashes.
  std::size_t compiled = 0;  // Distinct ones not reused.
};

struct Compilation {
  std::uint64_t world_version = 0;
  kg_mission::Mission mission;
  int first_window = 0;
  std::vector<std::shared_ptr<const WorkField>> fields;  // By window.
  // Sorted by agent, then window.
  std::vector<std::shared_ptr<const MissionTensor>> tensors;
  // Rasters each tensor was compiled from, in the order of `tensors`.
  std::vector<std::shared_ptr<const WindowRasters>> rasters;
  // Common scale of all windows, by agent IRI; only agents in mode `horizon`.
  std::map<std::string, HorizonScale> horizons;
  std::vector<SeamRules> rules;  // By agent.
  CoordinationRules coordination;
  std::vector<DirtyArtifact> dirty;
  TensorCounts counts;
  // Stages: "fields" and "read" (value layers), from files unless cached;
  // "tensors"; "rules".
  std::map<std::string, double> stage_seconds;
};

// A copy shares the results so far and is independent from then on; it may be
// used by another thread.
class MissionCompiler {
 public:
  explicit MissionCompiler(kg_mission::FileCache* files);
  explicit MissionCompiler(RasterReaders readers);

  // Compiles windows >= first_window of `mission`. Throws InputError; the last
  // compilation is then unchanged. An artifact is dirty if its hash differs
  // from that in the last compilation, for the same agent and window.
  std::shared_ptr<const Compilation> Compile(const kg_mission::Mission& mission,
                                             std::uint64_t world_version,
                                             int first_window);

 private:
  RasterStore rasters_;
  std::shared_ptr<const Compilation> last_;
  // Results of MeasureHorizon, by the hash of its inputs.
  std::map<std::string, ValueNormaliser> horizons_;
  std::shared_ptr<DataPlaneCache> cache_ = std::make_shared<DataPlaneCache>();
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_COMPILE_MISSION_COMPILER_H_
