#include "kg_core/sparql/algebra.h"

#include <utility>

#include "absl/functional/function_ref.h"

namespace kg_core::sparql {
namespace {

using PatternKind = GraphPattern::Kind;

void InsertNode(const VarOrTerm& node, VariableSet* set) {
  if (node.is_variable && node.index != kNone) set->Insert(node.index);
}

VariableSet TripleVariables(const GraphPattern& basic) {
  VariableSet set;
  for (const TriplePattern& triple : basic.triples) {
    InsertNode(triple.subject, &set);
    InsertNode(triple.object, &set);
    if (!triple.path) InsertNode(triple.predicate, &set);
  }
  return set;
}

bool HasExists(const Expression& expression) {
  if (expression.pattern != nullptr) return true;
  for (const Expression& argument : expression.arguments) {
    if (HasExists(argument)) return true;
  }
  return false;
}

VariableSet VariablesOfAll(const std::vector<Expression>& expressions) {
  VariableSet set;
  for (const Expression& expression : expressions) {
    set.InsertAll(CollectVariables(expression));
  }
  return set;
}

void ForEachExists(Expression* expression,
                   absl::FunctionRef<void(GraphPattern*)> visit) {
  if (expression->pattern != nullptr) visit(expression->pattern.get());
  for (Expression& argument : expression->arguments) {
    ForEachExists(&argument, visit);
  }
}

void ForEachExpression(SelectQuery* select,
                       absl::FunctionRef<void(Expression*)> visit) {
  for (SelectColumn& column : select->columns) {
    if (column.expression) visit(&*column.expression);
  }
  for (SelectColumn& key : select->group_by) {
    if (key.expression) visit(&*key.expression);
  }
  for (AggregateCall& aggregate : select->aggregates) {
    if (aggregate.argument) visit(&*aggregate.argument);
  }
  for (Expression& expression : select->having) visit(&expression);
  for (OrderKey& key : select->order_by) visit(&key.expression);
}

VariableSet CertainValues(const GraphPattern& values) {
  VariableSet certain;
  for (std::size_t i = 0; i < values.variables.size(); ++i) {
    bool bound = true;
    for (const std::vector<int>& row : values.rows) {
      bound = bound && row[i] != kNone;
    }
    if (bound) certain.Insert(values.variables[i]);
  }
  return certain;
}

// The columns of a subquery that its pattern binds in every solution.
VariableSet CertainColumns(const SelectQuery& select) {
  VariableSet keys;
  for (const SelectColumn& key : select.group_by) {
    if (!key.expression) keys.Insert(key.variable);
  }
  VariableSet certain;
  for (const SelectColumn& column : select.columns) {
    const bool kept = !select.grouped || keys.Contains(column.variable);
    if (!column.expression && kept &&
        select.where.certain.Contains(column.variable)) {
      certain.Insert(column.variable);
    }
  }
  return certain;
}

VariableSet CertainVariables(const GraphPattern& pattern) {
  VariableSet certain;
  switch (pattern.kind) {
    case PatternKind::kBasic:
      return TripleVariables(pattern);
    case PatternKind::kValues:
      return CertainValues(pattern);
    case PatternKind::kSelect:
      return CertainColumns(*pattern.select);
    // Only variables that are bound in every alternative.
    case PatternKind::kUnion:
      certain = pattern.parts[0].certain;
      for (const GraphPattern& part : pattern.parts) {
        certain = certain.And(part.certain);
      }
      return certain;
    case PatternKind::kJoin:
      certain = pattern.parts[0].certain;
      certain.InsertAll(pattern.parts[1].certain);
      return certain;
    case PatternKind::kGraph:
      certain = pattern.parts[0].certain;
      InsertNode(pattern.graph, &certain);
      return certain;
    case PatternKind::kLeftJoin:
    case PatternKind::kMinus:
    case PatternKind::kFilter:
    case PatternKind::kExtend:
      break;
  }
  return pattern.parts[0].certain;
}

VariableSet PossibleVariables(const GraphPattern& pattern) {
  VariableSet possible;
  if (pattern.kind == PatternKind::kBasic) return TripleVariables(pattern);
  if (pattern.kind == PatternKind::kSelect) return VisibleVariables(pattern);
  for (const GraphPattern& part : pattern.parts) {
    possible.InsertAll(part.possible);
    if (pattern.kind == PatternKind::kMinus) break;
  }
  InsertNode(pattern.graph, &possible);
  if (pattern.variable != kNone) possible.Insert(pattern.variable);
  for (const int variable : pattern.variables) possible.Insert(variable);
  return possible;
}

void Analyse(GraphPattern* pattern);

void AnalyseExists(Expression* expression) {
  ForEachExists(expression, [](GraphPattern* pattern) { Analyse(pattern); });
}

// Sets `possible` and `certain` bottom-up.
void Analyse(GraphPattern* pattern) {
  for (GraphPattern& part : pattern->parts) Analyse(&part);
  for (Expression& filter : pattern->filters) AnalyseExists(&filter);
  if (pattern->kind == PatternKind::kSelect) {
    Analyse(&pattern->select->where);
    ForEachExpression(pattern->select.get(), AnalyseExists);
  }
  pattern->possible = PossibleVariables(*pattern);
  pattern->certain = CertainVariables(*pattern);
}

// Moves `filter` into `pattern` if all its variables are certain there; returns
// whether it was moved.
bool Push(Expression* filter, GraphPattern* pattern) {
  const VariableSet variables = CollectVariables(*filter);
  // A filter may move into a part only if the part certainly binds all of its
  // variables.
  const auto into = [&](GraphPattern* part) {
    return variables.IsSubsetOf(part->certain) && Push(filter, part);
  };
  switch (pattern->kind) {
    case PatternKind::kBasic:
    case PatternKind::kFilter:
      if (!variables.IsSubsetOf(pattern->certain)) return false;
      if (pattern->kind == PatternKind::kFilter && into(&pattern->parts[0])) {
        return true;
      }
      pattern->filters.push_back(std::move(*filter));
      return true;
    case PatternKind::kJoin:
      return into(&pattern->parts[0]) || into(&pattern->parts[1]);
    case PatternKind::kLeftJoin:
    case PatternKind::kMinus:
    case PatternKind::kGraph:
    case PatternKind::kExtend:
      return into(&pattern->parts[0]);
    case PatternKind::kUnion:
    case PatternKind::kValues:
    case PatternKind::kSelect:
      break;
  }
  return false;
}

// Splits 'a && b' into its conjuncts, which can be pushed down separately.
void SplitConjunction(Expression expression, std::vector<Expression>* out) {
  if (expression.op != Expression::Op::kAnd) {
    out->push_back(std::move(expression));
    return;
  }
  for (Expression& argument : expression.arguments) {
    SplitConjunction(std::move(argument), out);
  }
}

void PushFilters(GraphPattern* pattern) {
  for (GraphPattern& part : pattern->parts) PushFilters(&part);
  if (pattern->kind == PatternKind::kSelect) {
    PushFilters(&pattern->select->where);
  }
  for (Expression& filter : pattern->filters) {
    ForEachExists(&filter, [](GraphPattern* inner) { PushFilters(inner); });
  }
  // Push each conjunct down on its own; the rest, and any EXISTS, stays here.
  if (pattern->kind != PatternKind::kFilter) return;
  std::vector<Expression> conjuncts;
  for (Expression& filter : pattern->filters) {
    SplitConjunction(std::move(filter), &conjuncts);
  }
  pattern->filters.clear();
  for (Expression& conjunct : conjuncts) {
    if (HasExists(conjunct) || !Push(&conjunct, &pattern->parts[0])) {
      pattern->filters.push_back(std::move(conjunct));
    }
  }
}

// True if `pattern` has the same solutions with or without the outer bindings
// of `seeds`.
bool SafeToSeed(const GraphPattern& pattern, const VariableSet& seeds) {
  VariableSet seen;  // Variables read but not bound by the pattern.
  switch (pattern.kind) {
    case PatternKind::kBasic:
    case PatternKind::kValues:
    case PatternKind::kJoin:   // Parts of joins and
    case PatternKind::kUnion:  // unions are marked separately.
    case PatternKind::kGraph:
      return true;
    case PatternKind::kSelect:
      return false;
    case PatternKind::kExtend:
      if (seeds.Contains(pattern.variable)) return false;
      seen = VariablesOfAll(pattern.filters);
      break;
    case PatternKind::kFilter:
      seen = VariablesOfAll(pattern.filters);
      break;
    case PatternKind::kLeftJoin:
    case PatternKind::kMinus:
      seen = VariablesOfAll(pattern.filters);
      seen.InsertAll(MentionedVariables(pattern.parts[1]));
      break;
  }
  return seen.And(seeds).IsSubsetOf(pattern.parts[0].certain);
}

VariableSet With(VariableSet set, const VariableSet& more) {
  set.InsertAll(more);
  return set;
}

// Variables bound outside a pattern, and how they reach it.
struct PatternSeeds {
  VariableSet seeds;
  // Within EXISTS, outer values always replace the variables.
  // https://www.w3.org/TR/sparql11-query/#defn_substitute
  bool substitute = false;
};

void Mark(GraphPattern* pattern, PatternSeeds seeding);

void MarkExists(Expression* expression, const VariableSet& seeds) {
  ForEachExists(expression, [&seeds](GraphPattern* inner) {
    Mark(inner, {seeds, true});
  });
}

void MarkSelect(SelectQuery* select) {
  Mark(&select->where, {});
  VariableSet seeds = select->where.possible;
  for (const SelectColumn& key : select->group_by) seeds.Insert(key.variable);
  for (const SelectColumn& column : select->columns) {
    seeds.Insert(column.variable);
  }
  ForEachExpression(select, [&seeds](Expression* expression) {
    MarkExists(expression, seeds);
  });
}

// A right side that shares no variable with the left is evaluated only once.
void MarkRight(GraphPattern* right, const PatternSeeds& seeding) {
  Mark(right, seeding);
  const bool shares = !right->possible.And(seeding.seeds).Members().empty();
  const bool cheap =
      right->kind == PatternKind::kBasic || right->kind == PatternKind::kValues;
  if (!shares && !cheap && !seeding.substitute && !right->materialise) {
    Mark(right, {});
    right->materialise = true;
  }
}

// Sets `materialise` top-down; see the header.
void Mark(GraphPattern* pattern, PatternSeeds seeding) {
  pattern->materialise =
      pattern->kind == PatternKind::kSelect ||
      (!seeding.substitute && !SafeToSeed(*pattern, seeding.seeds));
  // A pattern that is evaluated separately sees no outer bindings.
  if (pattern->materialise) seeding = {};
  PatternSeeds inner = seeding;
  switch (pattern->kind) {
    case PatternKind::kBasic:
    case PatternKind::kValues:
      break;
    case PatternKind::kSelect:
      MarkSelect(pattern->select.get());
      break;
    case PatternKind::kJoin:
    case PatternKind::kLeftJoin:
      Mark(&pattern->parts[0], seeding);
      inner.seeds.InsertAll(pattern->parts[0].possible);
      MarkRight(&pattern->parts[1], inner);
      break;
    case PatternKind::kMinus:
      Mark(&pattern->parts[0], seeding);
      Mark(&pattern->parts[1], {});
      break;
    case PatternKind::kUnion:
      for (GraphPattern& part : pattern->parts) Mark(&part, seeding);
      break;
    case PatternKind::kGraph:
      InsertNode(pattern->graph, &inner.seeds);
      Mark(&pattern->parts[0], inner);
      break;
    case PatternKind::kFilter:
    case PatternKind::kExtend:
      Mark(&pattern->parts[0], seeding);
      break;
  }
  for (Expression& filter : pattern->filters) {
    MarkExists(&filter, With(seeding.seeds, pattern->possible));
  }
}

// Moves VALUES to the front: it is small, and its values make the index
// look-ups selective.
void MoveValues(GraphPattern* pattern) {
  for (GraphPattern& part : pattern->parts) MoveValues(&part);
  if (pattern->kind == PatternKind::kSelect) {
    MoveValues(&pattern->select->where);
  }
  if (pattern->kind != PatternKind::kJoin) return;
  GraphPattern& left = pattern->parts[0];
  GraphPattern& right = pattern->parts[1];
  if (right.kind == PatternKind::kValues && SafeToSeed(left, right.possible)) {
    std::swap(left, right);
  }
}

}  // namespace

VariableSet CollectVariables(const Expression& expression) {
  VariableSet set;
  const bool mentions = expression.op == Expression::Op::kVariable ||
                        expression.op == Expression::Op::kBound;
  if (mentions) set.Insert(expression.index);
  for (const Expression& argument : expression.arguments) {
    set.InsertAll(CollectVariables(argument));
  }
  if (expression.pattern != nullptr) {
    set.InsertAll(MentionedVariables(*expression.pattern));
  }
  return set;
}

VariableSet VisibleVariables(const GraphPattern& pattern) {
  VariableSet set;
  if (pattern.kind == PatternKind::kBasic) return TripleVariables(pattern);
  if (pattern.kind == PatternKind::kSelect) {
    for (const SelectColumn& column : pattern.select->columns) {
      set.Insert(column.variable);
    }
    return set;
  }
  for (const GraphPattern& part : pattern.parts) {
    set.InsertAll(VisibleVariables(part));
    if (pattern.kind == PatternKind::kMinus) break;
  }
  InsertNode(pattern.graph, &set);
  if (pattern.variable != kNone) set.Insert(pattern.variable);
  for (const int variable : pattern.variables) set.Insert(variable);
  return set;
}

VariableSet MentionedVariables(const GraphPattern& pattern) {
  VariableSet set = VisibleVariables(pattern);
  if (pattern.kind == PatternKind::kSelect) return set;
  set.InsertAll(VariablesOfAll(pattern.filters));
  for (const GraphPattern& part : pattern.parts) {
    set.InsertAll(MentionedVariables(part));
  }
  return set;
}

void Prepare(SelectQuery* select) {
  Analyse(&select->where);
  ForEachExpression(select, AnalyseExists);
  PushFilters(&select->where);
  MoveValues(&select->where);
  MarkSelect(select);
}

}  // namespace kg_core::sparql
