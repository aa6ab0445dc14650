// The durable record behind a Store: one SQLite file.
//
// WAL, synchronous=FULL (an fsync per commit), locked for one process. Beside
// SQLite's own checks, a digest of the contents is kept: the sum modulo 2^64 of
// a hash of every term, every quad and the world version, brought up to date in
// the same SQLite transaction as the contents. A changed, lost or spurious row
// is detected as a digest mismatch when the store is opened, even if the file
// is well-formed.

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
  std::vector<std::pair<TermId, Term>> terms;  // Used terms, ascending by id.
  TermId terms_end = 1;  // Upper bound (exclusive) of the ids.
  std::vector<Quad> quads;
  std::uint64_t world_version = 0;
};

// The changes of one transaction.
struct RecordChange {
  std::vector<std::pair<TermId, const Term*>> terms;  // New terms.
  std::vector<Quad> added;
  std::vector<Quad> removed;
  std::uint64_t world_version = 0;  // Version after the change.
};

class StoreRecord {
 public:
  // Opens or creates the file. Throws InputError with the file name if it is
  // not a store of this program, is damaged or is in use.
  explicit StoreRecord(const std::string& path);

  // Reads the whole record. Terms that no quad uses are left out and treated as
  // if Forget had been called for them.
  RecordContent Load();

  // Writes one transaction, durable on return. On failure throws
  // std::runtime_error and leaves the record unchanged.
  void Write(const RecordChange& change);

  // Schedules the rows of unused terms for removal. Each later Write() removes
  // at most 64 rows more than it writes itself, so that none of them is slow;
  // until its row is removed, an id is not free.
  void Forget(const std::vector<std::pair<TermId, const Term*>>& terms);
  // Sets `ids`, indexed by id, to true for each row still to be removed.
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
  std::uint64_t sum_ = 0;  // Sum of the hashes of terms and quads.
  std::map<TermId, std::uint64_t> forgotten_;  // Hashes of rows to remove.
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_RECORD_H_
