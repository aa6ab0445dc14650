#include "kg_core/sparql/query_engine.h"

#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/limit_error.h"
#include "kg_core/sparql/algebra.h"
#include "kg_core/sparql/budget.h"
#include "kg_core/sparql/construct.h"
#include "kg_core/sparql/evaluator.h"
#include "kg_core/sparql/parser.h"
#include "kg_core/sparql/resolve_dataset.h"
#include "kg_core/sparql/term_table.h"

namespace kg_core {
namespace {

using sparql::PatternEvaluator;
using sparql::Query;
using sparql::QueryBudget;
using sparql::QueryRun;
using sparql::Row;
using sparql::TermTable;

std::size_t CountBytes(const std::vector<std::optional<Term>>& row) {
  std::size_t bytes = 0;
  for (const std::optional<Term>& term : row) {
    if (!term) continue;
    bytes += term->text.size() + term->datatype.size() + term->language.size();
  }
  return bytes;
}

void CheckText(std::string_view text, const QueryLimits& limits) {
  if (text.size() <= limits.text_bytes) return;
  throw kg_base::LimitError("the query is longer than the limit of " +
                            std::to_string(limits.text_bytes) + " bytes");
}

bool HasSolution(const QueryRun& run) {
  bool found = false;
  run.evaluator->Run([&found](Row&) {
    found = true;
    return false;
  });
  return found;
}

void SelectRows(const QueryRun& run, QueryResult* result) {
  std::vector<std::size_t> columns;
  for (const sparql::SelectColumn& column : run.query.select.columns) {
    columns.push_back(static_cast<std::size_t>(column.variable));
    result->variables.push_back(run.query.variables[columns.back()]);
  }
  run.evaluator->Run([&](Row& solution) {
    std::vector<std::optional<Term>> row(columns.size());
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const TermId id = solution[columns[i]];
      if (id != kNoTerm) row[i] = run.terms->Get(id);
    }
    run.budget->AddResultRow(CountBytes(row));
    result->rows.push_back(std::move(row));
    return true;
  });
}

}  // namespace

QueryResult RunQuery(const GraphView& view, std::string_view query_text,
                     const Dataset& dataset, const QueryLimits& limits) {
  CheckText(query_text, limits);
  QueryBudget budget(limits);
  Query query = sparql::ParseQuery(query_text, limits.nesting);
  if (!query.unavailable.empty()) throw kg_base::InputError(query.unavailable);
  // A dataset given in the protocol request takes precedence over FROM.
  if (dataset.is_binding) query.has_dataset = false;
  if (query.has_dataset) sparql::CheckDataset(view, query);
  sparql::Prepare(&query.select);
  TermTable terms(&view, &budget);
  PatternEvaluator evaluator(&query, &terms,
                             sparql::Resolve(query, dataset, &terms), &budget);
  const QueryRun run{query, &evaluator, &terms, &budget};
  QueryResult result;
  switch (query.form) {
    case Query::Form::kSelect:
      SelectRows(run, &result);
      break;
    case Query::Form::kAsk:
      result.form = QueryResult::Form::kAsk;
      result.answer = HasSolution(run);
      break;
    case Query::Form::kConstruct:
      result.form = QueryResult::Form::kConstruct;
      result.triples = sparql::Construct(run);
      break;
    case Query::Form::kDescribe:
      result.form = QueryResult::Form::kDescribe;
      result.triples = sparql::Describe(run);
      break;
  }
  return result;
}

}  // namespace kg_core
