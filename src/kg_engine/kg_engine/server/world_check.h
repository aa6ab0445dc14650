// Checks incremental compilation on a running world: the held artifacts must
// equal those of a full compilation of all facts.

#ifndef KG_ENGINE_SERVER_WORLD_CHECK_H_
#define KG_ENGINE_SERVER_WORLD_CHECK_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_engine/state/start_state.h"
#include "kg_mission/mission/ingest.h"

namespace kg_engine {

struct CheckAnswer {
  bool ok = false;                   // No difference.
  std::uint64_t world_version = 0;   // Version of the facts.
  std::size_t compared = 0;          // Number of artifacts compared.
  std::vector<std::string> differs;  // Names of differing artifacts.
  std::vector<std::string> errors;   // Why the check failed.
  double compile_s = 0.0;            // Full compilation [s].
  double total_s = 0.0;
  std::string text;  // Display text.
};

// Checks a running world: its compiler's artifacts (updated to the current
// facts as the next cycle would) against a fresh compiler, bitwise. Never
// throws for errors in the world: they are in `errors`.
CheckAnswer CheckWorld(const Present& present, kg_mission::FileCache* files);

// Checks a store that is not in use: the tensors recorded in its provenance
// graph against those compiled from its facts, by hashes (over all inputs of a
// tensor) and sources.
CheckAnswer CheckStore(const kg_core::GraphView& view,
                       kg_mission::FileCache* files);

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_WORLD_CHECK_H_
