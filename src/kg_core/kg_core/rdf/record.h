// The durable record behind a Store: one SQLite file.
//
// WAL, synchronous=FULL (an fsync per commit), locked for one process. Beside
// SQLite's own checks, a digest of the contents is kept: the sum modulo 2^64 of
// a hash of every term, every quad and the world version, brought up to date in
// the same SQLite transaction as the contents. A changed, lost or invented row
// shows as a wrong sum when the store is opened, however well-formed the file.

#ifndef KG_CORE_RDF_RECORD_H_
#define KG_CORE_RDF_RECORD_H_

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/sqlite.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

struct RecordContent {
  std::vector<std::pair<TermId, Term>> terms;  // Used ones, by rising id.
  TermId terms_end = 1;                        // All ids are smaller.
  std::vector<Quad> quads;
  std::uint64_t world_version = 0;
};

// What one transaction changes.
struct RecordChange {
  std::vector<std::pair<TermId, const Term*>> terms;  // New ones.
  std::vector<Quad> added;
  std::vector<Quad> removed;
  std::uint64_t world_version = 0;  // After it.
};

class StoreRecord {
 public:
  // Opens or creates. Throws InputError that names the file if it is no store
  // of ours, is damaged or is in use.
  explicit StoreRecord(const std::string& path);

  // Everything that is recorded. Terms that no quad uses are left out, as if
  // Forget had been called for them.
  RecordContent Load();

  // Durable when it returns. Throws std::runtime_error; then the record is as
  // it was.
  void Write(const RecordChange& change);

  // These terms are not used any more. Their rows leave with the next writes, a
  // few more with each than it writes itself, so no write is held up by them;
  // until then their ids are not free.
  void Forget(const std::vector<std::pair<TermId, const Term*>>& terms);
  // By id: sets where there is such a row.
  void MarkForgotten(std::vector<bool>* ids) const;
  struct Queries {
    explicit Queries(SqliteDatabase* database);
    SqliteQuery add_term, remove_term, add_quad, remove_quad, set_world;
  };

  void Open();
  RecordContent ReadAll();
  void ReadTerms(RecordContent* content);
  void ReadQuads(RecordContent* content);
  std::vector<bool> UsedTerms(const RecordContent& content) const;
  void LeaveOutUnusedTerms(RecordContent* content);
  std::size_t RowsToRemove(const RecordChange& change) const;
  void WriteWorld(std::uint64_t sum, std::uint64_t world_version);
  std::uint64_t WriteRows(const RecordChange& change, std::uint64_t sum);
  std::uint64_t RemoveForgotten(std::size_t rows, std::uint64_t sum);
  void RunQuadQuery(SqliteQuery* query, const Quad& quad);
  void CheckOneRowChanged() const;
  void RollBack() noexcept;

  const std::string path_;
  SqliteDatabase database_;
  std::optional<Queries> queries_;
  std::uint64_t sum_ = 0;  // Of the hashes of terms and quads.
  std::map<TermId, std::uint64_t> forgotten_;  // Hashes of rows to remove.
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_RECORD_H_
