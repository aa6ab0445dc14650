// A parsed query: the SPARQL algebra as plain structs.
// https://www.w3.org/TR/sparql11-query/#sparqlAlgebra
//
// Variables and constants are numbered across the whole text. Blank nodes of a
// query are variables that cannot be selected (no variable name can begin with
// "_:" or ".").

#ifndef KG_CORE_SPARQL_QUERY_H_
#define KG_CORE_SPARQL_QUERY_H_

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "kg_core/rdf/term.h"
#include "kg_core/sparql/functions.h"
#include "kg_core/sparql/variable_set.h"

namespace kg_core::sparql {

inline constexpr int kNone = -1;

struct GraphPattern;
struct SelectQuery;

// A position of a triple pattern: a variable or a constant, by number.
struct VarOrTerm {
  bool is_variable = false;
  int index = kNone;
};

// https://www.w3.org/TR/sparql11-query/#propertypaths
struct PropertyPath {
  enum class Kind {
    kLink,         // constant
    kInverse,      // ^part
    kSequence,     // part / part ...
    kAlternative,  // part | part ...
    kZeroOrMore,   // part *
    kOneOrMore,    // part +
    kZeroOrOne,    // part ?
    kNegated,      // !( part | part ... ): links and inverse links
  };
  Kind kind = Kind::kLink;
  int constant = kNone;
  std::vector<PropertyPath> parts;
};

struct TriplePattern {
  VarOrTerm subject;
  VarOrTerm predicate;  // Unused if there is a path.
  VarOrTerm object;
  std::optional<PropertyPath> path;
};

struct Expression {
  enum class Op {
    kVariable,
    kConstant,
    kOr,   // Any number of arguments.
    kAnd,  // Any number of arguments.
    kNot,
    kEqual,
    kNotEqual,
    kLess,
    kGreater,
    kLessEqual,
    kGreaterEqual,
    kIn,  // First argument is among the others.
    kNotIn,
    kAdd,
    kSubtract,
    kMultiply,
    kDivide,
    kNegate,
    kPlus,  // Unary.
    kBound,
    kIf,
    kCoalesce,
    kSameTerm,
    kExists,
    kNotExists,
    kCall,
  };
  Op op = Op::kConstant;
  int index = kNone;                         // kVariable, kBound, kConstant.
  const SparqlFunction* function = nullptr;  // kCall.
  std::vector<Expression> arguments;
  std::unique_ptr<GraphPattern> pattern;  // kExists, kNotExists.
};

// https://www.w3.org/TR/sparql11-query/#sparqlAlgebra
struct GraphPattern {
  enum class Kind {
    kBasic,     // triples; filters as soon as their variables are bound
    kJoin,      // parts[0] and parts[1]
    kLeftJoin,  // parts[0], if possible with parts[1] and filters
    kFilter,    // parts[0] where all filters hold
    kUnion,     // any of parts
    kMinus,     // parts[0] without parts[1]
    kGraph,     // parts[0] within graph
    kExtend,    // parts[0] with variable := filters[0]
    kValues,    // rows over variables
    kSelect,    // a subquery
  };
  Kind kind = Kind::kBasic;
  std::vector<TriplePattern> triples;
  std::vector<GraphPattern> parts;
  std::vector<Expression> filters;
  VarOrTerm graph;
  int variable = kNone;
  std::vector<int> variables;
  std::vector<std::vector<int>> rows;  // Constants, kNone = UNDEF.
  std::unique_ptr<SelectQuery> select;

  // Set by Prepare() (algebra.h).
  VariableSet possible;      // May be bound in a solution.
  VariableSet certain;       // Bound in every solution.
  bool materialise = false;  // Evaluate alone and join, see Prepare().
};

// https://www.w3.org/TR/sparql11-query/#aggregates
struct AggregateCall {
  enum class Kind { kCount, kSum, kAvg, kMin, kMax, kSample, kGroupConcat };
  Kind kind = Kind::kCount;
  bool distinct = false;
  std::optional<Expression> argument;  // nullopt: COUNT(*).
  std::string separator = " ";
  int variable = kNone;  // Variable that receives the value.
  // COUNT(DISTINCT *): the variables that are part of a solution, which those
  // of blank nodes and of paths are not.
  std::vector<int> counted;
};

struct SelectColumn {
  int variable = kNone;
  std::optional<Expression> expression;
};

struct OrderKey {
  Expression expression;
  bool descending = false;
};

struct SelectQuery {
  GraphPattern where;
  std::vector<SelectColumn> columns;
  bool distinct = false;
  bool grouped = false;  // Has GROUP BY or an aggregate.
  std::vector<SelectColumn> group_by;
  std::vector<AggregateCall> aggregates;
  std::vector<Expression> having;
  std::vector<OrderKey> order_by;
  std::optional<std::size_t> limit;
  std::size_t offset = 0;
};

// A triple template of CONSTRUCT, or a quad template of an update (with graph).
// Has no paths; hidden variables become fresh blank nodes.
struct QuadTemplate {
  TriplePattern triple;
  VarOrTerm graph;  // kNone: the default graph.
};

struct Query {
  enum class Form { kSelect, kAsk, kConstruct, kDescribe };
  Form form = Form::kSelect;
  // For ASK only its pattern matters; for other forms the columns are the
  // variables needed.
  SelectQuery select;
  std::vector<QuadTemplate> construct;
  std::vector<VarOrTerm> describe;
  std::vector<std::string> variables;  // Variable names, indexed by number.
  std::vector<Term> constants;
  // FROM and FROM NAMED; has_dataset is false if there is neither.
  bool has_dataset = false;
  std::vector<std::string> from;
  std::vector<std::string> from_named;
  std::string base;
  // Error for the first construct that is grammatical but not supported by
  // RunQuery: "line:column: function <...> is not known", or SERVICE.
  std::string unavailable;
};

// A variable that stands for a blank node or for an unnamed value.
inline bool IsHidden(const std::string& variable) {
  return variable[0] == '.' || variable.compare(0, 2, "_:") == 0;
}

}  // namespace kg_core::sparql

#endif  // KG_CORE_SPARQL_QUERY_H_
