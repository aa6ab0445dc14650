// Read-only view of the quads in one consistent state, with interned terms.
//
// A GraphView is the committed world of one version (Store::Read), the world as
// a transaction would leave it (Transaction::view), or a hypothetical one.
// Validation, queries, mission reading and compilation all read through this
// interface and do not depend on which of these it is.

#ifndef KG_CORE_RDF_GRAPH_VIEW_H_
#define KG_CORE_RDF_GRAPH_VIEW_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

// An interned term. Equal terms have equal ids within one view; in another view
// of the same store an id means the same term as long as a quad uses it
// (see store.h).
using TermId = std::uint32_t;
inline constexpr TermId kNoTerm = 0;  // No term; in a pattern: any term.

struct Quad {
  TermId subject = kNoTerm;
  TermId predicate = kNoTerm;
  TermId object = kNoTerm;
  TermId graph = kNoTerm;
};

inline bool operator==(const Quad& a, const Quad& b) {
  return a.subject == b.subject && a.predicate == b.predicate &&
         a.object == b.object && a.graph == b.graph;
}

class GraphView {
 public:
  virtual ~GraphView() = default;

  // The id of `term` if known in this view, else kNoTerm.
  virtual TermId Find(const Term& term) const = 0;
  // The term of an id obtained from this view.
  virtual const Term& Get(TermId id) const = 0;

  // Calls `visit` for every quad that matches (kNoTerm matches anything) until
  // it returns false. Quads are visited in the order of the index used, which
  // is deterministic.
  virtual void Match(const Quad& pattern,
                     absl::FunctionRef<bool(const Quad&)> visit) const = 0;
  // Number of matching quads, exact or an estimate; cheap. Used for join
  // ordering.
  virtual std::size_t Estimate(const Quad& pattern) const = 0;

  // The graphs with at least one quad, each once, in a deterministic order. A
  // store does one search per graph in its GSPO order; this default scans all
  // quads and is only meant for small views.
  virtual std::vector<TermId> Graphs() const;

  // Number of transactions on facts and vocabulary; monotonic.
  virtual std::uint64_t world_version() const = 0;
};

// Convenience look-ups in one graph (an IRI, e.g. kFactsGraph). A term unknown
// to the view matches nothing.
std::vector<Term> Objects(const GraphView& view, std::string_view graph,
                          const Term& subject, const Term& predicate);
std::vector<Term> Subjects(const GraphView& view, std::string_view graph,
                           const Term& predicate, const Term& object);
std::optional<Term> FirstObject(const GraphView& view, std::string_view graph,
                                const Term& subject, const Term& predicate);
bool Has(const GraphView& view, std::string_view graph, const Term& subject,
         const Term& predicate, const Term& object);

}  // namespace kg_core

#endif  // KG_CORE_RDF_GRAPH_VIEW_H_
