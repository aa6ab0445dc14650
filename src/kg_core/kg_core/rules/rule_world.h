// The view on which rules are run: its inferred graph holds the conclusions so
// far, without reasons, instead of the store's. Nothing is written to the store
// before the evaluation has finished.

#ifndef KG_CORE_RULES_RULE_WORLD_H_
#define KG_CORE_RULES_RULE_WORLD_H_

#include <cstddef>
#include <deque>
#include <map>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/quad_index.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

class RuleWorld : public GraphView {
 public:
  explicit RuleWorld(const GraphView& base);

  TermId Find(const Term& term) const override;
  const Term& Get(TermId id) const override;
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const override;
  std::size_t Estimate(const Quad& pattern) const override;
  std::uint64_t world_version() const override { return base_.world_version(); }

  // Neither may be called while a query is running.
  TermId Intern(const Term& term);
  bool Conclude(const Quad& triple);  // False if already concluded.

  bool IsConcluded(const Quad& triple) const;
  std::size_t size() const { return concluded_.size(); }

 private:
  // Base of local ids: above the ids of a store, below the query-local ids.
  static constexpr TermId kOwn = TermId{1} << 30;

  const GraphView& base_;
  std::deque<Term> terms_;
  std::map<Term, TermId> ids_;
  QuadIndex concluded_;
  TermId graph_ = kNoTerm;
  std::uint64_t edit_;
};

}  // namespace kg_core

#endif  // KG_CORE_RULES_RULE_WORLD_H_
