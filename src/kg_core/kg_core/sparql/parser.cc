// Query forms and solution modifiers, rules [1] to [28].

#include "kg_core/sparql/parser.h"

#include <algorithm>
#include <cstdlib>

#include "kg_core/sparql/grammar.h"
#include "kg_core/sparql/lexer.h"

namespace kg_core::sparql {
namespace {

struct RefusedForm {
  const char* word;
  const char* reason;
};
constexpr RefusedForm kOtherForms[] = {
    {"INSERT", "INSERT is not available: a query changes nothing"},
    {"DELETE", "DELETE is not available: a query changes nothing"},
    {"LOAD", "LOAD is not available: a query changes nothing"},
    {"CLEAR", "CLEAR is not available: a query changes nothing"},
    {"CREATE", "CREATE is not available: a query changes nothing"},
    {"DROP", "DROP is not available: a query changes nothing"},
    {"COPY", "COPY is not available: a query changes nothing"},
    {"MOVE", "MOVE is not available: a query changes nothing"},
    {"ADD", "ADD is not available: a query changes nothing"},
    {"WITH", "WITH is not available: a query changes nothing"},
};

Expression VariableExpression(int variable) {
  Expression expression;
  expression.op = Expression::Op::kVariable;
  expression.index = variable;
  return expression;
}

}  // namespace

// [4] Prologue
void SparqlGrammar::ReadPrologue() {
  while (true) {
    if (TakeWord("BASE")) {
      if (Peek().kind != Token::Kind::kIri) Expected("an IRI in <>");
      query_.base = ReadIri();
    } else if (TakeWord("PREFIX")) {
      const Token name = Peek();
      if (name.kind != Token::Kind::kPrefixedName || !name.text.empty()) {
        Expected("a prefix such as ex:");
      }
      Take();
      if (Peek().kind != Token::Kind::kIri) Expected("an IRI in <>");
      prefixes_[name.prefix] = ReadIri();
    } else {
      return;
    }
  }
}

void SparqlGrammar::RefuseOtherForms() {
  for (const RefusedForm& form : kOtherForms) {
    if (AtWord(form.word)) Fail(Peek(), form.reason);
  }
}

// [1] QueryUnit
Query SparqlGrammar::ReadQuery() {
  ReadPrologue();
  RefuseOtherForms();
  if (AtWord("SELECT")) {
    ReadSelect(&query_.select);
  } else if (TakeWord("ASK")) {
    query_.form = Query::Form::kAsk;
    ReadDatasetClauses();
    ReadWhere(&query_.select);
    ReadModifiersOfForm();
  } else if (TakeWord("CONSTRUCT")) {
    query_.form = Query::Form::kConstruct;
    ReadConstruct();
  } else if (TakeWord("DESCRIBE")) {
    query_.form = Query::Form::kDescribe;
    ReadDescribe();
  } else {
    Expected("SELECT, ASK, CONSTRUCT or DESCRIBE");
  }
  if (Peek().kind != Token::Kind::kEnd) Expected("the end of the query");
  return std::move(query_);
}

// [13] DatasetClause
void SparqlGrammar::ReadDatasetClauses() {
  while (TakeWord("FROM")) {
    query_.has_dataset = true;
    const bool named = TakeWord("NAMED");
    (named ? query_.from_named : query_.from).push_back(ReadIri());
  }
}

// [7] SelectQuery, [8] SubSelect
void SparqlGrammar::ReadSelect(SelectQuery* select) {
  const QueryPosition start = Peek().position;
  aggregates_of_ = select;
  const bool all = ReadSelectClause(select);
  aggregates_of_ = nullptr;
  if (select == &query_.select) ReadDatasetClauses();
  ReadWhere(select);
  aggregates_of_ = select;
  ReadModifiers(select);
  aggregates_of_ = nullptr;
  if (!all) return CheckColumns(*select, start);
  if (select->grouped) {
    FailAt(start, "SELECT * does not go with GROUP BY or an aggregate");
  }
  AddColumns(VisibleVariables(select->where), select);
}

// Adds the named variables of `variables` as columns.
void SparqlGrammar::AddColumns(const VariableSet& variables,
                               SelectQuery* select) {
  for (const int variable : NamedMembers(variables)) {
    select->columns.push_back({variable, std::nullopt});
  }
}

// Without the variables of blank nodes and of paths.
std::vector<int> SparqlGrammar::NamedMembers(
    const VariableSet& variables) const {
  std::vector<int> named;
  for (const int variable : variables.Members()) {
    const std::string& name =
        query_.variables[static_cast<std::size_t>(variable)];
    if (!IsHidden(name)) named.push_back(variable);
  }
  return named;
}

// [9] SelectClause; true for SELECT *.
bool SparqlGrammar::ReadSelectClause(SelectQuery* select) {
  ExpectWord("SELECT");
  select->distinct = TakeWord("DISTINCT");
  // REDUCED permits removing duplicates; this implementation keeps them.
  if (!select->distinct) TakeWord("REDUCED");
  if (TakeMark("*")) return true;
  while (true) {
    if (Peek().kind == Token::Kind::kVariable) {
      AddColumn(ReadVariable(), select);
    } else if (TakeMark("(")) {
      select->columns.push_back(ReadAliased());
    } else if (select->columns.empty()) {
      Expected("a variable, '(' or '*'");
    } else {
      return false;
    }
  }
}

// A variable that is named twice is one column.
void SparqlGrammar::AddColumn(int variable, SelectQuery* select) {
  const bool is_known = std::any_of(
      select->columns.begin(), select->columns.end(),
      [&](const SelectColumn& known) { return known.variable == variable; });
  if (!is_known) select->columns.push_back({variable, std::nullopt});
}

SelectColumn SparqlGrammar::ReadAliased() {
  SelectColumn column;
  column.expression = ReadExpression();
  ExpectWord("AS");
  column.variable = ReadVariable();
  ExpectMark(")");
  return column;
}

// [17] WhereClause
void SparqlGrammar::ReadWhere(SelectQuery* select) {
  SelectQuery* const outer = aggregates_of_;
  aggregates_of_ = nullptr;
  TakeWord("WHERE");
  select->where = ReadGroupPattern();
  aggregates_of_ = outer;
}

void SparqlGrammar::ReadModifiersOfForm() {
  aggregates_of_ = &query_.select;
  ReadModifiers(&query_.select);
  aggregates_of_ = nullptr;
}

// [18] SolutionModifier, [28] ValuesClause
void SparqlGrammar::ReadModifiers(SelectQuery* select) {
  ReadGroupBy(select);
  ReadHaving(select);
  ReadOrderBy(select);
  ReadLimits(select);
  select->grouped = !select->group_by.empty() || !select->aggregates.empty() ||
                    !select->having.empty();
  if (TakeWord("VALUES")) {
    select->where = Join(std::move(select->where), ReadValues());
  }
  if (select->aggregates.empty()) return;
  const std::vector<int> counted =
      NamedMembers(VisibleVariables(select->where));
  for (AggregateCall& aggregate : select->aggregates) {
    if (!aggregate.argument) aggregate.counted = counted;
  }
}

// [19] GroupClause
void SparqlGrammar::ReadGroupBy(SelectQuery* select) {
  if (!TakeWord("GROUP")) return;
  ExpectWord("BY");
  // Aggregates are not allowed in GROUP BY.
  SelectQuery* const outer = aggregates_of_;
  aggregates_of_ = nullptr;
  while (true) {
    SelectColumn key;
    if (Peek().kind == Token::Kind::kVariable) {
      key.variable = ReadVariable();
    } else if (TakeMark("(")) {
      key.expression = ReadExpression();
      key.variable = TakeWord("AS") ? ReadKeyName(*select) : FreshVariable();
      ExpectMark(")");
    } else if (AtIri() || (Peek().kind == Token::Kind::kWord &&
                           FindKeywordFunction(Peek().text) != nullptr)) {
      key.expression = ReadConstraint();
      key.variable = FreshVariable();
    } else if (select->group_by.empty()) {
      Expected("what to group by");
    } else {
      break;
    }
    select->group_by.push_back(std::move(key));
  }
  aggregates_of_ = outer;
}

// The name of an expression to group by, which must not have values yet.
int SparqlGrammar::ReadKeyName(const SelectQuery& select) {
  const Token name = Peek();
  const int variable = ReadVariable();
  const bool is_key = std::any_of(
      select.group_by.begin(), select.group_by.end(),
      [&](const SelectColumn& key) { return key.variable == variable; });
  if (is_key || VisibleVariables(select.where).Contains(variable)) {
    Fail(name, "?" + name.text + " already has values in this query");
  }
  return variable;
}

// [21] HavingClause
void SparqlGrammar::ReadHaving(SelectQuery* select) {
  if (!TakeWord("HAVING")) return;
  do {
    select->having.push_back(ReadConstraint());
  } while (!AtWord("ORDER") && !AtWord("LIMIT") && !AtWord("OFFSET") &&
           !AtWord("VALUES") &&
           (AtMark("(") || AtIri() || Peek().kind == Token::Kind::kWord));
}

// [23] OrderClause
void SparqlGrammar::ReadOrderBy(SelectQuery* select) {
  if (!TakeWord("ORDER")) return;
  ExpectWord("BY");
  while (true) {
    OrderKey key;
    key.descending = AtWord("DESC");
    if (AtWord("ASC") || AtWord("DESC")) {
      Take();
      key.expression = ReadBracketed();
    } else if (Peek().kind == Token::Kind::kVariable) {
      key.expression = VariableExpression(ReadVariable());
      // [24] OrderCondition: a constraint, unless the next word begins a later
      // clause.
    } else if (AtMark("(") || AtIri() ||
               (Peek().kind == Token::Kind::kWord && !AtWord("LIMIT") &&
                !AtWord("OFFSET") && !AtWord("VALUES"))) {
      key.expression = ReadConstraint();
    } else if (select->order_by.empty()) {
      Expected("what to order by");
    } else {
      return;
    }
    select->order_by.push_back(std::move(key));
  }
}

std::size_t SparqlGrammar::ReadCount() {
  if (Peek().kind != Token::Kind::kInteger || Peek().text.size() > 18) {
    Expected("a whole number");
  }
  return static_cast<std::size_t>(
      std::strtoull(Take().text.c_str(), nullptr, 10));
}

// [25] LimitOffsetClauses
void SparqlGrammar::ReadLimits(SelectQuery* select) {
  bool offset_seen = false;
  while (true) {
    if (!select->limit && TakeWord("LIMIT")) {
      select->limit = ReadCount();
    } else if (!offset_seen && TakeWord("OFFSET")) {
      offset_seen = true;
      select->offset = ReadCount();
    } else {
      return;
    }
  }
}

// https://www.w3.org/TR/sparql11-query/#selectExpressions and
// #aggregateRestrictions
void SparqlGrammar::CheckColumns(const SelectQuery& select,
                                 QueryPosition position) {
  VariableSet known;  // Variables allowed in columns of a grouped query.
  for (const SelectColumn& key : select.group_by) known.Insert(key.variable);
  // Grouping ends the scope of all variables of the pattern but its keys.
  // https://www.w3.org/TR/sparql11-query/#variableScope
  const VariableSet visible =
      select.grouped ? known : VisibleVariables(select.where);
  for (const AggregateCall& aggregate : select.aggregates) {
    known.Insert(aggregate.variable);
  }
  VariableSet columns;
  for (const SelectColumn& column : select.columns) {
    const std::string name =
        "?" + query_.variables[static_cast<std::size_t>(column.variable)];
    if (!column.expression) {
      if (select.grouped && !known.Contains(column.variable)) {
        FailAt(position, name + " is neither grouped by nor aggregated");
      }
      columns.Insert(column.variable);
      continue;
    }
    if (visible.Contains(column.variable) ||
        columns.Contains(column.variable)) {
      FailAt(position, name + " already has values in this query");
    }
    if (select.grouped &&
        !CollectVariables(*column.expression).IsSubsetOf(known)) {
      FailAt(position, "the expression of " + name +
                           " mentions a variable that is not grouped by");
    }
    columns.Insert(column.variable);
    known.Insert(column.variable);
  }
}

Query ParseQuery(std::string_view text, int nesting) {
  return SparqlGrammar(Tokenize(text), nesting).ReadQuery();
}

}  // namespace kg_core::sparql
