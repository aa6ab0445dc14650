// kg validate TARGET|FILE

#include <iostream>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/syntax.h"
#include "kg_engine/command/command.h"
#include "kg_engine/command/target.h"
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

int RunValidate(const Arguments& arguments) {
  arguments.ExpectWords(1, 1, "one TARGET or file");
  const std::string& path = arguments.words[0];
  const bool as_report = arguments.Has("--report");
  if (IsMissionFolder(path)) {
    return ValidateFile(path + "/mission.ttl", as_report);
  }
  if (kg_core::SyntaxOfPath(path) != nullptr) {
    return ValidateFile(path, as_report);
  }
  const Target target = OpenTarget(path, "");
  return Show(kg_mission::Validate(*target.store->Read()), as_report);
}

}  // namespace

const Subcommand kValidate = {
    "validate",
    "TARGET|FILE [--report]",
    "check facts against the shapes; status 1 if there is a violation",
    "FILE is Turtle, as mission.ttl is. All violations of a file or a mission\n"
    "are listed: of the shapes, of the ontology, and facts that are not a\n"
    "mission.\n\n"
    "  --report  a W3C SHACL validation report in Turtle\n",
    {{"--report"}},
    RunValidate};

}  // namespace kg_engine::command
