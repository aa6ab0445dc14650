// Facts -> everything the planners and the selector need, for one world
// version, doing again only what changed.
//
// Every artifact has a hash of all that it is made of. Compile() works the
// hashes out first and reuses the artifact of the last compilation that has the
// same one: what is left is the dirty set.

#ifndef KG_COMPILER_MISSION_COMPILER_H_
#define KG_COMPILER_MISSION_COMPILER_H_

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "kg_compiler/data_plane.h"
#include "kg_compiler/mission_tensor.h"
#include "kg_compiler/seam_rules.h"
#include "kg_core/mission/ingest.h"
#include "kg_core/mission/mission.h"
#include "kg_core/raster/vector_field.h"

namespace kg_compiler {

struct WorkField {
  int window = 0;
  std::string iri;
  kg_core::VectorField field;
  std::string hash;
};

struct CoordinationRules {
  kg_core::CoordinationFacts facts;
  std::map<std::string, int> event_capacity;  // By event IRI.
};

// Which artifacts this compilation made anew.
struct DirtyArtifact {
  std::string kind;   // "tensor", "work_field", "seam_rules", "coordination".
  std::string agent;  // IRI, or empty.
  int window = -1;    // -1: all.
};

struct Compilation {
  std::uint64_t world_version = 0;
  kg_core::Mission mission;
  int first_window = 0;
  std::vector<std::shared_ptr<const WorkField>> fields;       // By window.
  std::vector<std::shared_ptr<const MissionTensor>> tensors;  // Agent, window.
  std::vector<SeamRules> rules;                               // By agent.
  CoordinationRules coordination;
  std::vector<DirtyArtifact> dirty;
  std::map<std::string, double> stage_seconds;  // "read", "fields", "tensors".
};

class MissionCompiler {
 public:
  explicit MissionCompiler(kg_core::FileCache* files);

  // Compiles windows >= first_window of `mission`. Throws InputError; then the
  // last compilation stays what it was.
  std::shared_ptr<const Compilation> Compile(const kg_core::Mission& mission,
                                             std::uint64_t world_version,
                                             int first_window);

 private:
  kg_core::FileCache* files_;
  std::shared_ptr<const Compilation> last_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_MISSION_COMPILER_H_
