#include "kg_core/rdf/graph_view.h"

#include <string>

#include "absl/container/flat_hash_set.h"

namespace kg_core {

std::vector<TermId> GraphView::Graphs() const {
  std::vector<TermId> graphs;
  absl::flat_hash_set<TermId> seen;
  Match({}, [&](const Quad& quad) {
    if (seen.insert(quad.graph).second) graphs.push_back(quad.graph);
    return true;
  });
  return graphs;
}
namespace {

// One of the four components of a quad.
using Place = TermId Quad::*;

struct PatternQuery {
  const Term* subject = nullptr;  // Null matches any term.
  const Term* predicate = nullptr;
  const Term* object = nullptr;
};

// Resolves the pattern's terms to ids; nullopt if one is unknown to the view,
// in which case nothing can match.
std::optional<Quad> MakePattern(const GraphView& view, std::string_view graph,
                                const PatternQuery& question) {
  Quad pattern;
  pattern.graph = view.Find(Iri(std::string(graph)));
  if (pattern.graph == kNoTerm) return std::nullopt;
  const auto fill = [&](const Term* term, Place place) {
    if (term == nullptr) return true;
    pattern.*place = view.Find(*term);
    return pattern.*place != kNoTerm;
  };
  const bool known = fill(question.subject, &Quad::subject) &&
                     fill(question.predicate, &Quad::predicate) &&
                     fill(question.object, &Quad::object);
  if (!known) return std::nullopt;
  return pattern;
}

std::vector<Term> Collect(const GraphView& view, const Quad& pattern,
                          Place place, std::size_t limit) {
  std::vector<Term> terms;
  view.Match(pattern, [&](const Quad& quad) {
    terms.push_back(view.Get(quad.*place));
    return terms.size() < limit;
  });
  return terms;
}

}  // namespace

std::vector<Term> Objects(const GraphView& view, std::string_view graph,
                          const Term& subject, const Term& predicate) {
  const auto pattern =
      MakePattern(view, graph, {&subject, &predicate, nullptr});
  if (!pattern) return {};
  return Collect(view, *pattern, &Quad::object, SIZE_MAX);
}

std::vector<Term> Subjects(const GraphView& view, std::string_view graph,
                           const Term& predicate, const Term& object) {
  const auto pattern = MakePattern(view, graph, {nullptr, &predicate, &object});
  if (!pattern) return {};
  return Collect(view, *pattern, &Quad::subject, SIZE_MAX);
}

std::optional<Term> FirstObject(const GraphView& view, std::string_view graph,
                                const Term& subject, const Term& predicate) {
  const auto pattern =
      MakePattern(view, graph, {&subject, &predicate, nullptr});
  if (!pattern) return std::nullopt;
  std::vector<Term> terms = Collect(view, *pattern, &Quad::object, 1);
  if (terms.empty()) return std::nullopt;
  return std::move(terms[0]);
}

bool Has(const GraphView& view, std::string_view graph, const Term& subject,
         const Term& predicate, const Term& object) {
  const auto pattern =
      MakePattern(view, graph, {&subject, &predicate, &object});
  return pattern && !Collect(view, *pattern, &Quad::object, 1).empty();
}

}  // namespace kg_core
