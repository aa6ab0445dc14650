#include "kg_core/sparql/query_dataset.h"

#include "kg_core/rdf/namespaces.h"

namespace kg_core {

Dataset DefaultDataset(const std::optional<std::string>& plan_graph) {
  Dataset dataset;
  dataset.default_graphs = {kFactsGraph, kVocabGraph, kInferredGraph,
                            kProvGraph, kStateGraph};
  if (plan_graph) dataset.default_graphs.push_back(*plan_graph);
  return dataset;
}

}  // namespace kg_core
