#include "kg_core/rdf/record.h"

#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "kg_base/common/input_error.h"
#include "kg_core/rdf/dictionary.h"

namespace kg_core {
namespace {

using kg_base::InputError;

namespace fs = std::filesystem;

// "KGS1" in ASCII: application id in the file header, also shown by file(1) and
// SQLite.
constexpr std::uint32_t kApplicationId = 0x4B475331;
constexpr std::uint32_t kSchemaVersion = 1;
constexpr char kSchema[] = R"(
  PRAGMA journal_mode = WAL;
  BEGIN;
  PRAGMA application_id = 1262965553;
  PRAGMA user_version = 1;
  CREATE TABLE term (
    id INTEGER PRIMARY KEY, kind INTEGER NOT NULL, text BLOB NOT NULL,
    datatype BLOB NOT NULL, language BLOB NOT NULL) STRICT;
  CREATE TABLE quad (
    subject INTEGER NOT NULL, predicate INTEGER NOT NULL,
    object INTEGER NOT NULL, graph INTEGER NOT NULL,
    PRIMARY KEY (subject, predicate, object, graph)) STRICT, WITHOUT ROWID;
  CREATE TABLE world (version INTEGER NOT NULL, digest INTEGER NOT NULL) STRICT;
  INSERT INTO world VALUES (0, 0);
  COMMIT;
)";
static_assert(kApplicationId == 1262965553 && kSchemaVersion == 1);

// The finalizer of SplitMix64: every bit of the result depends on every bit of
// the input.
std::uint64_t Mix(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EB;
  return x ^ (x >> 31);
}

std::uint64_t HashBytes(std::uint64_t hash, std::string_view bytes) {
  for (const char c : bytes) {  // FNV-1a.
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001B3;
  }
  return Mix(hash ^ bytes.size());
}

std::uint64_t ComputeHash(TermId id, const Term& term) {
  std::uint64_t hash =
      Mix(std::uint64_t{id} << 8 | static_cast<int>(term.kind));
  hash = HashBytes(hash, term.text);
  hash = HashBytes(hash, term.datatype);
  return HashBytes(hash, term.language);
}

std::uint64_t ComputeHash(const Quad& quad) {
  const std::uint64_t first =
      Mix(std::uint64_t{quad.subject} << 32 | quad.predicate);
  return Mix(first ^ (std::uint64_t{quad.object} << 32 | quad.graph));
}

// An empty store at world version 0 has digest 0.
std::uint64_t ComputeDigest(std::uint64_t sum, std::uint64_t world_version) {
  return world_version == 0 ? sum : sum + Mix(world_version ^ sum);
}

[[noreturn]] void RefuseDamage(const std::string& path,
                               const std::string& what) {
  throw InputError(path + ": damaged store (" + what +
                   "); expected one that passes its checks, restore a copy");
}

// Checks the file header before SQLite opens the file, because SQLite could
// change a foreign file.
void CheckHeader(const std::string& path) {
  unsigned char header[100] = {};
  std::ifstream file(path, std::ios::binary);
  file.read(reinterpret_cast<char*>(header), sizeof(header));
  // SQLite's header has big-endian numbers: application id at 68, user version
  // at 60.
  const auto number_at = [&](int offset) {
    return std::uint32_t{header[offset]} << 24 |
           std::uint32_t{header[offset + 1]} << 16 |
           std::uint32_t{header[offset + 2]} << 8 | header[offset + 3];
  };
  const bool is_ours = file.gcount() == sizeof(header) &&
                       std::memcmp(header, "SQLite format 3", 16) == 0 &&
                       number_at(68) == kApplicationId;
  if (!is_ours) {
    throw InputError(path +
                     ": is not a store of this program, or its head is " +
                     "damaged; expected a store or no file");
  }
  if (number_at(60) != kSchemaVersion) {
    throw InputError(path + ": has store schema " +
                     std::to_string(number_at(60)) + "; expected " +
                     std::to_string(kSchemaVersion));
  }
}

void SyncParentFolder(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY);
  if (descriptor < 0) return;
  fsync(descriptor);
  close(descriptor);
}

// Creates a temporary file and renames it, so that a crash leaves either a
// complete store or none, and never an empty file.
void CreateStore(const std::string& path) {
  const std::string aside = path + ".new." + std::to_string(getpid());
  fs::remove(aside);
  SqliteDatabase(aside, true).Execute(kSchema);
  const int result = renameat2(AT_FDCWD, aside.c_str(), AT_FDCWD, path.c_str(),
                               RENAME_NOREPLACE);
  const int error = errno;
  if (result != 0) fs::remove(aside);
  // EEXIST: another process created it first.
  if (result != 0 && error != EEXIST) {
    throw InputError(path + ": cannot be created: " + std::strerror(error));
  }
  SyncParentFolder(path);
}

