#include "kg_engine/conformance/result_set.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/sparql/isomorphism.h"
#include "kg_core/sparql/read_results.h"
#include "kg_core/sparql/results.h"
#include "kg_core/sparql/values.h"
#include "kg_engine/conformance/documents.h"

namespace kg_engine::conformance {
namespace {

using kg_core::Blank;
using kg_core::Iri;
using kg_core::IsIsomorphic;
using kg_core::QueryResult;
using kg_core::Term;

using Statements = std::vector<kg_core::Statement>;
using Row = std::vector<std::optional<Term>>;

struct SyntaxFormat {
  const char* suffix;
  std::string (*write)(const QueryResult&);
  QueryResult (*read)(std::string_view);
};
constexpr SyntaxFormat kFormats[] = {
    {".srx", kg_core::ToXml, kg_core::ReadXmlResult},
    {".srj", kg_core::ToJson, kg_core::ReadJsonResult},
    {".tsv", kg_core::ToTsv, kg_core::ReadTsvResult},
    {".csv", kg_core::ToCsv, kg_core::ReadCsvResult}};

const SyntaxFormat* FindFormat(const std::string& url) {
  const std::string suffix = std::filesystem::path(url).extension();
  for (const SyntaxFormat& format : kFormats) {
    if (suffix == format.suffix) return &format;
  }
  return nullptr;
}

// Restores blank nodes, which CSV writes as text.
QueryResult WithBlanks(QueryResult result) {
  for (Row& row : result.rows) {
    for (std::optional<Term>& term : row) {
      if (term && term->text.rfind("_:", 0) == 0) {
        term = Blank(term->text.substr(2));
      }
    }
  }
  return result;
}

QueryResult Read(const SyntaxFormat& format, std::string_view text) {
  QueryResult result = format.read(text);
  const bool is_csv = std::string_view(format.suffix) == ".csv";
  return is_csv ? WithBlanks(std::move(result)) : result;
}

// Reads the one rs:ResultSet of a document.
class ResultSetReader {
 public:
  ResultSetReader(const DocumentStore& documents, const std::string& url)
      : documents_(documents), url_(url) {}

