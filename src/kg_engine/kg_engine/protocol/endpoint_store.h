// The store behind a SPARQL endpoint, and its limits.

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

// Outcome of an update.
struct UpdateVerdict {
  enum class Outcome {
    kAccepted,  // Accepted and durable.
    kRefused,   // Rejected for `reasons`; no change.
    kNobody,    // No decision in time; no change.
  };
  Outcome outcome = Outcome::kNobody;
  std::vector<std::string> reasons{};
  std::uint64_t world_version = 0;
};

// The store behind an endpoint. All three functions may be called from several
// threads concurrently.
struct EndpointStore {
  std::function<std::shared_ptr<const kg_core::GraphView>()> read;
  std::function<kg_core::Dataset(const kg_core::GraphView&)> dataset;
  std::function<UpdateVerdict(const kg_core::FactUpdate&)> update;
};

struct EndpointOptions {
  std::string token;      // "Authorization: Bearer <token>"; "" = none.
  bool writable = false;  // Needs a token.
  kg_core::QueryLimits limits{};
  std::size_t body_bytes = 16u << 20;  // Maximum size of a request body.
};

}  // namespace kg_engine

#endif  // KG_ENGINE_PROTOCOL_ENDPOINT_STORE_H_
