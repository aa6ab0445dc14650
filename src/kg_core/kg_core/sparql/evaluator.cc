#include "kg_core/sparql/evaluator.h"

#include <algorithm>

#include "kg_core/sparql/matched_scope.h"

namespace kg_core::sparql {

PatternEvaluator::PatternEvaluator(const Query* query, TermTable* terms,
                                   DatasetIds dataset, QueryBudget* budget)
    : query_(query),
      terms_(terms),
      dataset_(std::move(dataset)),
      budget_(budget),
      expressions_(
          query, terms, budget,
          [this](const GraphPattern& pattern, const Solution& solution) {
            return HasSolution(pattern, solution);
          }),
      default_graph_(&terms->view(), dataset_.default_graphs, budget) {
  for (const Term& constant : query->constants) {
    constants_.push_back(terms->Intern(constant));
  }
}

void PatternEvaluator::Run(Emit emit) {
  if (query_->form == Query::Form::kAsk && !query_->select.grouped) {
    Row row(query_->variables.size(), kNoTerm);
    Evaluate(query_->select.where, default_graph_, &row, emit);
    return;
  }
  RunSelect(query_->select, default_graph_, emit);
}

bool PatternEvaluator::Evaluate(const GraphPattern& p, const ActiveGraph& g,
                                Row* row, Emit emit) {
  if (p.materialise) return GetTable(p, g).Join(row, emit);
  return EvaluateBody(p, g, row, emit);
}

// The solutions of `p` evaluated without outer bindings, computed once.
JoinTable& PatternEvaluator::GetTable(const GraphPattern& p,
                                      const ActiveGraph& g) {
  std::unique_ptr<JoinTable>& table = tables_[{&p, &g}];
  if (table != nullptr) return *table;
  auto fresh = std::make_unique<JoinTable>(p, budget_, matched_);
  Row row(query_->variables.size(), kNoTerm);
  EvaluateBody(p, g, &row, [&fresh](Row& solution) {
    fresh->Add(solution);
    return true;
  });
  return *(tables_[{&p, &g}] = std::move(fresh));
}

bool PatternEvaluator::EvaluateBody(const GraphPattern& p, const ActiveGraph& g,
                                    Row* row, Emit emit) {
  switch (p.kind) {
    case GraphPattern::Kind::kBasic:
      return Basic(p, g, row, emit);
    // Index nested loop join: bindings of the left part go into the right part.
    case GraphPattern::Kind::kJoin:
      return Evaluate(p.parts[0], g, row, [&](Row& left) {
        return Evaluate(p.parts[1], g, &left, emit);
      });
    case GraphPattern::Kind::kLeftJoin:
      return LeftJoin(p, g, row, emit);
    case GraphPattern::Kind::kFilter:
      return Evaluate(p.parts[0], g, row, [&](Row& solution) {
        return !HoldAll(p.filters, g, &solution) || emit(solution);
      });
    case GraphPattern::Kind::kUnion:
      return std::all_of(p.parts.begin(), p.parts.end(),
                         [&](const GraphPattern& part) {
                           return Evaluate(part, g, row, emit);
                         });
    case GraphPattern::Kind::kMinus:
      return Minus(p, g, row, emit);
    case GraphPattern::Kind::kGraph:
      return Graph(p, row, emit);
    case GraphPattern::Kind::kExtend:
      return Extend(p, g, row, emit);
    case GraphPattern::Kind::kValues:
      return Values(p, row, emit);
    case GraphPattern::Kind::kSelect:
      return RunSelect(*p.select, g, emit);
  }
  return true;
}

bool PatternEvaluator::HoldAll(const std::vector<Expression>& filters,
                               const ActiveGraph& g, Row* row) {
  return std::all_of(filters.begin(), filters.end(),
                     [&](const Expression& filter) {
                       return expressions_.Holds(filter, {*row, g});
                     });
}

// https://www.w3.org/TR/sparql11-query/#defn_algLeftJoin
bool PatternEvaluator::LeftJoin(const GraphPattern& p, const ActiveGraph& g,
                                Row* row, Emit emit) {
  return Evaluate(p.parts[0], g, row, [&](Row& left) {
    bool extended = false;
    const bool go_on = Evaluate(p.parts[1], g, &left, [&](Row& both) {
      if (!HoldAll(p.filters, g, &both)) return true;
      extended = true;
      return emit(both);
    });
    return go_on && (extended || emit(left));
  });
}

// https://www.w3.org/TR/sparql11-query/#defn_algMinus
bool PatternEvaluator::Minus(const GraphPattern& p, const ActiveGraph& g,
                             Row* row, Emit emit) {
  JoinTable& right = GetTable(p.parts[1], g);
  return Evaluate(p.parts[0], g, row, [&](Row& left) {
    return right.HasSharing(left) || emit(left);
  });
}

// https://www.w3.org/TR/sparql11-query/#defn_extend
bool PatternEvaluator::Extend(const GraphPattern& p, const ActiveGraph& g,
                              Row* row, Emit emit) {
  const auto variable = static_cast<std::size_t>(p.variable);
  return Evaluate(p.parts[0], g, row, [&](Row& solution) {
    expressions_.BeginRow();
    const TermId value = expressions_.Evaluate(p.filters[0], {solution, g});
    const TermId before = solution[variable];
    if (before != kNoTerm) {
      return (value != kNoTerm && value != before) || emit(solution);
    }
    solution[variable] = value;
    const bool go_on = emit(solution);
    solution[variable] = kNoTerm;
    return go_on;
  });
}

// https://www.w3.org/TR/sparql11-query/#inline-data
bool PatternEvaluator::Values(const GraphPattern& p, Row* row, Emit emit) {
  Row merged = *row;
  for (const std::vector<int>& values : p.rows) {
    budget_->Step();
    bool agrees = true;
    merged = *row;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (values[i] == kNone) continue;
      TermId& slot = merged[static_cast<std::size_t>(p.variables[i])];
      const TermId value = constants_[static_cast<std::size_t>(values[i])];
      agrees = agrees && (slot == kNoTerm || slot == value);
      slot = value;
    }
    if (agrees && !emit(merged)) return false;
  }
  return true;
}

// https://www.w3.org/TR/sparql11-query/#defn_evalGraph
bool PatternEvaluator::Graph(const GraphPattern& p, Row* row, Emit emit) {
  const TermId known = GetValue(p.graph, *row);
  if (known != kNoTerm) {
    const ActiveGraph* graph = NamedGraph(known);
    return graph == nullptr || Evaluate(p.parts[0], *graph, row, emit);
  }
  const auto variable = static_cast<std::size_t>(p.graph.index);
  for (const TermId id : CandidateGraphs(p.parts[0], *row)) {
    const ActiveGraph* graph = NamedGraph(id);
    if (graph == nullptr) continue;
    (*row)[variable] = id;
    const bool go_on = Evaluate(p.parts[0], *graph, row, emit);
    (*row)[variable] = kNoTerm;
    if (!go_on) return false;
  }
  return true;
}

// https://www.w3.org/TR/sparql11-query/#defn_evalExists
bool PatternEvaluator::HasSolution(const GraphPattern& p,
                                   const Solution& solution) {
  const MatchedScope scope(matched_);
  bool found = false;
  Row row = solution.row;
  Evaluate(p, solution.graph, &row, [&found](Row&) {
    found = true;
    return false;
  });
  return found;
}

}  // namespace kg_core::sparql
