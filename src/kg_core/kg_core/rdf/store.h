// The durable quad store: B-tree orders in memory, SQLite as the record.
//
// One writer, many readers. A transaction is durable (SQLite COMMIT, WAL,
// synchronous=FULL) before it is visible and before Commit() returns; on any
// error nothing has changed. A reader holds a snapshot: one committed state.
//
//   Store store("/var/lib/kg/store.db");          // "" = in memory only
//   Transaction change = store.Begin();
//   change.Add({s, p, o, Iri(kFactsGraph)});
//   if (Validate(change.view()).empty()) change.Commit(WorldChange::kYes);
//   const std::shared_ptr<const GraphView> world = store.Read();
//
// Snapshot isolation is by immutable versions that share structure: each of the
// four orders is a B+ tree whose nodes are never changed once published
// (quad_tree.h). A commit copies the few nodes on the way to its changes and
// then exchanges one pointer; a snapshot is that pointer. So a reader takes no
// lock while it matches, cannot see a later change, and cannot hold up the
// writer, however long it holds the snapshot; what it costs is the memory of
// the nodes that have been replaced since. Versioned entries filtered by each
// reader would need a lock per step, a vacuum, and a second mechanism for
// Transaction::view(), which here is just the next, unpublished version.
//
// Terms are only ever added to a dictionary (dictionary.h), so the references
// that Get returns live as long as the snapshot; terms that came after it are
// unknown to it. A fork shares the nodes and puts a layer of its own over the
// dictionary.
//
// Terms that no quad uses any more leave memory and record while the store is
// open: after a commit with which a quarter of the quads have been removed
// since the last time (and at least StoreOptions::compact_after), the writer
// goes on with a compacted dictionary. That commit takes longer by about 0.1 us
// for every quad and term in the store, so each removed quad costs 0.4 us more;
// readers wait for nothing, and a snapshot keeps its own dictionary. The rows
// of such terms leave with later commits, a few with each. An id is given to a
// new term only then: within a snapshot it means one term, in two snapshots it
// means the same one only while a quad uses it.
//
// Design and measurements behind it: docs/architecture.md, "The store".

#ifndef KG_CORE_RDF_STORE_H_
#define KG_CORE_RDF_STORE_H_

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

struct Statement {
  Term subject;
  Term predicate;
  Term object;
  Term graph;
};

// Does this commit change facts or vocabulary, that is, the world? Plans,
// provenance, logs and agent states do not.
enum class WorldChange { kYes, kNo };

struct StoreOptions {
  std::size_t compact_after = 1 << 16;  // Removed quads.
};

class Store;
class QuadStore;  // The state behind Store; see store.cc.

// What one transaction will do. Nothing is visible to others, or durable,
// before Commit(); destroyed without it, it never happened. One at a time.
class Transaction {
 public:
  Transaction(Transaction&&) noexcept;
  Transaction& operator=(Transaction&&) noexcept;
  ~Transaction();

  // Throws InputError if the statement is not RDF: a literal as subject, a
  // predicate or graph that is no IRI.
  void Add(const Statement& statement);
  void Remove(const Statement& statement);
  // Removes what matches; a null pointer matches any term.
  void RemoveMatching(const Term* subject, const Term* predicate,
                      const Term* object, const Term& graph);
  bool empty() const;  // Would Commit() change no quad?

  // What it would leave behind: committed state plus changes so far, under the
  // world version it began with. Follows later changes; a Match under way goes
  // on with the state it began with. Dies with the transaction.
  const GraphView& view() const;
  // The net changes so far, in a stable order.
  std::vector<Statement> added() const;
  std::vector<Statement> removed() const;

  // Makes it durable, then visible; returns the world version after it (one
  // more than before if `change` is kYes and a quad changed). Throws
  // std::runtime_error if the record cannot be written (disk full, I/O
  // error); then nothing has changed, and it may be tried again. Afterwards
  // the transaction is over: only view(), added() and removed() may be used.
  std::uint64_t Commit(WorldChange change);

 private:
  friend class Store;
  struct State;
  explicit Transaction(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

class Store {
 public:
  // Opens or creates the store at `path`; "" keeps it in memory only. Throws
  // InputError if the file is no store of ours, is damaged (quick_check) or is
  // in use by another process.
  explicit Store(const std::string& path, const StoreOptions& options = {});
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // Blocks while another transaction is open. Only the thread that began it
  // may use it; the store must outlive it. Throws std::logic_error if this
  // thread has one open already.
  Transaction Begin();

  // A store in memory that begins as `world` (of Read(), also of another fork)
  // and goes its own way: hypothetical facts are committed there, and `world`
  // and its store never see them, nor it what they do next. Costs what is
  // changed, not what there is; may outlive its origin. Ids of terms that
  // `world` knows are the same in both; ids of later terms are not. Throws
  // std::invalid_argument if `world` is no snapshot of a Store.
  static std::unique_ptr<Store> Fork(std::shared_ptr<const GraphView> world);

  // The committed state of now. Safe from any thread, also used by several at
  // once; never blocks the writer; may outlive the store.
  std::shared_ptr<const GraphView> Read() const;

  std::uint64_t world_version() const;
  std::size_t quad_count() const;
  // Terms in memory, used or not; of a fork only those of its own.
  std::size_t term_count() const;

 private:
  explicit Store(std::unique_ptr<QuadStore> quads);

  std::unique_ptr<QuadStore> quads_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_STORE_H_
