// For benchmarks: a graph like that of a mission, as N-Triples.
//
// Per 100,000 triples: 6,000 waypoints with WKT, 8,600 edges between neighbours
// with costs, 2,000 assignments, and a provenance graph of 10,000 entities,
// each derived from one or two older ones. The same number gives the same text.

#ifndef KG_CORE_RDF_BENCH_GRAPH_H_
#define KG_CORE_RDF_BENCH_GRAPH_H_

#include <cstddef>
#include <functional>
#include <string>

namespace kg_core {

// Hands the text on in pieces of whole lines, about 100,000 triples each.
void WriteBenchGraph(std::size_t triples,
                     const std::function<void(const std::string&)>& write);

}  // namespace kg_core

#endif  // KG_CORE_RDF_BENCH_GRAPH_H_
