// kg validate TARGET|FILE

#include <iostream>

#include "kg_base/common/input_error.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/explain/fact_warnings.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/command/change.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"
#include "kg_mission/mission/data_quality.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/mission_reader.h"
#include "kg_mission/mission/stage_update.h"
#include "kg_mission/mission/stage_vocabulary.h"
#include "kg_mission/mission/validator.h"

namespace kg_engine::command {
namespace {

using kg_core::Violation;

int Show(const std::vector<Violation>& violations, bool as_report) {
  if (as_report) {
    std::cout << kg_core::ReportTurtle(violations);
  } else {
    for (const Violation& violation : violations) {
      std::cout << violation.Line() << "\n";
    }
    std::cout << violations.size() << " violations\n";
  }
  return violations.empty() ? kDone : kRefused;
}

// Validates the file as a mission's facts; with `as_report` against the shapes
// only.
int ValidateFile(const std::string& file, bool as_report) {
  kg_core::Store store("");
  kg_core::Transaction transaction = store.Begin();
  kg_mission::StageVocabulary(OntologyFolder(), transaction);
  if (as_report) {
    const kg_core::Term facts = kg_core::Iri(kg_core::kFactsGraph);
    for (const kg_core::Statement& s : kg_core::ParseRdfFile(file, facts)) {
      transaction.Add(s);
    }
    return Show(kg_mission::Validate(transaction.view()), true);
  }
  const auto reasons = kg_mission::StageFactsFile(file, transaction);
  for (const std::string& reason : reasons) std::cout << reason << "\n";
  std::cout << reasons.size() << " violations\n";
  return reasons.empty() ? kDone : kRefused;
}

void TellWarnings(const std::vector<std::string>& warnings) {
  for (const std::string& line : warnings) {
    std::cout << "warning: " << line << "\n";
  }
}

// What was read of the files, and what is doubtful about it.
void TellData(const kg_core::GraphView& view) {
  for (const kg_mission::DataSummary& data : kg_mission::SummarizeData(view)) {
    std::cout << "data: " << data.what << ": " << data.text << "\n";
  }
  TellWarnings(kg_mission::DataWarnings(view));
}

// Compiles the mission; returns why that fails.
std::vector<std::string> CompileForWarnings(
    const kg_core::GraphView& view, kg_mission::FileCache* files,
    std::vector<std::string>* warnings) {
  try {
    const kg_mission::Mission mission = kg_mission::ReadMission(view);
    kg_compiler::MissionCompiler compiler(files);
    *warnings = kg_compiler::Lines(kg_compiler::FindWarnings(
        *compiler.Compile(mission, view.world_version(), 0)));
  } catch (const kg_base::InputError& error) {
    return {error.what()};
  }
  return {};
}

// Everything of a mission folder that would have a node refuse it: its facts,
// what its files say, and the mission that they are together. Warnings about
// facts without effect follow.
int ValidateMission(const std::string& folder, const std::string& data_folder) {
  kg_core::Store store("");
  kg_core::Transaction transaction = store.Begin();
  kg_mission::StageVocabulary(OntologyFolder(), transaction);
  std::vector<std::string> reasons =
      kg_mission::StageFactsFile(folder + "/mission.ttl", transaction);
  std::vector<std::string> warnings;
  if (reasons.empty()) {
    kg_mission::FileCache files(folder, data_folder);
    const std::vector<std::string> missing =
        kg_mission::FindMissingFiles(files, transaction.view());
    for (const std::string& file : missing) {
      std::cerr << "kg: what the mission's files say is left out: " << file
                << "\n";
    }
    if (missing.empty()) {
      reasons = kg_mission::StageIngest(files, transaction);
      if (reasons.empty()) {
        reasons = CompileForWarnings(transaction.view(), &files, &warnings);
      }
    }
  }
  TellData(transaction.view());
  for (const std::string& reason : reasons) std::cout << reason << "\n";
  TellWarnings(warnings);
  std::cout << reasons.size() << " violations\n";
  return reasons.empty() ? kDone : kRefused;
}

// The shapes of a store's facts; warnings, if they are a mission that compiles.
int ValidateStore(const std::string& path, const std::string& data_folder,
                  bool as_report) {
  const Target target = OpenTarget(path, data_folder);
  const auto view = target.store->Read();
  if (!as_report && HoldsMission(*view)) {
    kg_mission::FileCache files(target.mission_folder, data_folder);
    std::vector<std::string> warnings;
    for (const std::string& reason :
         CompileForWarnings(*view, &files, &warnings)) {
      warnings.push_back("not compiled: " + reason);
    }
    TellData(*view);
    TellWarnings(warnings);
  }
  return Show(kg_mission::Validate(*view), as_report);
}

int RunValidate(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "one TARGET or file");
  const std::string& path = arguments.words[0];
  const bool as_report = arguments.Has("--report");
  if (IsMissionFolder(path) && !as_report) {
    return ValidateMission(path, arguments.One("--data").value_or(""));
  }
  if (IsMissionFolder(path)) return ValidateFile(path + "/mission.ttl", true);
  if (kg_core::SyntaxOfPath(path) != nullptr) {
    return ValidateFile(path, as_report);
  }
  return ValidateStore(path, arguments.One("--data").value_or(""), as_report);
}

}  // namespace

const Subcommand kValidate = {
    "validate",
    "TARGET|FILE [--report] [--data FOLDER]",
    "check facts against the shapes; status 1 if there is a violation",
    "FILE is Turtle, as mission.ttl is. All violations of a file or a mission\n"
    "are listed: of the shapes, of the ontology, and facts that are not a\n"
    "mission. Of a mission folder, its files are read, too: what was read of\n"
    "each is a line; doubts about it and facts without effect are warnings.\n\n"
    "  --report       a W3C SHACL validation report in Turtle\n"
    "  --data FOLDER  where a mission's files are looked up first\n",
    {{"--report"}, {"--data", true}},
    RunValidate};

}  // namespace kg_engine::command
