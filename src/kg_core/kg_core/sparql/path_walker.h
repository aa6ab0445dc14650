// Property paths. https://www.w3.org/TR/sparql11-query/#propertypaths
//
// '*', '+' and '?' yield sets, by breadth-first search from the bound end; '/'
// and '|' keep duplicates.

#ifndef KG_CORE_SPARQL_PATH_WALKER_H_
#define KG_CORE_SPARQL_PATH_WALKER_H_

#include <cstddef>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/sparql/active_graph.h"
#include "kg_core/sparql/query.h"

namespace kg_core::sparql {

class PathWalker {
 public:
  using Visit = absl::FunctionRef<bool(TermId from, TermId to)>;

  // One end of a path. The ends of a step within a sequence are variables as
  // well, even where they are bound by the step before. Between two variables a
  // path of length zero connects nodes of the graph only, wherever the
  // variables got their values; a term of the query connects to itself.
  // https://www.w3.org/TR/sparql11-query/#defn_evalPP_ZeroOrOnePath
  struct End {
    TermId id = kNoTerm;   // kNoTerm: open.
    bool is_term = false;  // A term of the query, no variable.
  };

  // `constants` are the ids of the query's constants, indexed by their number.
  PathWalker(const ActiveGraph* graph, const std::vector<TermId>* constants,
             QueryBudget* budget)
      : graph_(graph), constants_(constants), budget_(budget) {}

  // Visits all pairs of nodes connected by `path`. Returns false if `visit` did
  // (stop).
  bool Walk(const PropertyPath& path, End from, End to, Visit visit) const;

 private:
  struct Ends {
    End from;
    End to;
  };

  TermId FindId(const PropertyPath& link) const {
    return (*constants_)[static_cast<std::size_t>(link.constant)];
  }
  bool WalkSequence(const PropertyPath* parts, std::size_t count, Ends ends,
                    Visit visit) const;
  bool WalkNegated(const PropertyPath& path, Ends ends, Visit visit) const;
  bool WalkClosure(const PropertyPath& path, Ends ends, Visit visit) const;
  // The nodes reached from `start`, each once, in order of discovery.
  std::vector<TermId> Reach(const PropertyPath& path, TermId start,
                            bool forward) const;

  const ActiveGraph* graph_;
  const std::vector<TermId>* constants_;
  QueryBudget* budget_;
};

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_PATH_WALKER_H_
