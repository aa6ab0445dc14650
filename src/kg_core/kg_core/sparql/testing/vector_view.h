// A GraphView over a plain list of quads, for tests: every look-up is a linear
// scan, simple enough to serve as reference.

#ifndef KG_CORE_SPARQL_TESTING_VECTOR_VIEW_H_
#define KG_CORE_SPARQL_TESTING_VECTOR_VIEW_H_

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"

namespace kg_core {

class VectorView : public GraphView {
 public:
  TermId Intern(const Term& term) {
    const auto next = static_cast<TermId>(terms_.size() + 1);
    const auto [found, is_new] = ids_.emplace(term, next);
    if (is_new) terms_.push_back(term);
    return found->second;
  }
  // Adds a quad unless present.
  void Add(const Term& subject, const Term& predicate, const Term& object,
           const Term& graph) {
    const Quad quad{Intern(subject), Intern(predicate), Intern(object),
                    Intern(graph)};
    for (const Quad& known : quads_) {
      if (known == quad) return;
    }
    quads_.push_back(quad);
  }
  const std::vector<Quad>& quads() const { return quads_; }

  TermId Find(const Term& term) const override {
    const auto found = ids_.find(term);
    return found == ids_.end() ? kNoTerm : found->second;
  }
  const Term& Get(TermId id) const override { return terms_.at(id - 1); }
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const override {
    for (const Quad& quad : quads_) {
      if (Fits(quad, pattern) && !visit(quad)) return;
    }
  }
  std::size_t Estimate(const Quad& pattern) const override {
    std::size_t count = 0;
    for (const Quad& quad : quads_) count += Fits(quad, pattern) ? 1 : 0;
    return count;
  }
  std::uint64_t world_version() const override { return 1; }

 private:
  static bool Fits(const Quad& quad, const Quad& pattern) {
    const auto fits = [](TermId id, TermId wanted) {
      return wanted == kNoTerm || id == wanted;
    };
    return fits(quad.subject, pattern.subject) &&
           fits(quad.predicate, pattern.predicate) &&
           fits(quad.object, pattern.object) && fits(quad.graph, pattern.graph);
  }

  std::vector<Term> terms_;
  std::map<Term, TermId> ids_;
  std::vector<Quad> quads_;
};

}  // namespace kg_core

#endif  // KG_CORE_SPARQL_TESTING_VECTOR_VIEW_H_
