// Scope guard for the triples matched by the solution in progress
// (Evaluator::Trace).

#ifndef KG_CORE_SPARQL_MATCHED_SCOPE_H_
#define KG_CORE_SPARQL_MATCHED_SCOPE_H_

#include <cstddef>
#include <vector>

#include "kg_core/rdf/graph_view.h"

namespace kg_core::sparql {

// On destruction removes the triples added during its lifetime. Does nothing
// without a trace (null).
class MatchedScope {
 public:
  explicit MatchedScope(std::vector<Quad>* matched)
      : matched_(matched), before_(matched == nullptr ? 0 : matched->size()) {}
  ~MatchedScope() {
    if (matched_ != nullptr) matched_->resize(before_);
  }
  MatchedScope(const MatchedScope&) = delete;
  MatchedScope& operator=(const MatchedScope&) = delete;

  void Push(const Quad& quad) const {
    if (matched_ != nullptr) matched_->push_back(quad);
  }
  void Append(const std::vector<Quad>& quads) const {
    if (matched_ == nullptr) return;
    matched_->insert(matched_->end(), quads.begin(), quads.end());
  }

 private:
  std::vector<Quad>* matched_;
  std::size_t before_;
};

inline std::vector<Quad> MatchedSince(const std::vector<Quad>& matched,
                                      std::size_t before) {
  return {matched.begin() + static_cast<std::ptrdiff_t>(before), matched.end()};
}

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_MATCHED_SCOPE_H_
