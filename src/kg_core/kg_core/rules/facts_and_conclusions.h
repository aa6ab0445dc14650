// Facts and the conclusions of the rules as one graph, from which the mission
// is read and which the shapes validate.
//
// A live view of another view in which the facts graph also contains the
// conclusions of the inferred graph, without the reasons. Other graphs are
// unchanged.

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

// The conclusions in the inferred graph of `view`, as statements of the facts
// graph.
std::vector<Statement> Conclusions(const GraphView& view);

}  // namespace kg_core

#endif  // KG_CORE_RULES_FACTS_AND_CONCLUSIONS_H_
