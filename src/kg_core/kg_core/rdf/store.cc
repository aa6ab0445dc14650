#include "kg_core/rdf/store.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <thread>
#include <tuple>
#include <utility>

#include "absl/container/btree_set.h"
#include "kg_base/common/input_error.h"
#include "kg_core/rdf/dictionary.h"
#include "kg_core/rdf/quad_index.h"
#include "kg_core/rdf/record.h"
#include "kg_core/rdf/snapshot.h"
#include "kg_core/rdf/term_check.h"

namespace kg_core {
namespace {

void CheckIsRdf(const Statement& s) {
  const auto refuse = [&](const char* why) {
    throw kg_base::InputError(ToTurtle(s.subject) + " " +
                              ToTurtle(s.predicate) + " " + ToTurtle(s.object) +
                              ": " + why);
  };
  if (s.subject.is_literal()) {
    refuse("expected an IRI or blank node as subject");
  }
  if (!s.predicate.is_iri()) refuse("expected an IRI as property");
  if (s.graph.is_literal()) refuse("expected an IRI or blank node as graph");
  for (const Term* term : {&s.subject, &s.predicate, &s.object, &s.graph}) {
    if (const auto fault = FindTermFault(*term)) refuse(fault->c_str());
  }
}

}  // namespace

class QuadStore {
 public:
  QuadStore(const std::string& path, const StoreOptions& options)
      : options_(options), dictionary_(std::make_shared<Dictionary>()) {
    auto version = std::make_shared<StoreVersion>();
    if (!path.empty()) {
      record_.emplace(path);
      RecordContent content = record_->Load();
      dictionary_->Restore(std::move(content.terms), content.terms_end);
      version->index = QuadIndex(content.quads);
      version->world_version = content.world_version;
    }
    current_ = WithTerms(std::move(version));
  }
  // In-memory fork that starts from `origin`.
  explicit QuadStore(const StoreVersion& origin)
      : dictionary_(
            std::make_shared<Dictionary>(origin.dictionary, origin.terms_end)) {
    auto version = std::make_shared<StoreVersion>();
    version->index = origin.index;
    version->world_version = origin.world_version;
    current_ = WithTerms(std::move(version));
  }

  std::shared_ptr<const StoreVersion> current() const {
    const std::lock_guard<std::mutex> lock(current_mutex_);
    return current_;
  }
  const std::shared_ptr<Dictionary>& dictionary() const { return dictionary_; }

  std::unique_lock<std::mutex> LockForWriting() {
    if (writer_.load() == std::this_thread::get_id()) {
      throw std::logic_error("this thread has a transaction open already");
    }
    std::unique_lock<std::mutex> lock(writer_mutex_);
    writer_.store(std::this_thread::get_id());
    return lock;
  }
  void Unlock(std::unique_lock<std::mutex>* lock) {
    writer_.store(std::thread::id());
    lock->unlock();
  }

  // Makes the change durable, then visible. Only the durable step can fail.
  void Commit(const RecordChange& change, std::shared_ptr<StoreVersion> next) {
    dictionary_->PrepareToPublish();
    std::shared_ptr<const StoreVersion> version = WithTerms(std::move(next));
    if (record_) record_->Write(change);
    dictionary_->Publish();
    Exchange(std::move(version));
  }

  // Counts the quads removed by a commit and compacts the dictionary if due.
  // Compaction may run out of memory; it is then retried later.
  void NoteRemoved(std::size_t quads) noexcept {
    removed_ += quads;
    const std::size_t enough =
        std::max(options_.compact_after, current_->index.size() / 4);
    if (removed_ < enough) return;
    try {
      Compact();
      removed_ = 0;
    } catch (const std::bad_alloc&) {
      removed_ = 0;
    }
  }

 private:
  // Completes a version with the dictionary and its term range, including
  // unpublished terms.
  std::shared_ptr<const StoreVersion> WithTerms(
      std::shared_ptr<StoreVersion> version) const {
    version->dictionary = dictionary_;
    version->terms_end = dictionary_->next_id();
    return version;
  }

  void Exchange(std::shared_ptr<const StoreVersion> version) {
    const std::lock_guard<std::mutex> lock(current_mutex_);
    current_.swap(version);
  }

  // Replaces the dictionary by one with only the terms in use.
  void Compact() {
    const std::vector<bool> used =
        current_->index.UsedTerms(dictionary_->ids_end());
    std::vector<bool> taken = used;
    if (record_) {
      record_->Forget(dictionary_->Unused(used));
      record_->MarkForgotten(&taken);
    }
    dictionary_ = dictionary_->Compacted(used, taken);
    Exchange(WithTerms(std::make_shared<StoreVersion>(*current_)));
  }

