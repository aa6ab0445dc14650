// Basic graph patterns: an index nested loop join, cheapest triple first.
// https://www.w3.org/TR/sparql11-query/#BasicGraphPattern

#include <algorithm>
#include <limits>

#include "kg_core/sparql/algebra.h"
#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/matched_scope.h"
#include "kg_core/sparql/path_walker.h"
#include "kg_core/sparql/path_witness.h"

namespace kg_core::sparql {
namespace {

// Assumed selectivity of a bound position (factor by which matches shrink).
// Rough guesses, used only for the join order.
constexpr double kBoundSubject = 1000.0;
constexpr double kBoundPredicate = 10.0;
constexpr double kBoundObject = 100.0;
// Assumed number of solutions of a path, by its bound ends.
constexpr double kOpenPath = 1e7;
constexpr double kHalfBoundPath = 100.0;

// Scope guard for the up to three variables bound by one match.
class RowBinding {
 public:
  explicit RowBinding(Row* row) : row_(row) {}
  ~RowBinding() {
    for (int i = 0; i < count_; ++i) (*row_)[bound_[i]] = kNoTerm;
  }
  RowBinding(const RowBinding&) = delete;
  RowBinding& operator=(const RowBinding&) = delete;

  // False if the variable already has another value.
  bool Bind(const VarOrTerm& node, TermId value) {
    if (!node.is_variable) return true;
    const auto variable = static_cast<std::size_t>(node.index);
    TermId& slot = (*row_)[variable];
    if (slot != kNoTerm) return slot == value;
    slot = value;
    bound_[count_++] = variable;
    return true;
  }

 private:
  Row* row_;
  std::size_t bound_[3] = {};
  int count_ = 0;
};

}  // namespace

struct PatternEvaluator::BasicRun {
  const Plan& plan;
  const ActiveGraph& graph;
  Row* row;
  Emit emit;
};

TermId PatternEvaluator::GetConstant(const VarOrTerm& node) const {
  if (node.is_variable || node.index == kNone) return kNoTerm;
  return constants_[static_cast<std::size_t>(node.index)];
}

TermId PatternEvaluator::GetValue(const VarOrTerm& node, const Row& row) const {
  return node.is_variable ? row[static_cast<std::size_t>(node.index)]
                          : GetConstant(node);
}

double PatternEvaluator::Cost(const TriplePattern& triple, const ActiveGraph& g,
                              const VariableSet& bound) const {
  const auto is_bound = [&bound](const VarOrTerm& node) {
    return node.is_variable && bound.Contains(node.index);
  };
  const bool from = is_bound(triple.subject);
  const bool to = is_bound(triple.object);
  if (triple.path) {
    const int ends = int{from || !triple.subject.is_variable} +
                     int{to || !triple.object.is_variable};
    return ends == 0 ? kOpenPath : ends == 1 ? kHalfBoundPath : 1.0;
  }
  double cost = static_cast<double>(
      g.Estimate({GetConstant(triple.subject), GetConstant(triple.predicate),
                  GetConstant(triple.object), kNoTerm}));
  if (from) cost /= kBoundSubject;
  if (is_bound(triple.predicate)) cost /= kBoundPredicate;
  if (to) cost /= kBoundObject;
  return cost;
}

const PatternEvaluator::Plan& PatternEvaluator::GetPlan(const GraphPattern& p,
                                                        const ActiveGraph& g,
                                                        const Row& row) {
  std::unique_ptr<Plan>& slot = plans_[&p];
  if (slot != nullptr) return *slot;
  slot = std::make_unique<Plan>();
  VariableSet bound;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (row[i] != kNoTerm) bound.Insert(static_cast<int>(i));
  }
  std::vector<const TriplePattern*> left;
  for (const TriplePattern& triple : p.triples) left.push_back(&triple);
  // Greedy join order: next comes the triple with the lowest estimated cost
  // given the variables bound so far.
  while (!left.empty()) {
    auto best = left.begin();
    double best_cost = std::numeric_limits<double>::infinity();
    for (auto it = left.begin(); it != left.end(); ++it) {
      budget_->Step();
      const double cost = Cost(**it, g, bound);
      if (!(cost < best_cost)) continue;
      best_cost = cost;
      best = it;
    }
    slot->steps.push_back(*best);
    for (const VarOrTerm& node :
         {(*best)->subject, (*best)->predicate, (*best)->object}) {
      if (node.is_variable) bound.Insert(node.index);
    }
    left.erase(best);
  }
  // Each filter goes to the first step at which all of its variables are bound.
  slot->filters.resize(slot->steps.size() + 1);
  for (const Expression& filter : p.filters) {
    VariableSet known;
    std::size_t step = 0;
    const VariableSet wanted = CollectVariables(filter);
    while (step < slot->steps.size() && !wanted.IsSubsetOf(known)) {
      const TriplePattern& triple = *slot->steps[step++];
      for (const VarOrTerm& node :
           {triple.subject, triple.predicate, triple.object}) {
        if (node.is_variable) known.Insert(node.index);
      }
    }
    slot->filters[step].push_back(&filter);
  }
  return *slot;
}

bool PatternEvaluator::Basic(const GraphPattern& p, const ActiveGraph& g,
                             Row* row, Emit emit) {
  const BasicRun run{GetPlan(p, g, *row), g, row, emit};
  return Step(run, 0);
}

bool PatternEvaluator::Step(const BasicRun& run, std::size_t step) {
  budget_->Step();
  // A failed filter prunes this branch; the evaluation continues.
  for (const Expression* filter : run.plan.filters[step]) {
    if (!expressions_.Holds(*filter, {*run.row, run.graph})) return true;
  }
  if (step == run.plan.steps.size()) return run.emit(*run.row);
  const TriplePattern& triple = *run.plan.steps[step];
  if (triple.path) return PathStep(run, step, triple);
  const Quad pattern{GetValue(triple.subject, *run.row),
                     GetValue(triple.predicate, *run.row),
                     GetValue(triple.object, *run.row), kNoTerm};
  return run.graph.Match(pattern, [&](const Quad& quad) {
    RowBinding binding(run.row);
    const MatchedScope scope(matched_);
    scope.Push(quad);
    return !binding.Bind(triple.subject, quad.subject) ||
           !binding.Bind(triple.predicate, quad.predicate) ||
           !binding.Bind(triple.object, quad.object) || Step(run, step + 1);
  });
}

bool PatternEvaluator::PathStep(const BasicRun& run, std::size_t step,
                                const TriplePattern& triple) {
  const auto get_end = [this, &run](const VarOrTerm& node) {
    return PathWalker::End{GetValue(node, *run.row), !node.is_variable};
  };
  const PathWalker walker(&run.graph, &constants_, budget_);
  return walker.Walk(
      *triple.path, get_end(triple.subject), get_end(triple.object),
      [&](TermId from, TermId to) {
        RowBinding binding(run.row);
        if (!binding.Bind(triple.subject, from) ||
            !binding.Bind(triple.object, to)) {
          return true;
        }
        const MatchedScope scope(matched_);
        if (matched_ != nullptr) {
          const PathWitness witness(&run.graph, &constants_, budget_, terms_);
          scope.Append(witness.Find(*triple.path, from, to).value());
        }
        return Step(run, step + 1);
      });
}

}  // namespace kg_core::sparql
