// Terms and their ids: those of one store, or of a fork of it.
//
// One writer appends terms, which nobody else can find until they are
// published; any number of readers look terms up (a short shared lock) and
// fetch them by id (no lock: a term never moves once it has an id). Terms are
// only added, with rising ids, so `next_id()` at the time of a commit tells
// what a snapshot of it knows: Find(term, end) does not see what came later,
// and a reader gets the same answer however long it reads.
//
// Terms that no quad uses any more leave with their dictionary: the writer goes
// on with a Compacted one, which has the used terms at their same ids and gives
// the free ids to later terms; old snapshots keep the old one. It shares the
// chunks of 256 terms that have no unused one. Cost: one look at every id and
// one hash table entry for every term that stays (about 50 ns each), and a copy
// of those that lay in a chunk with unused ones.
//
// A layer adds its own terms to what another dictionary held when the layer
// was made (Store::Fork). Its ids begin after all of those; what the other one
// adds later is neither seen nor in the way, though ids of both may then have
// the same number: they belong to different stores.

#ifndef KG_CORE_RDF_DICTIONARY_H_
#define KG_CORE_RDF_DICTIONARY_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_set.h"
#include "kg_base/common/writer_first_mutex.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"
#include "kg_core/rdf/term_chunks.h"

namespace kg_core {

class Dictionary {
 public:
  // Ids are smaller. Those of a query's own terms (sparql/term_table.h) begin
  // above.
  static constexpr TermId kMaxTerms = TermId{1} << 28;

  Dictionary();
  // A layer over the terms that `base` had published when its next_id() was
  // `base_end`.
  Dictionary(std::shared_ptr<const Dictionary> base, TermId base_end);
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  // Readers, from any thread. kNoTerm if it was not published when next_id()
  // was `end`.
  TermId Find(const Term& term, TermId end) const;
  const Term& Get(TermId id) const;  // Throws std::out_of_range.
  std::size_t size() const;          // Published ones, without layers below.

  // The writer, one thread at a time.
  TermId next_id() const { return IdAt(given_); }
  // One past the largest id that a term of it has or had.
  TermId ids_end() const;
  // The id of the term, new if needed; new ones are unpublished.
  TermId Intern(const Term& term);
  TermId FindUnpublished(const Term& term) const;
  // The unpublished ones, in the order of their ids.
  std::vector<std::pair<TermId, const Term*>> Unpublished() const;
  // Room for all that is unpublished, so that Publish cannot fail.
  void PrepareToPublish();
  void Publish() noexcept;
  // Forgets all that is unpublished.
  void Discard();
  // Puts the terms of the record at their ids, which rise, published; later
  // ones get ids from `end` on.
  void Restore(std::vector<std::pair<TermId, Term>> terms, TermId end);

  // The published terms of this layer of which `used`, by id, is false.
  std::vector<std::pair<TermId, const Term*>> Unused(
      const std::vector<bool>& used) const;
  // See above. It does not give the ids of which `taken` is true to new terms;
  // `used` ones are taken. There must be nothing unpublished, and nothing may
  // be interned here any more.
  std::shared_ptr<Dictionary> Compacted(const std::vector<bool>& used,
                                        const std::vector<bool>& taken) const;

 private:
  struct Entry {
    TermId id;
    std::uint32_t hash : 31;
    std::uint32_t is_old : 1;  // Older than this dictionary: always found.
  };
  struct Wanted {  // A term that is looked for.
    const Term& term;
    std::uint32_t hash;
  };
  struct Hash {
    using is_transparent = void;
    template <typename Key>
    std::size_t operator()(const Key& key) const {
      return key.hash * std::uint64_t{0x9E3779B97F4A7C15};
    }
  };
  struct Equal {
    using is_transparent = void;
    const Dictionary* dictionary;
    bool operator()(const Entry& a, const Entry& b) const {
      return a.id == b.id;
    }
    bool operator()(const Entry& a, const Wanted& b) const {
      return a.hash == b.hash && dictionary->Get(a.id) == b.term;
    }
    bool operator()(const Wanted& a, const Entry& b) const {
      return (*this)(b, a);
    }
  };
  using EntrySet = absl::flat_hash_set<Entry, Hash, Equal>;

  static Wanted Want(const Term& term);
  TermId FindWanted(const Wanted& wanted, TermId end) const;
  TermId FindUnpublished(const Wanted& wanted) const;
  // The id of the n-th new term of this dictionary.
  TermId IdAt(std::size_t n) const;

  const std::shared_ptr<const Dictionary> base_;  // Null: no layer below.
  const TermId base_end_;
  const TermId first_;               // The first id of this layer.
  TermChunks terms_;                 // By id - first_.
  std::vector<TermId> free_ids_;     // Rising; given before those from...
  TermId free_from_;                 // ... here on.
  std::size_t given_ = 0;            // How many new terms there are,
  std::size_t published_given_ = 0;  // and how many of them are published.
  EntrySet unpublished_;
  mutable kg_base::WriterFirstMutex mutex_;  // Guards published_.
  EntrySet published_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_DICTIONARY_H_