  void Read(const Term& set, ExpectedResult* expected) {
    const auto answer = One(set, "boolean");
    if (answer) {
      expected->result.form = kg_core::QueryResult::Form::kAsk;
      expected->result.answer = answer->text == "true" || answer->text == "1";
      return;
    }
    for (const Term& name : All(set, "resultVariable")) {
      expected->result.variables.push_back(name.text);
    }
    std::vector<std::pair<double, Row>> rows;
    for (const Term& solution : All(set, "solution")) {
      const auto index = One(solution, "index");
      expected->is_ordered |= index.has_value();
      const auto number = index ? kg_core::NumericValue(*index) : std::nullopt;
      rows.emplace_back(number.value_or(0),
                        ReadRow(solution, expected->result.variables));
    }
    std::stable_sort(
        rows.begin(), rows.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
    for (auto& row : rows) {
      expected->result.rows.push_back(std::move(row.second));
    }
  }

 private:
  Row ReadRow(const Term& solution, const std::vector<std::string>& variables) {
    Row row(variables.size());
    for (const Term& binding : All(solution, "binding")) {
      const auto name = One(binding, "variable");
      const auto found = std::find(variables.begin(), variables.end(),
                                   name ? name->text : std::string());
      if (found == variables.end()) {
        throw kg_base::InputError(url_ + ": a binding of no rs:resultVariable");
      }
      row[static_cast<std::size_t>(found - variables.begin())] =
          One(binding, "value");
    }
    return row;
  }
  std::optional<Term> One(const Term& node, const char* local) const {
    return documents_.One(url_, node, std::string(kRs) + local);
  }
  std::vector<Term> All(const Term& node, const char* local) const {
    return documents_.All(url_, node, std::string(kRs) + local);
  }

  const DocumentStore& documents_;
  const std::string& url_;
};

// Canonical form: numbers by value; blank node labels prefixed to differ from
// those of rows.
Term Canonical(const Term& term) {
  if (term.is_blank()) return Blank("result" + term.text);
  const auto number = kg_core::sparql::ToNumber(term);
  return number ? kg_core::sparql::ToTerm(*number) : term;
}

// Rows as statements about one blank node each, so that they compare as a bag
// and share their blank nodes.
Statements CollectRows(const QueryResult& result, bool is_ordered) {
  const Term graph = Iri(kDefaultGraph);
  Statements statements;
  for (std::size_t i = 0; i < result.rows.size(); ++i) {
    const Term row = Blank("row" + std::to_string(i));
    const Term place =
        kg_core::IntegerLiteral(is_ordered ? static_cast<long long>(i) : 0);
    statements.push_back({row, Iri("urn:is"), place, graph});
    for (std::size_t j = 0; j < result.variables.size(); ++j) {
      if (!result.rows[i][j]) continue;
      statements.push_back({row, Iri("urn:var:" + result.variables[j]),
                            Canonical(*result.rows[i][j]), graph});
    }
  }
  return statements;
}

std::set<std::string> CollectNames(const QueryResult& result) {
  return {result.variables.begin(), result.variables.end()};
}

std::string FormatLine(const QueryResult& result, const Row& row) {
  std::set<std::string> cells;
  for (std::size_t i = 0; i < row.size(); ++i) {
    if (!row[i]) continue;
    const bool is_blank = row[i]->is_blank();
    cells.insert("?" + result.variables[i] + " " +
                 (is_blank ? "_:" : kg_core::ToTurtle(Canonical(*row[i]))));
  }
  return "{" + kg_base::JoinStrings({cells.begin(), cells.end()}) + "}";
}

using Lines = std::multiset<std::string>;

Lines FormatLines(const QueryResult& result) {
  Lines lines;
  for (const Row& row : result.rows) lines.insert(FormatLine(result, row));
  return lines;
}

Lines FormatLines(const Statements& statements) {
  Lines lines;
  for (const kg_core::Statement& s : statements) {
    std::string line;
    for (const Term* term : {&s.subject, &s.predicate, &s.object}) {
      line += (term->is_blank() ? "_:" : kg_core::ToTurtle(*term)) + " ";
    }
    lines.insert(line + ".");
  }
  return lines;
}

// First line that occurs on one side only.
std::string FirstOnly(const Lines& got, const Lines& want) {
  for (const std::string& line : want) {
    if (got.count(line) < want.count(line)) return "; lacks " + line;
  }
  for (const std::string& line : got) {
    if (want.count(line) < got.count(line)) return "; has " + line;
  }
  return "; differs in blank nodes or order";
}

std::string Sizes(std::size_t got, std::size_t want, const char* what) {
  return "got " + std::to_string(got) + " " + what + ", expected " +
         std::to_string(want);
}

QueryResult Distinct(const QueryResult& result) {
  QueryResult distinct = result;
  distinct.rows.clear();
  for (const Row& row : result.rows) {
    const auto& rows = distinct.rows;
    if (std::find(rows.begin(), rows.end(), row) == rows.end()) {
      distinct.rows.push_back(row);
    }
  }
  return distinct;
}

bool IsGraph(const QueryResult& result) {
  return result.form == kg_core::QueryResult::Form::kConstruct ||
         result.form == kg_core::QueryResult::Form::kDescribe;
}

}  // namespace

ExpectedResult ReadExpected(const std::string& url) {
  ExpectedResult expected;
  if (const SyntaxFormat* format = FindFormat(url)) {
    expected.result = Read(*format, GetText(url));
    return expected;
  }
  DocumentStore documents;
  documents.Load(url);
  const auto sets = documents.OfType(url, std::string(kRs) + "ResultSet");
  if (sets.empty()) {
    expected.result.form = kg_core::QueryResult::Form::kConstruct;
    expected.statements = CollectStatements(url, kDefaultGraph);
  } else {
    ResultSetReader(documents, url).Read(sets[0], &expected);
  }
  return expected;
}

QueryResult ThroughFormat(const QueryResult& got, const std::string& url) {
  const SyntaxFormat* format = FindFormat(url);
  return format == nullptr ? got : Read(*format, format->write(got));
}

std::string Difference(const Statements& got, const Statements& want) {
  if (IsIsomorphic(got, want)) return "";
  return Sizes(got.size(), want.size(), "triples") +
         FirstOnly(FormatLines(got), FormatLines(want));
}

std::string Difference(const QueryResult& got, const ExpectedResult& expected,
                       bool is_lax) {
  const QueryResult& want = expected.result;
  if (IsGraph(got) != IsGraph(want) ||
      (got.form == kg_core::QueryResult::Form::kAsk) !=
          (want.form == kg_core::QueryResult::Form::kAsk)) {
    return "got another form of result than expected";
  }
  if (IsGraph(got)) {
    Statements statements;
    for (const kg_core::Triple& t : got.triples) {
      statements.push_back(
          {t.subject, t.predicate, t.object, Iri(kDefaultGraph)});
    }
    return Difference(statements, expected.statements);
  }
  if (got.form == kg_core::QueryResult::Form::kAsk) {
    if (got.answer == want.answer) return "";
    return std::string("got ") + (got.answer ? "yes" : "no");
  }
  if (CollectNames(got) != CollectNames(want)) {
    return "got other variables than expected";
  }
  const bool is_same =
      is_lax ? IsIsomorphic(CollectRows(Distinct(got), false),
                            CollectRows(Distinct(want), false)) &&
                   got.rows.size() <= want.rows.size()
             : IsIsomorphic(CollectRows(got, expected.is_ordered),
                            CollectRows(want, expected.is_ordered));
  if (is_same) return "";
  return Sizes(got.rows.size(), want.rows.size(), "rows") +
         FirstOnly(FormatLines(got), FormatLines(want));
}

}  // namespace kg_engine::conformance
