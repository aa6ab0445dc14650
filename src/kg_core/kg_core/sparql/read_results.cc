// JSON, CSV and TSV; XML is in read_results_xml.cc.

#include "kg_core/sparql/read_results.h"

#include <algorithm>
#include <string>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/text/json.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {
namespace {

using kg_base::InputError;

using kg_base::JsonValue;

const JsonValue& Member(const JsonValue& object, const char* name,
                        JsonValue::Kind kind) {
  const JsonValue* member = object.Find(name);
  if (member == nullptr || member->kind != kind) {
    throw InputError("JSON result: expected a member \"" + std::string(name) +
                     "\" of the right type");
  }
  return *member;
}

std::string GetText(const JsonValue& object, const char* name) {
  return Member(object, name, JsonValue::Kind::kString).text;
}

// https://www.w3.org/TR/sparql11-results-json/#select-encode-terms
Term MakeTerm(const JsonValue& object) {
  const std::string type = GetText(object, "type");
  const std::string text = GetText(object, "value");
  if (type == "uri") return Iri(text);
  if (type == "bnode") return Blank(text);
  if (type != "literal" && type != "typed-literal") {
    throw InputError("JSON result: expected uri, bnode or literal, got " +
                     type);
  }
  if (object.Find("xml:lang") != nullptr) {
    return LanguageLiteral(text, GetText(object, "xml:lang"));
  }
  if (object.Find("datatype") == nullptr) return Literal(text);
  return Literal(text, GetText(object, "datatype"));
}

std::vector<std::optional<Term>> MakeRow(
    const JsonValue& binding, const std::vector<std::string>& variables) {
  std::vector<std::optional<Term>> row(variables.size());
  for (const auto& [name, term] : binding.members) {
    const auto found = std::find(variables.begin(), variables.end(), name);
    if (found == variables.end()) {
      throw InputError("JSON result: ?" + name + " is not in \"vars\"");
    }
    row[static_cast<std::size_t>(found - variables.begin())] = MakeTerm(term);
  }
  return row;
}

// The fields of CSV (RFC 4180), one vector per record; quoted fields may
// contain line breaks.
std::vector<std::vector<std::string>> CsvRecords(std::string_view text) {
  std::vector<std::vector<std::string>> records;
  bool quoted = false;
  bool at_start = true;  // At the start of a record.
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (at_start) records.push_back({""});
    at_start = false;
    const char c = text[i];
    if (quoted && c == '"' && i + 1 < text.size() && text[i + 1] == '"') {
      records.back().back().push_back(text[++i]);
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && c == ',') {
      records.back().emplace_back();
    } else if (!quoted && c == '\n') {
      at_start = true;
    } else if (quoted || c != '\r') {
      records.back().back().push_back(c);
    }
  }
  if (quoted) throw InputError("CSV result: a quote is not closed");
  return records;
}

std::vector<std::vector<std::string>> TsvRecords(std::string_view text) {
  std::vector<std::vector<std::string>> records;
  bool at_start = true;
  for (const char c : text) {
    if (at_start) records.push_back({""});
    at_start = c == '\n';
    if (c == '\t') {
      records.back().emplace_back();
    } else if (c != '\n' && c != '\r') {
      records.back().back().push_back(c);
    }
  }
  return records;
}

using TermReader = Term (*)(std::string_view text);

QueryResult FromRecords(std::vector<std::vector<std::string>> records,
                        TermReader read, const char* format) {
  QueryResult result;
  if (records.empty()) {
    throw InputError(std::string(format) + " result: expected a first line");
  }
  for (std::string& name : records[0]) {
    if (name.empty() && records[0].size() == 1) break;  // No variables.
    result.variables.push_back(name[0] == '?' ? name.substr(1) : name);
  }
  for (std::size_t line = 1; line < records.size(); ++line) {
    std::vector<std::string>& fields = records[line];
    if (result.variables.empty() && fields[0].empty()) fields.clear();
    if (fields.size() != result.variables.size()) {
      throw InputError(std::string(format) + " result: record " +
                       std::to_string(line) + " has " +
                       std::to_string(fields.size()) + " fields, expected " +
                       std::to_string(result.variables.size()));
    }
    result.rows.emplace_back();
    for (const std::string& field : fields) {
      result.rows.back().push_back(
          field.empty() ? std::nullopt : std::optional<Term>(read(field)));
    }
  }
  return result;
}

Term ReadCsvTerm(std::string_view text) { return Literal(std::string(text)); }

Term ReadTsvTerm(std::string_view text) {
  if (text.substr(0, 2) == "_:") return Blank(std::string(text.substr(2)));
  return ParseTurtleTerm(text);
}

}  // namespace

QueryResult ReadJsonResult(std::string_view text) {
  const JsonValue json = kg_base::ParseJson(text);
  QueryResult result;
  // A result of ASK has no bindings.
  if (const JsonValue* answer = json.Find("boolean")) {
    result.form = QueryResult::Form::kAsk;
    result.answer = answer->boolean;
    return result;
  }
  const JsonValue& head = Member(json, "head", JsonValue::Kind::kObject);
  for (const JsonValue& name :
       Member(head, "vars", JsonValue::Kind::kArray).items) {
    result.variables.push_back(name.text);
  }
  const JsonValue& results = Member(json, "results", JsonValue::Kind::kObject);
  const JsonValue& rows = Member(results, "bindings", JsonValue::Kind::kArray);
  for (const JsonValue& binding : rows.items) {
    result.rows.push_back(MakeRow(binding, result.variables));
  }
  return result;
}

QueryResult ReadCsvResult(std::string_view text) {
  return FromRecords(CsvRecords(text), ReadCsvTerm, "CSV");
}

QueryResult ReadTsvResult(std::string_view text) {
  return FromRecords(TsvRecords(text), ReadTsvTerm, "TSV");
}

}  // namespace kg_core
