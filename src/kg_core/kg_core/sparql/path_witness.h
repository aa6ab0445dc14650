// Witness of a property path between two nodes: the triples along one
// connection, to be cited as the reason.
//
// The witness has the fewest steps of every '*', '+' and '?'; ties are broken
// by the fewest triples, then by the order of their terms. So it depends only
// on the graph, not on the order of term ids.

#ifndef KG_CORE_SPARQL_PATH_WITNESS_H_
#define KG_CORE_SPARQL_PATH_WITNESS_H_

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "kg_core/sparql/active_graph.h"
#include "kg_core/sparql/path_walker.h"
#include "kg_core/sparql/query.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core::sparql {

class PathWitness {
 public:
  PathWitness(const ActiveGraph* graph, const std::vector<TermId>* constants,
              QueryBudget* budget, const TermTable* terms)
      : graph_(graph),
        constants_(constants),
        budget_(budget),
        terms_(terms),
        walker_(graph, constants, budget) {}

  // nullopt if `path` does not connect the two; empty for a path of length
  // zero.
  std::optional<std::vector<Quad>> Find(const PropertyPath& path, TermId from,
                                        TermId to) const;

 private:
  using Way = std::vector<Quad>;
  using Ways = std::map<TermId, Way>;  // Best path to each node reached.

  std::optional<Way> FindLink(const Quad& wanted) const;
  std::optional<Way> FindSequence(const PropertyPath* parts, std::size_t count,
                                  TermId from, TermId to) const;
  std::optional<Way> FindNegated(const PropertyPath& path, TermId from,
                                 TermId to) const;
  std::optional<Way> FindClosure(const PropertyPath& path, TermId from,
                                 TermId to) const;
  Ways NextLayer(const PropertyPath& step, const Ways& layer) const;
  std::vector<TermId> Targets(const PropertyPath& path, TermId from) const;
  bool IsBetter(const Way& a, const Way& b) const;
  void Improve(std::optional<Way>* best, std::optional<Way> way) const;

  const ActiveGraph* graph_;
  const std::vector<TermId>* constants_;
  QueryBudget* budget_;
  const TermTable* terms_;
  PathWalker walker_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_PATH_WITNESS_H_
