#include "kg_core/rules/rule_world.h"

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/quad_tree.h"

namespace kg_core {

RuleWorld::RuleWorld(const GraphView& base)
    : base_(base), edit_(QuadTree::NewEdit()) {
  graph_ = Intern(Iri(kInferredGraph));
}

TermId RuleWorld::Find(const Term& term) const {
  const TermId known = base_.Find(term);
  if (known != kNoTerm) return known;
  const auto own = ids_.find(term);
  return own == ids_.end() ? kNoTerm : own->second;
}

const Term& RuleWorld::Get(TermId id) const {
  return id >= kOwn ? terms_[id - kOwn] : base_.Get(id);
}

TermId RuleWorld::Intern(const Term& term) {
  const TermId known = Find(term);
  if (known != kNoTerm) return known;
  const TermId next = kOwn + static_cast<TermId>(terms_.size());
  terms_.push_back(term);
  ids_.emplace(term, next);
  return next;
}

void RuleWorld::Match(const Quad& pattern,
                      absl::FunctionRef<bool(const Quad&)> visit) const {
  bool go_on = true;
  if (pattern.graph != graph_) {
    base_.Match(pattern, [&](const Quad& quad) {
      go_on = quad.graph == graph_ || visit(quad);
      return go_on;
    });
  }
  if (!go_on) return;
  if (pattern.graph != graph_ && pattern.graph != kNoTerm) return;
  concluded_.Match(pattern, visit);
}

std::size_t RuleWorld::Estimate(const Quad& pattern) const {
  const bool own = pattern.graph == graph_ || pattern.graph == kNoTerm;
  return (pattern.graph == graph_ ? 0 : base_.Estimate(pattern)) +
         (own ? concluded_.Estimate(pattern) : 0);
}

bool RuleWorld::Conclude(const Quad& triple) {
  return concluded_.Insert(
      {triple.subject, triple.predicate, triple.object, graph_}, edit_);
}

bool RuleWorld::IsConcluded(const Quad& triple) const {
  return concluded_.Contains(
      {triple.subject, triple.predicate, triple.object, graph_});
}

}  // namespace kg_core
