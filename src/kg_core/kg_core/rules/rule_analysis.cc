#include "kg_core/rules/rule_analysis.h"

#include <string>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/terms.h"

namespace kg_core {
namespace {

using kg_base::InputError;

using sparql::AggregateCall;
using sparql::Expression;
using sparql::GraphPattern;
using sparql::PropertyPath;
using sparql::Query;
using sparql::SelectQuery;
using sparql::TriplePattern;
using sparql::VarOrTerm;

constexpr const char* kChangingFunctions[] = {"RAND", "NOW", "UUID", "STRUUID",
                                              "BNODE"};

const Term& GetConstant(const Query& query, int index) {
  return query.constants[static_cast<std::size_t>(index)];
}

TripleKind GetKind(const Query& query, const TriplePattern& triple) {
  TripleKind kind;
  if (triple.predicate.is_variable) return kind;
  kind.predicate = GetConstant(query, triple.predicate.index);
  if (*kind.predicate == RdfType() && !triple.object.is_variable) {
    kind.type = GetConstant(query, triple.object.index);
  }
  return kind;
}

class RuleAnalyser {
 public:
  explicit RuleAnalyser(const Query& query) : query_(query) {}

  RuleReads Run() {
    Visit(query_.select, {});
    return std::move(found_);
  }

 private:
  struct Place {
    bool negative = false;  // New triples may remove solutions.
    bool counted = false;   // Inside the input of an aggregate.
  };
  static Place Negative(Place place) {
    place.negative = true;
    return place;
  }

  void Note(const TripleKind& kind, const Place& place) {
    (place.negative ? found_.negative_reads : found_.reads).push_back(kind);
  }

  void Visit(const SelectQuery& select, Place place) {
    if (select.limit || select.offset > 0) {
      throw InputError("LIMIT and OFFSET are not for rules: they choose");
    }
    if (select.distinct && place.counted) {
      throw InputError(
          "a DISTINCT subquery below an aggregate is not for rules: write "
          "COUNT(DISTINCT ?x)");
    }
    for (const AggregateCall& aggregate : select.aggregates) {
      CheckAggregate(aggregate);
    }
    if (select.grouped) place = {true, true};
    Visit(select.where, place);
    VisitExpressions(select, Negative(place));
  }

  static void CheckAggregate(const AggregateCall& aggregate) {
    const bool chooses = aggregate.kind == AggregateCall::Kind::kSample ||
                         aggregate.kind == AggregateCall::Kind::kGroupConcat;
    if (chooses) {
      throw InputError(
          "SAMPLE and GROUP_CONCAT are not for rules: their values depend on "
          "an order that facts do not have");
    }
  }

  void VisitExpressions(const SelectQuery& select, const Place& place) {
    for (const sparql::SelectColumn& column : select.columns) {
      if (column.expression) Visit(*column.expression, place);
    }
    for (const sparql::SelectColumn& key : select.group_by) {
      if (key.expression) Visit(*key.expression, place);
    }
    for (const AggregateCall& aggregate : select.aggregates) {
      if (aggregate.argument) Visit(*aggregate.argument, place);
    }
    for (const Expression& having : select.having) Visit(having, place);
    for (const sparql::OrderKey& key : select.order_by) {
      Visit(key.expression, place);
    }
  }

  void Visit(const GraphPattern& pattern, const Place& place) {
    if (pattern.kind == GraphPattern::Kind::kGraph) {
      throw InputError(
          "GRAPH is not for rules: they read facts, vocabulary and what rules "
          "conclude, as one graph");
    }
    for (const TriplePattern& triple : pattern.triples) Visit(triple, place);
    // More solutions of the right part of OPTIONAL or MINUS can remove
    // solutions of the whole.
    const bool may_take_away = pattern.kind == GraphPattern::Kind::kLeftJoin ||
                               pattern.kind == GraphPattern::Kind::kMinus;
    for (std::size_t i = 0; i < pattern.parts.size(); ++i) {
      Visit(pattern.parts[i], i > 0 && may_take_away ? Negative(place) : place);
    }
    const bool is_filter = pattern.kind == GraphPattern::Kind::kFilter;
    for (const Expression& filter : pattern.filters) {
      if (is_filter) {
        VisitCondition(filter, place);
      } else {
        Visit(filter, Negative(place));
      }
    }
    if (pattern.select != nullptr) Visit(*pattern.select, place);
  }