  const StoreOptions options_;
  std::shared_ptr<Dictionary> dictionary_;
  std::size_t removed_ = 0;  // Quads removed since the last compaction.
  std::optional<StoreRecord> record_;
  std::mutex writer_mutex_;
  std::atomic<std::thread::id> writer_{};
  // Guards current_; held only while copying it.
  mutable std::mutex current_mutex_;
  std::shared_ptr<const StoreVersion> current_;
};

struct Transaction::State : GraphView {
  explicit State(QuadStore* quads)
      : store(quads),
        lock(quads->LockForWriting()),
        dictionary(quads->dictionary()),
        base(quads->current()),
        index(base->index),
        edit(QuadTree::NewEdit()),
        terms_end(dictionary->next_id()) {}
  ~State() override { Finish(); }

  // Ends the transaction; discards uncommitted terms.
  void Finish() {
    if (!lock.owns_lock()) return;
    dictionary->Discard();
    terms_end = dictionary->next_id();
    store->Unlock(&lock);
  }

  void CheckOpen() const {
    if (!lock.owns_lock()) throw std::logic_error("the transaction is over");
  }

  // Additions are buffered and go to the index on the next read: bulk insertion
  // is cheaper and leaves fuller nodes.
  void Add(const Quad& quad) {
    const QuadKey key = PackQuad(quad, QuadOrder::kSpog);
    if (removed.erase(key) == 0) {
      if (base->index.Contains(quad) || !added.insert(key).second) return;
    }
    waiting.push_back(quad);
  }
  void Remove(const Quad& quad) {
    InsertWaiting();
    if (!index.Erase(quad, edit)) return;
    const QuadKey key = PackQuad(quad, QuadOrder::kSpog);
    if (added.erase(key) == 0) removed.insert(key);
    ++removals;
  }
  void InsertWaiting() const {
    const std::lock_guard<std::mutex> guard(waiting_mutex);
    index.InsertAll(std::exchange(waiting, {}), edit);
  }

  // kNoTerm if the term is unknown.
  TermId Find(const Term& term) const override {
    const TermId id = dictionary->Find(term, terms_end);
    if (id != kNoTerm || !lock.owns_lock()) return id;
    return dictionary->FindUnpublished(term);
  }
  const Term& Get(TermId id) const override { return dictionary->Get(id); }
  // `visit` may change the transaction: the match runs on its own copy of the
  // index, whose nodes are no longer changed in place.
  void Match(const Quad& pattern,
             absl::FunctionRef<bool(const Quad&)> visit) const override {
    InsertWaiting();
    const QuadIndex now = index;
    edit = QuadTree::NewEdit();
    now.Match(pattern, visit);
  }
  std::size_t Estimate(const Quad& pattern) const override {
    InsertWaiting();
    return index.Estimate(pattern);
  }
  std::vector<TermId> Graphs() const override {
    InsertWaiting();
    return index.Graphs();
  }
  std::uint64_t world_version() const override { return base->world_version; }

  RecordChange Change(std::uint64_t world_version) const {
    RecordChange change;
    change.terms = dictionary->Unpublished();
    change.added = CollectQuads(added);
    change.removed = CollectQuads(removed);
    change.world_version = world_version;
    return change;
  }

  using KeySet = absl::btree_set<QuadKey>;

  static std::vector<Quad> CollectQuads(const KeySet& keys) {
    std::vector<Quad> quads;
    for (const QuadKey& key : keys) {
      quads.push_back(UnpackQuad(key, QuadOrder::kSpog));
    }
    return quads;
  }

  std::vector<Statement> CollectStatements(const KeySet& keys) const {
    std::vector<Statement> statements;
    for (const Quad& q : CollectQuads(keys)) {
      statements.push_back(
          {Get(q.subject), Get(q.predicate), Get(q.object), Get(q.graph)});
    }
    const auto order = [](const Statement& s) {
      return std::tie(s.graph, s.subject, s.predicate, s.object);
    };
    std::sort(
        statements.begin(), statements.end(),
        [&](const auto& a, const auto& b) { return order(a) < order(b); });
    return statements;
  }

