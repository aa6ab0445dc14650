// Results as CSV and TSV. https://www.w3.org/TR/sparql11-results-csv-tsv/

#include "kg_core/sparql/results.h"

namespace kg_core {
namespace {

// Differences between CSV and TSV.
struct SeparatorStyle {
  const char* separator;
  const char* line_end;
  const char* variable_mark;
  std::string (*cell)(const Term& term);
};

// https://www.rfc-editor.org/rfc/rfc4180
std::string CsvText(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out.push_back(c);
    out.push_back(c);
  }
  return out + "\"";
}

std::string CsvCell(const Term& term) {
  return CsvText(term.is_blank() ? "_:" + term.text : term.text);
}

constexpr SeparatorStyle kCsv = {",", "\r\n", "", CsvCell};
constexpr SeparatorStyle kTsv = {"\t", "\n", "?", ToNTriples};

QueryResult Tabular(const QueryResult& given) {
  if (given.form != QueryResult::Form::kAsk) return AsRows(given);
  QueryResult result;
  result.variables = {"answer"};
  result.rows = {{BooleanLiteral(given.answer)}};
  return result;
}

std::string WriteRows(const QueryResult& given, const SeparatorStyle& style) {
  const QueryResult result = Tabular(given);
  std::string out;
  for (std::size_t i = 0; i < result.variables.size(); ++i) {
    if (i > 0) out += style.separator;
    out += style.variable_mark + result.variables[i];
  }
  out += style.line_end;
  for (const auto& row : result.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i > 0) out += style.separator;
      if (row[i]) out += style.cell(*row[i]);
    }
    out += style.line_end;
  }
  return out;
}

}  // namespace

std::string ToCsv(const QueryResult& result) { return WriteRows(result, kCsv); }
std::string ToTsv(const QueryResult& result) { return WriteRows(result, kTsv); }

}  // namespace kg_core
