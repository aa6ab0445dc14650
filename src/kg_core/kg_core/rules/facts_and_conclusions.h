// Facts and what rules conclude from them, as one graph: what the mission is
// read from, and what the shapes must hold of.
//
// A view of another view, live like that one, where the facts graph also has
// the conclusions of the inferred graph, without the reasons. Other graphs are
// as they are.

#ifndef KG_CORE_RULES_FACTS_AND_CONCLUSIONS_H_
#define KG_CORE_RULES_FACTS_AND_CONCLUSIONS_H_

#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/store.h"

namespace kg_core {

class FactsAndConclusions : public GraphView {
 public:
  explicit FactsAndConclusions(const GraphView& base) : base_(base) {}

  TermId Find(const Term& term) const override { return base_.Find(term); }
  const Term& Get(TermId id) const override { return base_.Get(id); }
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const override;
  std::size_t Estimate(const Quad& pattern) const override;
  std::uint64_t world_version() const override { return base_.world_version(); }

 private:
  TermId Facts() const;
  TermId Inferred() const;
  bool IsReason(const Quad& quad) const;

  const GraphView& base_;
};

// The conclusions in `view`'s inferred graph, as statements of the facts graph.
std::vector<Statement> Conclusions(const GraphView& view);

}  // namespace kg_core

#endif  // KG_CORE_RULES_FACTS_AND_CONCLUSIONS_H_
