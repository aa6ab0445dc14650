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

class Store;
class QuadStore;  // The state behind Store; see store.cc.

// What one transaction will do. Nothing is visible to others, or durable,
// before Commit(); destroyed without it, it never happened. One at a time.
class Transaction {
 public:
  Transaction(Transaction&&) noexcept;
  Transaction& operator=(Transaction&&) noexcept;
  ~Transaction();

  void Add(const Statement& statement);
  void Remove(const Statement& statement);
  // Removes what matches; a null pointer matches any term.
  void RemoveMatching(const Term* subject, const Term* predicate,
                      const Term* object, const Term& graph);
  bool empty() const;  // Would Commit() change no quad?

  // What it would leave behind: committed state plus changes so far.
  const GraphView& view() const;
  // The net changes so far, in a stable order.
  std::vector<Statement> added() const;
  std::vector<Statement> removed() const;

  // Makes it durable, then visible; returns the world version after it (one
  // more than before if `change` is kYes and a quad changed). Throws
  // std::runtime_error if the record cannot be written (disk full, I/O
  // error); then nothing has changed.
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
  explicit Store(const std::string& path);
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  // Blocks while another transaction is open. Only the thread that began it
  // may use it.
  Transaction Begin();

  // The committed state of now. Safe from any thread; holding it does not
  // block the writer for longer than a reader needs.
  std::shared_ptr<const GraphView> Read() const;

  std::uint64_t world_version() const;
  std::size_t quad_count() const;

 private:
  std::unique_ptr<QuadStore> quads_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_STORE_H_
