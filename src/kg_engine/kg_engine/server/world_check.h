// Is what is held what compiling all facts anew gives? The proof, on a living
// world, that compiling only what a change made dirty loses nothing.

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
  bool ok = false;                   // Nothing differs.
  std::uint64_t world_version = 0;   // Of the facts.
  std::size_t compared = 0;          // Artifacts.
  std::vector<std::string> differs;  // Those that differ, by name.
  std::vector<std::string> errors;   // Why it could not be checked.
  double compile_s = 0.0;            // Compiling anew.
  double total_s = 0.0;
  std::string text;  // For a person.
};

// Of a running world: what its compiler holds (if facts have moved on since the
// last cycle, brought up to them as the next cycle will) against a compiler
// that begins with nothing. Bit by bit. Never throws for what the world says:
// that is in `errors`.
CheckAnswer CheckWorld(const Present& present, kg_mission::FileCache* files);

// Of a store that nobody runs: the tensors that its provenance graph says were
// made, against those that its facts give now, by their hashes (which are of
// all that a tensor is made of) and sources.
CheckAnswer CheckStore(const kg_core::GraphView& view,
                       kg_mission::FileCache* files);

}  // namespace kg_engine

#endif  // KG_ENGINE_SERVER_WORLD_CHECK_H_
