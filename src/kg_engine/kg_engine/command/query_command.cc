// kg query TARGET [FILE.rq | -e TEXT]

#include <iostream>
#include <iterator>

#include "kg_base/common/input_error.h"
#include "kg_base/common/text.h"
#include "kg_core/sparql/query_engine.h"
#include "kg_core/sparql/results.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"
#include "kg_engine/state/mission_state.h"
#include "kg_engine/terms/plan_names.h"

namespace kg_engine::command {
namespace {

using kg_core::QueryResult;

constexpr std::size_t kMaxQueryBytes = 1u << 20;

// Query text from -e TEXT, a file, or standard input.
std::string QueryText(const Arguments& arguments) {
  const auto text = arguments.One("-e");
  if (text && arguments.words.size() > 1) {
    throw UsageError("expected a file or -e, not both");
  }
  if (text) return *text;
  if (arguments.words.size() > 1) {
    return kg_base::ReadFile(arguments.words[1], kMaxQueryBytes);
  }
  return {std::istreambuf_iterator<char>(std::cin), {}};
}

bool IsGraph(const QueryResult& result) {
  return result.form == QueryResult::Form::kConstruct ||
         result.form == QueryResult::Form::kDescribe;
}

std::string Written(const QueryResult& result, const std::string& format) {
  if (format == "turtle" && IsGraph(result)) {
    return kg_core::TriplesToTurtle(result.triples);
  }
  if (format == "turtle") {
    throw kg_base::InputError("only CONSTRUCT and DESCRIBE give Turtle");
  }
  for (const kg_core::ResultFormat& known : kg_core::ResultFormats()) {
    if (format == known.name) return known.write(result);
  }
  throw UsageError("unknown format " + format +
                   "; expected text, json, xml, csv, tsv or turtle");
}

int RunQuery(const Arguments& arguments) {
  arguments.ExpectWords(1, 2, "TARGET and at most one file");
  const std::string format = arguments.One("--format").value_or("text");
  const std::string text = QueryText(arguments);
  const Target target =
      OpenTarget(arguments.words[0], arguments.One("--data").value_or(""));
  const auto view = target.store->Read();
  const std::uint64_t run = LoadState(*view).plan_run;
  const auto plan =
      run == 0 ? std::nullopt : std::optional(PlanGraph(run).text);
  const std::string out =
      Written(kg_core::RunQuery(*view, text, kg_core::DefaultDataset(plan), {}),
              format);
  std::cout << out << (out.empty() || out.back() == '\n' ? "" : "\n");
  return kDone;
}

}  // namespace

const Subcommand kQuery = {
    "query",
    "TARGET [FILE.rq | -e TEXT] [--format FORMAT] [--data FOLDER]",
    "ask in SPARQL 1.1",
    "Reads the query from FILE.rq, from TEXT, or from standard input. Our\n"
    "prefixes (ex, prov, time, geo, ...) are known undeclared.\n\n"
    "  --format FORMAT  text (the default), json, xml, csv, tsv; turtle for\n"
    "                   CONSTRUCT and DESCRIBE\n"
    "  --data FOLDER    where a mission's files are looked up first\n",
    {{"-e", true}, {"--format", true}, {"--data", true}},
    RunQuery};

}  // namespace kg_engine::command
