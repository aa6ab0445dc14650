#include "kg_core/sparql/results.h"

#include <algorithm>
#include <cstdio>

#include "kg_base/common/join_strings.h"
#include "kg_base/text/utf8.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_core {
namespace {

// https://www.rfc-editor.org/rfc/rfc8259#section-7
std::string JsonString(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out.push_back('\\');
      out.push_back(c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[8];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out += code;
    } else {
      out.push_back(c);
    }
  }
  return out + "\"";
}

// https://www.w3.org/TR/sparql11-results-json/#select-encode-terms
std::string JsonTerm(const Term& term) {
  std::string out = "{\"type\":";
  switch (term.kind) {
    case Term::Kind::kIri:
      out += "\"uri\"";
      break;
    case Term::Kind::kBlank:
      out += "\"bnode\"";
      break;
    case Term::Kind::kLiteral:
      out += "\"literal\"";
      break;
  }
  if (!term.language.empty()) {
    out += ",\"xml:lang\":" + JsonString(term.language);
  } else if (term.is_literal() &&
             term.datatype != std::string(kXsd) + "string") {
    out += ",\"datatype\":" + JsonString(term.datatype);
  }
  return out + ",\"value\":" + JsonString(term.text) + "}";
}

std::string JsonRow(const QueryResult& result, std::size_t row) {
  std::vector<std::string> members;
  for (std::size_t i = 0; i < result.variables.size(); ++i) {
    const std::optional<Term>& term = result.rows[row][i];
    if (!term) continue;
    members.push_back(JsonString(result.variables[i]) + ":" + JsonTerm(*term));
  }
  return "{" + kg_base::JoinStrings(members, ",") + "}";
}

using TextRows = std::vector<std::vector<std::string>>;

TextRows FormatCells(const QueryResult& result) {
  TextRows lines(1);
  for (const std::string& name : result.variables) {
    lines[0].push_back("?" + name);
  }
  for (const auto& row : result.rows) {
    lines.emplace_back();
    for (const std::optional<Term>& term : row) {
      lines.back().push_back(term ? ToTurtle(*term) : "");
    }
  }
  return lines;
}

std::string PaddedLine(const std::vector<std::string>& cells,
                       const std::vector<std::size_t>& widths) {
  std::string line;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    line += cells[i];
    line.append(widths[i] - kg_base::Utf8Length(cells[i]) + 2, ' ');
  }
  return line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
}

bool HasTriples(const QueryResult& result) {
  return result.form == QueryResult::Form::kConstruct ||
         result.form == QueryResult::Form::kDescribe;
}

}  // namespace

QueryResult AsRows(const QueryResult& result) {
  if (!HasTriples(result)) return result;
  QueryResult rows;
  rows.variables = {"subject", "predicate", "object"};
  for (const Triple& triple : result.triples) {
    rows.rows.push_back({triple.subject, triple.predicate, triple.object});
  }
  return rows;
}

std::string ToJson(const QueryResult& result) {
  if (HasTriples(result)) return ToJson(AsRows(result));
  if (result.form == QueryResult::Form::kAsk) {
    return std::string("{\"head\":{},\"boolean\":") +
           (result.answer ? "true}" : "false}");
  }
  std::string out = "{\"head\":{\"vars\":[";
  for (std::size_t i = 0; i < result.variables.size(); ++i) {
    out += (i > 0 ? "," : "") + JsonString(result.variables[i]);
  }
  out += "]},\"results\":{\"bindings\":[";
  for (std::size_t row = 0; row < result.rows.size(); ++row) {
    out += (row > 0 ? ",\n" : "\n") + JsonRow(result, row);
  }
  return out + "]}}";
}

const std::vector<ResultFormat>& ResultFormats() {
  static const auto* const formats = new std::vector<ResultFormat>{
      {"json", "application/sparql-results+json", ToJson},
      {"xml", "application/sparql-results+xml", ToXml},
      {"csv", "text/csv", ToCsv},
      {"tsv", "text/tab-separated-values", ToTsv},
      {"text", "text/plain", ToTextTable},
  };
  return *formats;
}

std::string ToTextTable(const QueryResult& result) {
  if (HasTriples(result)) return TriplesToTurtle(result.triples);
  if (result.form == QueryResult::Form::kAsk) {
    return result.answer ? "yes\n" : "no\n";
  }
  const TextRows lines = FormatCells(result);
  // Widths count characters, not bytes.
  std::vector<std::size_t> widths(result.variables.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      widths[i] = std::max(widths[i], kg_base::Utf8Length(line[i]));
    }
  }
  std::string out = PaddedLine(lines[0], widths);
  std::vector<std::string> rule;
  rule.reserve(widths.size());
  for (const std::size_t width : widths) rule.emplace_back(width, '-');
  out += PaddedLine(rule, widths);
  for (std::size_t i = 1; i < lines.size(); ++i) {
    out += PaddedLine(lines[i], widths);
  }
  const std::size_t rows = result.rows.size();
  return out + std::to_string(rows) + (rows == 1 ? " row\n" : " rows\n");
}

}  // namespace kg_core