// Returns `path` after making sure that the file exists and has the header of a
// store.
const std::string& ReadyPath(const std::string& path) {
  try {
    if (!fs::exists(path)) {
      if (fs::exists(path + "-wal")) {
        RefuseDamage(path, "its log exists, but the file is missing");
      }
      CreateStore(path);
    }
  } catch (const SqliteError& error) {
    throw InputError(path + ": cannot be created: " + error.what());
  } catch (const fs::filesystem_error& error) {
    throw InputError(path + ": cannot be opened: " + error.code().message());
  }
  CheckHeader(path);
  return path;
}

[[noreturn]] void RefuseOpening(const std::string& path,
                                const SqliteError& error) {
  if (error.is_busy()) {
    throw InputError(path + ": is in use by another process");
  }
  if (error.is_corrupt()) RefuseDamage(path, error.what());
  throw InputError(path + ": cannot be opened: " + error.what());
}

SqliteDatabase OpenDatabase(const std::string& path) {
  try {
    return SqliteDatabase(ReadyPath(path), false);
  } catch (const SqliteError& error) {
    RefuseOpening(path, error);
  }
}

bool IsTermId(std::int64_t id) { return id > 0 && id < Dictionary::kMaxTerms; }

}  // namespace

StoreRecord::Queries::Queries(SqliteDatabase* database)
    : add_term(database->Prepare("INSERT INTO term VALUES (?, ?, ?, ?, ?)")),
      remove_term(database->Prepare("DELETE FROM term WHERE id = ?")),
      add_quad(database->Prepare("INSERT INTO quad VALUES (?, ?, ?, ?)")),
      remove_quad(database->Prepare(
          "DELETE FROM quad WHERE subject = ? AND predicate = ? AND "
          "object = ? AND graph = ?")),
      set_world(database->Prepare("UPDATE world SET version = ?, digest = ?")) {
}

StoreRecord::StoreRecord(const std::string& path)
    : path_(path), database_(OpenDatabase(path)) {
  try {
    Open();
  } catch (const SqliteError& error) {
    RefuseOpening(path, error);
  }
}

void StoreRecord::Open() {
  database_.Execute(
      "PRAGMA locking_mode = EXCLUSIVE;"
      "PRAGMA synchronous = FULL;"
      "PRAGMA cell_size_check = ON;"
      "PRAGMA journal_size_limit = 67108864;"
      "BEGIN IMMEDIATE; COMMIT;");
  SqliteQuery mode = database_.Prepare("PRAGMA journal_mode");
  if (!mode.Step() || mode.Bytes(0) != "wal") {
    RefuseDamage(path_, "its journal mode is not WAL");
  }
  SqliteQuery check = database_.Prepare("PRAGMA quick_check(1)");
  if (!check.Step() || check.Bytes(0) != "ok") {
    RefuseDamage(path_, check.Bytes(0));
  }
  queries_.emplace(&database_);
}

RecordContent StoreRecord::Load() {
  try {
    RecordContent content = ReadAll();
    LeaveOutUnusedTerms(&content);
    return content;
  } catch (const SqliteError& error) {
    RefuseOpening(path_, error);
  }
}

RecordContent StoreRecord::ReadAll() {
  RecordContent content;
  ReadTerms(&content);
  ReadQuads(&content);
  SqliteQuery world = database_.Prepare("SELECT version, digest FROM world");
  if (!world.Step()) RefuseDamage(path_, "it has no world version");
  content.world_version = static_cast<std::uint64_t>(world.Integer(0));
  const auto digest = static_cast<std::uint64_t>(world.Integer(1));
  if (digest != ComputeDigest(sum_, content.world_version)) {
    RefuseDamage(path_, "its contents do not match their digest");
  }
  return content;
}

void StoreRecord::ReadTerms(RecordContent* content) {
  SqliteQuery row = database_.Prepare("SELECT * FROM term ORDER BY id");
  while (row.Step()) {
    const std::int64_t id = row.Integer(0);
    const std::int64_t kind = row.Integer(1);
    if (!IsTermId(id) || kind < 0 || kind > 2) {
      RefuseDamage(path_, "a malformed term");
    }
    Term term{static_cast<Term::Kind>(kind), row.Bytes(2), row.Bytes(3),
              row.Bytes(4)};
    sum_ += ComputeHash(static_cast<TermId>(id), term);
    content->terms.emplace_back(static_cast<TermId>(id), std::move(term));
  }
}

void StoreRecord::ReadQuads(RecordContent* content) {
  SqliteQuery row = database_.Prepare("SELECT * FROM quad");
  while (row.Step()) {
    for (int i = 0; i < 4; ++i) {
      if (!IsTermId(row.Integer(i))) RefuseDamage(path_, "a malformed quad");
    }
    const auto id = [&](int i) { return static_cast<TermId>(row.Integer(i)); };
    content->quads.push_back({id(0), id(1), id(2), id(3)});
    sum_ += ComputeHash(content->quads.back());
  }
}