  // A condition of EXISTS under AND and OR only is monotonic: new triples never
  // remove solutions.
  void VisitCondition(const Expression& condition, const Place& place) {
    switch (condition.op) {
      case Expression::Op::kAnd:
      case Expression::Op::kOr:
        for (const Expression& part : condition.arguments) {
          VisitCondition(part, place);
        }
        return;
      case Expression::Op::kExists:
        return Visit(*condition.pattern, place);
      default:
        return Visit(condition, Negative(place));
    }
  }

  void Visit(const Expression& expression, const Place& place) {
    if (expression.function != nullptr) CheckFunction(*expression.function);
    if (expression.pattern != nullptr) Visit(*expression.pattern, place);
    for (const Expression& argument : expression.arguments) {
      Visit(argument, place);
    }
  }

  static void CheckFunction(const sparql::SparqlFunction& function) {
    for (const char* name : kChangingFunctions) {
      if (function.name != name) continue;
      throw InputError(function.name +
                       "() is not for rules: equal facts must give equal "
                       "conclusions");
    }
  }

  void Visit(const TriplePattern& triple, const Place& place) {
    if (!triple.path) return Note(GetKind(query_, triple), place);
    // A zero-length path between two variables matches every node of the graph.
    const bool open = triple.subject.is_variable && triple.object.is_variable;
    Visit(*triple.path, open, place);
  }

  void Visit(const PropertyPath& path, bool open, const Place& place) {
    const bool may_be_empty = path.kind == PropertyPath::Kind::kZeroOrMore ||
                              path.kind == PropertyPath::Kind::kZeroOrOne;
    if (path.kind == PropertyPath::Kind::kNegated || (open && may_be_empty)) {
      return Note({}, place);
    }
    if (path.kind == PropertyPath::Kind::kLink) {
      return Note({GetConstant(query_, path.constant), std::nullopt}, place);
    }
    for (const PropertyPath& part : path.parts) Visit(part, open, place);
  }

  const Query& query_;
  RuleReads found_;
};

std::string GetName(const Query& query, const VarOrTerm& variable) {
  return "?" + query.variables[static_cast<std::size_t>(variable.index)];
}

// True if a solution can bind `node`.
bool IsGround(const Query& query, const VarOrTerm& node) {
  if (!node.is_variable) return true;
  if (sparql::IsHidden(query.variables[static_cast<std::size_t>(node.index)])) {
    return true;  // Becomes a generated IRI, see fixed_point.h.
  }
  if (!query.select.grouped) {
    return query.select.where.possible.Contains(node.index);
  }
  for (const sparql::SelectColumn& key : query.select.group_by) {
    if (key.variable == node.index) return true;
  }
  return false;
}

}  // namespace

RuleReads AnalyseRule(const Query& query) {
  if (query.form != Query::Form::kConstruct) {
    throw InputError("expected CONSTRUCT { ... } WHERE { ... }");
  }
  if (query.has_dataset) {
    throw InputError(
        "FROM is not for rules: they read facts, vocabulary and what rules "
        "conclude");
  }
  if (!query.unavailable.empty()) throw InputError(query.unavailable);
  return RuleAnalyser(query).Run();
}

std::vector<TripleKind> AnalyseTemplate(const Query& query) {
  if (query.construct.empty()) {
    throw InputError("expected a triple to conclude in CONSTRUCT { ... }");
  }
  std::vector<TripleKind> writes;
  for (const sparql::QuadTemplate& made : query.construct) {
    const TriplePattern& triple = made.triple;
    for (const VarOrTerm& node :
         {triple.subject, triple.predicate, triple.object}) {
      if (IsGround(query, node)) continue;
      throw InputError(GetName(query, node) +
                       " is concluded, but WHERE never binds it");
    }
    writes.push_back(GetKind(query, triple));
  }
  return writes;
}

}  // namespace kg_core
