#include "kg_core/sparql/resolve_dataset.h"

#include <algorithm>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core::sparql {
namespace {

bool HasQuads(const GraphView& view, TermId graph) {
  bool found = false;
  view.Match({kNoTerm, kNoTerm, kNoTerm, graph}, [&found](const Quad&) {
    found = true;
    return false;
  });
  return found;
}

std::vector<TermId> CollectIds(const std::vector<std::string>& graphs,
                               TermTable* terms) {
  std::vector<TermId> ids;
  for (const std::string& graph : graphs) {
    const TermId id = terms->Intern(Iri(graph));
    if (std::find(ids.begin(), ids.end(), id) == ids.end()) ids.push_back(id);
  }
  return ids;
}

}  // namespace

bool HasGraph(const GraphView& view, const std::string& iri) {
  for (const char* ours : {kFactsGraph, kVocabGraph, kInferredGraph, kProvGraph,
                           kLogGraph, kStateGraph}) {
    if (iri == ours) return true;
  }
  const TermId id = view.Find(Iri(iri));
  return id != kNoTerm && HasQuads(view, id);
}

void CheckDataset(const GraphView& view, const Query& query) {
  for (const auto* graphs : {&query.from, &query.from_named}) {
    for (const std::string& graph : *graphs) {
      if (HasGraph(view, graph)) continue;
      throw kg_base::InputError("FROM: the store has no graph " +
                                AbbreviateIri(graph));
    }
  }
}

DatasetIds Resolve(const Query& query, const Dataset& dataset,
                   TermTable* terms) {
  DatasetIds ids;
  if (query.has_dataset) {
    ids.default_graphs = CollectIds(query.from, terms);
    ids.named_graphs = CollectIds(query.from_named, terms);
    return ids;
  }
  ids.default_graphs = CollectIds(dataset.default_graphs, terms);
  if (dataset.named_graphs) {
    ids.named_graphs = CollectIds(*dataset.named_graphs, terms);
  }
  if (!dataset.unnamed_graph.empty()) {
    ids.unnamed_graph = terms->Intern(Iri(dataset.unnamed_graph));
  }
  return ids;
}

}  // namespace kg_core::sparql
