#include "kg_mission/mission/stage_vocabulary.h"

#include <filesystem>

#include "kg_base/common/input_error.h"
#include "kg_base/common/sha256.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/turtle.h"
#include "kg_mission/mission/mission_rules.h"

namespace kg_mission {
namespace {

using kg_core::SourceFile;
using kg_core::Statement;

constexpr const char* kOntologyFiles[] = {"mission.ttl", "shapes.ttl",
                                          "rules.ttl"};

std::vector<SourceFile> ListFiles(const std::string& folder) {
  std::vector<SourceFile> files;
  for (const char* name : kOntologyFiles) {
    const std::string path =
        std::filesystem::absolute(folder + "/" + name).lexically_normal();
    files.push_back({"", path, kg_base::Sha256HexOfFile(path)});
  }
  return files;
}

// Statement that records the version of the files in the vocabulary graph.
Statement ComputeVersion(const std::vector<SourceFile>& files) {
  kg_base::Hasher hasher;
  for (const SourceFile& file : files) hasher.Add(file.sha256);
  return {kg_core::Ex("ontology"), kg_core::Ex("sha256"),
          kg_core::Literal(hasher.Hex()), kg_core::Iri(kg_core::kVocabGraph)};
}

}  // namespace

std::vector<SourceFile> StageVocabulary(const std::string& folder,
                                        kg_core::Transaction& transaction) {
  const kg_core::Term graph = kg_core::Iri(kg_core::kVocabGraph);
  std::vector<SourceFile> files = ListFiles(folder);
  const Statement version = ComputeVersion(files);
  if (kg_core::Has(transaction.view(), kg_core::kVocabGraph, version.subject,
                   version.predicate, version.object)) {
    return {};
  }
  transaction.RemoveMatching(nullptr, nullptr, nullptr, graph);
  for (const SourceFile& file : files) {
    for (const Statement& statement :
         kg_core::ParseTurtleFile(file.path, graph)) {
      transaction.Add(statement);
    }
  }
  transaction.Add(version);
  const std::vector<std::string> reasons = StageMissionRules(transaction);
  if (!reasons.empty()) {
    throw kg_base::InputError(folder + ": " + reasons.front());
  }
  return files;
}

}  // namespace kg_mission
