// What a reader sees of the quads: one consistent state, by interned terms.
//
// A GraphView is the committed world of one version (Store::Read), the world
// as a transaction would leave it (Transaction::view), or a hypothetical one.
// Validation, queries, mission reading and compilation all read through it and
// cannot tell which it is.

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
// (store.h says why).
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

  // The id of a term this view knows, else kNoTerm.
  virtual TermId Find(const Term& term) const = 0;
  // The term of an id that came from this view.
  virtual const Term& Get(TermId id) const = 0;

  // Calls `visit` for every quad that matches (kNoTerm matches anything) until
  // it returns false. Order is that of the index used, the same every time.
  virtual void Match(const Quad& pattern,
                     absl::FunctionRef<bool(const Quad&)> visit) const = 0;
  // How many quads match, at least roughly; cheap. For join ordering.
  virtual std::size_t Estimate(const Quad& pattern) const = 0;

  // The graphs that have a quad, each once, the same order every time. A store
  // searches its GSPO order once for each; only views of a few quads may scan.
  virtual std::vector<TermId> Graphs() const;

  // Counts transactions on facts and vocabulary; never goes back.
  virtual std::uint64_t world_version() const = 0;
};

// Conveniences over one graph (an IRI, e.g. kFactsGraph); a missing term simply
// matches nothing.
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
