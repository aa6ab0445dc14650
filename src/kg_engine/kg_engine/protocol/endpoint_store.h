// What a SPARQL endpoint answers from, and within which limits.

#ifndef KG_ENGINE_PROTOCOL_ENDPOINT_STORE_H_
#define KG_ENGINE_PROTOCOL_ENDPOINT_STORE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "kg_core/facts/fact_update.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/sparql/limits.h"
#include "kg_core/sparql/query_dataset.h"

namespace kg_engine {

// What became of an update.
struct UpdateVerdict {
  enum class Outcome {
    kAccepted,  // Durable.
    kRefused,   // For `reasons`; nothing has changed.
    kNobody,    // No decision in time; nothing has changed.
  };
  Outcome outcome = Outcome::kNobody;
  std::vector<std::string> reasons{};
  std::uint64_t world_version = 0;
};

// The store behind an endpoint. All three may be called from several threads at
// once.
struct EndpointStore {
  std::function<std::shared_ptr<const kg_core::GraphView>()> read;
  std::function<kg_core::Dataset(const kg_core::GraphView&)> dataset;
  std::function<UpdateVerdict(const kg_core::FactUpdate&)> update;
};

struct EndpointOptions {
  std::string token;      // "Authorization: Bearer <token>"; "": none is asked.
  bool writable = false;  // Needs a token.
  kg_core::QueryLimits limits{};
  std::size_t body_bytes = 16u << 20;  // Of a request.
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_ENDPOINT_STORE_H_
