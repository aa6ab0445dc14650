#include "kg_core/mission/stage_vocabulary.h"

#include <filesystem>

#include "kg_core/base/input_error.h"
#include "kg_core/base/sha256.h"
#include "kg_core/facts/terms.h"
#include "kg_core/mission/mission_rules.h"
#include "kg_core/rdf/turtle.h"

namespace kg_core {
namespace {

constexpr const char* kOntologyFiles[] = {"mission.ttl", "shapes.ttl",
                                          "rules.ttl"};

std::vector<SourceFile> ListFiles(const std::string& folder) {
  std::vector<SourceFile> files;
  for (const char* name : kOntologyFiles) {
    const std::string path =
        std::filesystem::absolute(folder + "/" + name).lexically_normal();
    files.push_back({"", path, Sha256HexOfFile(path)});
  }
  return files;
}

// States which version of the files the vocabulary graph holds.
Statement ComputeVersion(const std::vector<SourceFile>& files) {
  Hasher hasher;
  for (const SourceFile& file : files) hasher.Add(file.sha256);
  return {Ex("ontology"), Ex("sha256"), Literal(hasher.Hex()),
          Iri(kVocabGraph)};
}

}  // namespace

std::vector<SourceFile> StageVocabulary(const std::string& folder,
                                        Transaction& transaction) {
  const Term graph = Iri(kVocabGraph);
  std::vector<SourceFile> files = ListFiles(folder);
  const Statement version = ComputeVersion(files);
  if (Has(transaction.view(), kVocabGraph, version.subject, version.predicate,
          version.object)) {
    return {};
  }
  transaction.RemoveMatching(nullptr, nullptr, nullptr, graph);
  for (const SourceFile& file : files) {
    for (const Statement& statement : ParseTurtleFile(file.path, graph)) {
      transaction.Add(statement);
    }
  }
  transaction.Add(version);
  const std::vector<std::string> reasons = StageMissionRules(transaction);
  if (!reasons.empty()) throw InputError(folder + ": " + reasons.front());
  return files;
}

}  // namespace kg_core