  QuadStore* const store;
  std::unique_lock<std::mutex> lock;  // Held while the transaction is open.
  const std::shared_ptr<Dictionary> dictionary;
  const std::shared_ptr<const StoreVersion> base;
  // The index that Commit would publish, without the quads in `waiting`.
  mutable QuadIndex index;
  mutable std::mutex waiting_mutex;
  mutable std::vector<Quad> waiting;  // Added, not yet in the index.
  mutable std::atomic<std::uint64_t> edit;
  Quad last;         // Ids of the previous statement.
  TermId terms_end;  // Upper bound of the published ids visible here.
  KeySet added;      // Net changes against `base`, in SPOG order.
  KeySet removed;
  std::size_t removals = 0;  // Including quads added in this transaction.
};

Transaction::Transaction(std::unique_ptr<State> state)
    : state_(std::move(state)) {}
Transaction::Transaction(Transaction&&) noexcept = default;
Transaction& Transaction::operator=(Transaction&&) noexcept = default;
Transaction::~Transaction() = default;

void Transaction::Add(const Statement& s) {
  state_->CheckOpen();
  CheckIsRdf(s);
  Dictionary& terms = *state_->dictionary;
  // Consecutive statements often repeat a term: reuse its id without look-up.
  const auto intern = [&](const Term& term, TermId* last) {
    const bool same = *last != kNoTerm && terms.Get(*last) == term;
    return same ? *last : *last = terms.Intern(term);
  };
  Quad quad;
  quad.subject = intern(s.subject, &state_->last.subject);
  quad.predicate = intern(s.predicate, &state_->last.predicate);
  quad.object = terms.Intern(s.object);
  quad.graph = intern(s.graph, &state_->last.graph);
  state_->Add(quad);
}

void Transaction::Remove(const Statement& s) {
  state_->CheckOpen();
  const Quad quad{state_->Find(s.subject), state_->Find(s.predicate),
                  state_->Find(s.object), state_->Find(s.graph)};
  if (BoundPlaces(quad) == 15) state_->Remove(quad);
}

void Transaction::RemoveMatching(const Term* subject, const Term* predicate,
                                 const Term* object, const Term& graph) {
  state_->CheckOpen();
  const auto find = [&](const Term* term, TermId* id) {
    if (term != nullptr) *id = state_->Find(*term);
    return term == nullptr || *id != kNoTerm;
  };
  Quad pattern;
  const bool known =
      find(subject, &pattern.subject) && find(predicate, &pattern.predicate) &&
      find(object, &pattern.object) && find(&graph, &pattern.graph);
  if (!known) return;
  state_->Match(pattern, [&](const Quad& quad) {
    state_->Remove(quad);
    return true;
  });
}

bool Transaction::empty() const {
  return state_->added.empty() && state_->removed.empty();
}

const GraphView& Transaction::view() const { return *state_; }

std::vector<Statement> Transaction::added() const {
  return state_->CollectStatements(state_->added);
}

std::vector<Statement> Transaction::removed() const {
  return state_->CollectStatements(state_->removed);
}

std::uint64_t Transaction::Commit(WorldChange change) {
  state_->CheckOpen();
  std::uint64_t world_version = state_->base->world_version;
  if (!empty()) {
    if (change == WorldChange::kYes) ++world_version;
    auto version = std::make_shared<StoreVersion>();
    state_->InsertWaiting();
    version->index = state_->index;
    version->world_version = world_version;
    state_->store->Commit(state_->Change(world_version), std::move(version));
    state_->store->NoteRemoved(state_->removals);
  }
  state_->Finish();
  return world_version;
}

Store::Store(const std::string& path, const StoreOptions& options)
    : quads_(std::make_unique<QuadStore>(path, options)) {}
Store::Store(std::unique_ptr<QuadStore> quads) : quads_(std::move(quads)) {}
Store::~Store() = default;

Transaction Store::Begin() {
  return Transaction(std::make_unique<Transaction::State>(quads_.get()));
}

std::unique_ptr<Store> Store::Fork(std::shared_ptr<const GraphView> world) {
  const auto* snapshot = dynamic_cast<const Snapshot*>(world.get());
  if (snapshot == nullptr) {
    throw std::invalid_argument(
        "only a snapshot from Store::Read can be forked");
  }
  return std::unique_ptr<Store>(
      new Store(std::make_unique<QuadStore>(snapshot->version())));
}

std::shared_ptr<const GraphView> Store::Read() const {
  return std::make_shared<Snapshot>(quads_->current());
}

std::uint64_t Store::world_version() const {
  return quads_->current()->world_version;
}

std::size_t Store::quad_count() const {
  return quads_->current()->index.size();
}

std::size_t Store::term_count() const {
  return quads_->current()->dictionary->size();
}

}  // namespace kg_core
