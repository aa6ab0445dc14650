#include "kg_engine/command/target.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_engine/state/mission_state.h"
#include "kg_mission/mission/ingest.h"
#include "kg_mission/mission/stage_update.h"
#include "kg_mission/mission/stage_vocabulary.h"

namespace kg_engine::command {
namespace {

namespace fs = std::filesystem;
using kg_base::InputError;
using kg_core::Transaction;
using kg_core::WorldChange;

constexpr char kStoreName[] = "store.db";
constexpr char kMissionName[] = "mission.ttl";

bool IsOntology(const fs::path& folder) {
  return fs::exists(folder / "mission.ttl") &&
         fs::exists(folder / "shapes.ttl");
}

// Candidate folders of the ontology: the install prefix of the program, or that
// of kg_mission if every package has its own; the sources listed in a
// development space's prefix/.catkin; the source folder of the build.
std::vector<fs::path> OntologyPlaces() {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  const fs::path prefix = program.parent_path().parent_path().parent_path();
  std::vector<fs::path> places = {
      prefix / "share/kg_mission/ontology",
      prefix.parent_path() / "kg_mission/share/kg_mission/ontology"};
  std::ifstream catkin(prefix / ".catkin");
  for (std::string source; std::getline(catkin, source, ';');) {
    places.push_back(fs::path(source) / "kg_mission/ontology");
  }
  places.emplace_back(KG_ONTOLOGY_FOLDER);
  return places;
}

void StageOntology(kg_core::Store* store) {
  Transaction transaction = store->Begin();
  kg_mission::StageVocabulary(OntologyFolder(), transaction);
  if (!transaction.empty()) transaction.Commit(WorldChange::kYes);
}

// What the files of the mission say, if they are there.
void Ingest(kg_mission::FileCache files, kg_core::Store* store) {
  Transaction transaction = store->Begin();
  std::string reason;
  try {
    reason =
        kg_base::JoinStrings(kg_mission::StageIngest(files, transaction), "; ");
  } catch (const InputError& error) {
    reason = error.what();
  }
  if (reason.empty()) {
    transaction.Commit(WorldChange::kYes);
  } else {
    std::cerr << "kg: what the mission's files say is left out: " << reason
              << std::endl;
  }
}

Target ReadMissionFolder(const fs::path& folder,
                         const std::string& data_folder) {
  Target target;
  target.mission_folder = folder;
  target.store = std::make_unique<kg_core::Store>("");
  StageOntology(target.store.get());
  {
    Transaction transaction = target.store->Begin();
    const auto reasons =
        kg_mission::StageFactsFile(folder / kMissionName, transaction);
    if (!reasons.empty()) throw InputError(kg_base::JoinStrings(reasons, "; "));
    transaction.Commit(WorldChange::kYes);
  }
  Ingest({folder, data_folder}, target.store.get());
  return target;
}

Target OpenStoreFile(const fs::path& file) {
  Target target;
  try {
    target.store = std::make_unique<kg_core::Store>(file);
  } catch (const InputError& error) {
    const std::string what = error.what();
    if (what.find("in use") == std::string::npos) throw;
    throw InputError(what +
                     "; while kg_node runs, ask it by its services kg/query "
                     "and kg/update");
  }
  target.mission_folder = LoadState(*target.store->Read()).mission_folder;
  return target;
}

}  // namespace

std::string OntologyFolder() {
  for (const fs::path& place : OntologyPlaces()) {
    if (IsOntology(place)) return place;
  }
  throw InputError(
      "the ontology of kg_core (mission.ttl, shapes.ttl) is not found; looked "
      "in " +
      kg_base::JoinStrings(OntologyPlaces(), ", ", [](const fs::path& place) {
        return place.string();
      }));
}

Target OpenStore(const std::string& path) {
  const fs::path file =
      fs::is_directory(path) ? path / fs::path(kStoreName) : fs::path(path);
  if (fs::exists(file)) return OpenStoreFile(file);
  throw InputError(path + ": expected a store, or a folder with " + kStoreName);
}

Target OpenOrMakeStore(const std::string& path) {
  if (fs::exists(path) || fs::path(path).extension() != ".db") {
    return OpenStore(path);
  }
  Target target = OpenStoreFile(path);
  StageOntology(target.store.get());
  return target;
}

bool IsMissionFolder(const std::string& path) {
  const fs::path folder = path;
  return fs::exists(folder / kMissionName) && !fs::exists(folder / kStoreName);
}

Target OpenTarget(const std::string& path, const std::string& data_folder) {
  const fs::path folder = path;
  if (IsMissionFolder(path)) return ReadMissionFolder(folder, data_folder);
  if (fs::is_directory(folder) && !fs::exists(folder / kStoreName)) {
    throw InputError(path + ": expected a store, or a folder with " +
                     kStoreName + " or " + kMissionName);
  }
  return OpenStore(path);
}

}  // namespace kg_engine::command
