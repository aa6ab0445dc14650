#include "kg_core/rules/facts_and_conclusions.h"

#include "kg_core/facts/terms.h"
#include "kg_core/rules/reasons.h"

namespace kg_core {
namespace {

bool HasQuad(const GraphView& view, const Quad& wanted) {
  bool found = false;
  view.Match(wanted, [&found](const Quad&) {
    found = true;
    return false;
  });
  return found;
}

}  // namespace

TermId FactsAndConclusions::Facts() const {
  return base_.Find(Iri(kFactsGraph));
}

TermId FactsAndConclusions::Inferred() const {
  return base_.Find(Iri(kInferredGraph));
}

bool FactsAndConclusions::IsReason(const Quad& quad) const {
  return kg_core::IsReason(base_.Get(quad.subject));
}

void FactsAndConclusions::Match(
    const Quad& pattern, absl::FunctionRef<bool(const Quad&)> visit) const {
  bool go_on = true;
  base_.Match(pattern, [&](const Quad& quad) {
    go_on = visit(quad);
    return go_on;
  });
  const TermId facts = Facts();
  const TermId inferred = Inferred();
  const bool of_facts = pattern.graph != kNoTerm && pattern.graph == facts;
  if (!go_on || !of_facts || inferred == kNoTerm) return;
  Quad concluded = pattern;
  concluded.graph = inferred;
  base_.Match(concluded, [&](const Quad& quad) {
    Quad fact = quad;
    fact.graph = facts;
    return IsReason(quad) || HasQuad(base_, fact) || visit(fact);
  });
}

std::size_t FactsAndConclusions::Estimate(const Quad& pattern) const {
  const std::size_t count = base_.Estimate(pattern);
  const TermId inferred = Inferred();
  const bool of_facts = pattern.graph != kNoTerm && pattern.graph == Facts();
  if (!of_facts || inferred == kNoTerm) return count;
  Quad concluded = pattern;
  concluded.graph = inferred;
  return count + base_.Estimate(concluded);
}

std::vector<Statement> Conclusions(const GraphView& view) {
  std::vector<Statement> conclusions;
  const TermId inferred = view.Find(Iri(kInferredGraph));
  if (inferred == kNoTerm) return conclusions;
  view.Match({kNoTerm, kNoTerm, kNoTerm, inferred}, [&](const Quad& quad) {
    const Term& subject = view.Get(quad.subject);
    if (IsReason(subject)) return true;
    conclusions.push_back(
        {subject, view.Get(quad.predicate), view.Get(quad.object), Facts()});
    return true;
  });
  return conclusions;
}

}  // namespace kg_core