std::vector<bool> StoreRecord::UsedTerms(const RecordContent& content) const {
  std::vector<bool> used(
      content.terms.empty() ? 1 : content.terms.back().first + 1);
  for (const Quad& q : content.quads) {
    for (const TermId id : {q.subject, q.predicate, q.object, q.graph}) {
      if (id >= used.size()) RefuseDamage(path_, "a quad without its term");
      used[id] = true;
    }
  }
  return used;
}

void StoreRecord::LeaveOutUnusedTerms(RecordContent* content) {
  auto& terms = content->terms;
  const std::vector<bool> used = UsedTerms(*content);
  content->terms_end = static_cast<TermId>(used.size());
  const auto first_unused = std::stable_partition(
      terms.begin(), terms.end(),
      [&](const auto& entry) { return used[entry.first]; });
  for (auto entry = first_unused; entry != terms.end(); ++entry) {
    forgotten_.emplace(entry->first, ComputeHash(entry->first, entry->second));
  }
  terms.erase(first_unused, terms.end());
}

void StoreRecord::Forget(
    const std::vector<std::pair<TermId, const Term*>>& terms) {
  for (const auto& [id, term] : terms) {
    forgotten_.emplace(id, ComputeHash(id, *term));
  }
}

void StoreRecord::MarkForgotten(std::vector<bool>* ids) const {
  for (const auto& [id, hash] : forgotten_) (*ids)[id] = true;
}

std::size_t StoreRecord::RowsToRemove(const RecordChange& change) const {
  constexpr std::size_t kAtLeast = 64;
  const std::size_t own =
      change.terms.size() + change.added.size() + change.removed.size();
  return std::min(forgotten_.size(), own + kAtLeast);
}

std::uint64_t StoreRecord::RemoveForgotten(std::size_t rows,
                                           std::uint64_t sum) {
  auto row = forgotten_.begin();
  for (; rows > 0; --rows, ++row) {
    queries_->remove_term.Bind(1, std::int64_t{row->first}).Run();
    CheckOneRowChanged();
    sum -= row->second;
  }
  return sum;
}

void StoreRecord::Write(const RecordChange& change) {
  try {
    const std::size_t removed = RowsToRemove(change);
    database_.Execute("BEGIN IMMEDIATE");
    const std::uint64_t sum = WriteRows(change, RemoveForgotten(removed, sum_));
    database_.Execute("COMMIT");
    sum_ = sum;
    forgotten_.erase(forgotten_.begin(),
                     std::next(forgotten_.begin(), removed));
  } catch (const SqliteError& error) {
    RollBack();
    throw std::runtime_error(path_ + ": cannot be written: " + error.what());
  } catch (...) {
    RollBack();
    throw;
  }
}

std::uint64_t StoreRecord::WriteRows(const RecordChange& change,
                                     std::uint64_t sum) {
  // The digest is a sum of hashes, so that rows can be added and removed in any
  // order.
  for (const auto& [id, term] : change.terms) {
    queries_->add_term.Bind(1, std::int64_t{id})
        .Bind(2, static_cast<std::int64_t>(term->kind))
        .Bind(3, term->text)
        .Bind(4, term->datatype)
        .Bind(5, term->language)
        .Run();
    sum += ComputeHash(id, *term);
  }
  for (const Quad& quad : change.removed) {
    RunQuadQuery(&queries_->remove_quad, quad);
    sum -= ComputeHash(quad);
  }
  for (const Quad& quad : change.added) {
    RunQuadQuery(&queries_->add_quad, quad);
    sum += ComputeHash(quad);
  }
  WriteWorld(sum, change.world_version);
  return sum;
}

void StoreRecord::WriteWorld(std::uint64_t sum, std::uint64_t world_version) {
  const std::uint64_t digest = ComputeDigest(sum, world_version);
  queries_->set_world.Bind(1, static_cast<std::int64_t>(world_version))
      .Bind(2, static_cast<std::int64_t>(digest))
      .Run();
}

void StoreRecord::RunQuadQuery(SqliteQuery* query, const Quad& quad) {
  query->Bind(1, std::int64_t{quad.subject})
      .Bind(2, std::int64_t{quad.predicate})
      .Bind(3, std::int64_t{quad.object})
      .Bind(4, std::int64_t{quad.graph})
      .Run();
  CheckOneRowChanged();
}

void StoreRecord::CheckOneRowChanged() const {
  if (database_.changed_rows() != 1) {
    throw std::runtime_error(path_ + ": the record differs from the memory");
  }
}

void StoreRecord::RollBack() noexcept {
  try {
    if (database_.in_transaction()) database_.Execute("ROLLBACK");
  } catch (const std::exception&) {
    // SQLite has rolled back by itself, or will when the file is next opened.
  }
}

}  // namespace kg_core
