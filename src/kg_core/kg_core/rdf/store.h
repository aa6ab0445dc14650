// The durable quad store: B+ tree indexes in memory, SQLite as the durable
// record.
//
// One writer, many readers. A transaction is durable (SQLite COMMIT, WAL,
// synchronous=FULL) before it is visible and before Commit() returns; on any
// error the state is unchanged. A reader holds a snapshot: one committed state.
//
//   Store store("/var/lib/kg/store.db");          // "" = in memory only
//   Transaction change = store.Begin();
//   change.Add({s, p, o, Iri(kFactsGraph)});
//   if (Validate(change.view()).empty()) change.Commit(WorldChange::kYes);
//   const std::shared_ptr<const GraphView> world = store.Read();
//
// Snapshot isolation is by immutable versions that share structure: each of the
// four orders is a B+ tree whose nodes are never changed once published
// (quad_tree.h). A commit copies the nodes on the paths to its changes and then
// exchanges one pointer; a snapshot is that pointer. So a reader takes no lock
// while matching, does not see later changes, and never blocks the writer,
// however long it holds the snapshot; the cost is the memory of the nodes
// replaced since. Versioned entries filtered by each reader would need a lock
// per step, a vacuum, and a second mechanism for Transaction::view(), which
// here is just the next, unpublished version.
//
// Terms are only ever added to a dictionary (dictionary.h), so references
// returned by Get are valid as long as the snapshot; terms added later are not
// visible in it. A fork shares the nodes and adds its own layer on top of the
// dictionary.
//
// Terms that no quad uses any more are removed from memory and record while the
// store is open: once a quarter of the quads (and at least
// StoreOptions::compact_after) have been removed since the last compaction, the
// writer continues with a compacted dictionary. That commit takes longer by
// about 0.1 us for every quad and term in the store, so each removed quad costs
// 0.4 us more; readers do not wait, and a snapshot keeps its own dictionary.
// The rows of such terms are deleted by later commits, a few each. Only then is
// an id reused for a new term: within a snapshot an id denotes one term; in two
// snapshots it denotes the same term only as long as a quad uses it.
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

// Whether a commit changes the world, that is, facts or vocabulary. Plans,
// provenance, logs and agent states do not count.
enum class WorldChange { kYes, kNo };

struct StoreOptions {
  std::size_t compact_after = 1 << 16;  // Number of removed quads.
};

class Store;
class QuadStore;  // The state behind Store; see store.cc.

// A set of changes. Nothing is visible to others, or durable, before Commit();
// destroying the object without it discards the changes. Only one can be open
// at a time.
class Transaction {
 public:
  Transaction(Transaction&&) noexcept;
  Transaction& operator=(Transaction&&) noexcept;
  ~Transaction();

  // Throws InputError if the statement is not RDF: a literal as subject or
  // graph, a predicate that is not an IRI, a term with a fault (term_check.h).
  void Add(const Statement& statement);
  void Remove(const Statement& statement);
  // Removes all matching statements; a null pointer matches any term.
  void RemoveMatching(const Term* subject, const Term* predicate,
                      const Term* object, const Term& graph);
  bool empty() const;  // True if Commit() would change no quad.

  // The state as of now: committed state plus changes so far, with the world
  // version at Begin(). Later changes show in the same view; a Match in
  // progress continues on the state it began with. Valid as long as the
  // transaction.
  const GraphView& view() const;
  // The net changes so far, in a stable order.
  std::vector<Statement> added() const;
  std::vector<Statement> removed() const;

  // Makes the changes durable, then visible; returns the new world version
  // (incremented if `change` is kYes and a quad changed). Throws
  // std::runtime_error if the record cannot be written (disk full, I/O error);
  // then nothing has changed, and Commit may be retried. Afterwards the
  // transaction is over: only view(), added() and removed() may be used.
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
  // InputError if the file is not a store of this program, is damaged
  // (quick_check) or is in use by another process.
  explicit Store(const std::string& path, const StoreOptions& options = {});
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // Begins a transaction; blocks while another one is open. Only the calling
  // thread may use it, and the store must outlive it. Throws std::logic_error
  // if this thread already has one open.
  Transaction Begin();

  // An in-memory store that starts from `world` (from Read() of a store or
  // fork) and is independent of it afterwards, for hypothetical facts: neither
  // sees later commits of the other. Its cost grows with the changes made, not
  // with the size of the store; it may outlive its origin. Terms known to
  // `world` have the same ids in both; ids of later terms are unrelated. Throws
  // std::invalid_argument if `world` is not a snapshot of a Store.
  static std::unique_ptr<Store> Fork(std::shared_ptr<const GraphView> world);

  // The current committed state. Thread-safe; the snapshot may be shared
  // between threads, never blocks the writer and may outlive the store.
  std::shared_ptr<const GraphView> Read() const;

  std::uint64_t world_version() const;
  std::size_t quad_count() const;
  // Number of terms in memory, used or not; for a fork only its own layer.
  std::size_t term_count() const;

 private:
  explicit Store(std::unique_ptr<QuadStore> quads);

  std::unique_ptr<QuadStore> quads_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_STORE_H_
