// The term dictionary of one store or fork: interned terms and their ids.
//
// One writer appends terms, which readers cannot find until they are published;
// any number of readers look terms up (a short shared lock) and fetch them by
// id (no lock: a term never moves once it has an id). Terms are only added,
// with ascending ids, so the `next_id()` recorded at a commit bounds the terms
// known to that snapshot: Find(term, end) ignores terms added later, so
// repeated look-ups through one snapshot give the same answer.
//
// Terms that no quad uses any more are dropped by replacing the dictionary: the
// writer continues with a Compacted copy, which keeps the used terms at the
// same ids and reuses the free ids for later terms; old snapshots keep the old
// dictionary. The copy shares every chunk of 256 terms that holds no unused
// term. Cost: one check per id and one hash table entry per retained term
// (about 50 ns each), and a copy of each retained term whose chunk also holds
// unused ones.
//
// A layer adds its own terms to those that a base dictionary held when the
// layer was made (Store::Fork). Its ids begin after all of the base's; terms
// that the base adds later are not visible in the layer. The same id may then
// denote different terms in the two, since they belong to different stores.

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
  // Upper bound (exclusive) of dictionary ids. The ids of query-local terms
  // (sparql/term_table.h) lie above.
  static constexpr TermId kMaxTerms = TermId{1} << 28;

  Dictionary();
  // A layer over the terms that `base` had published when its next_id() was
  // `base_end`.
  Dictionary(std::shared_ptr<const Dictionary> base, TermId base_end);
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  // For readers, from any thread. Returns kNoTerm if the term was not yet
  // published when next_id() was `end`.
  TermId Find(const Term& term, TermId end) const;
  const Term& Get(TermId id) const;  // Throws std::out_of_range.
  std::size_t size() const;          // Published terms, base layers excluded.

  // For the writer, one thread at a time.
  TermId next_id() const { return IdAt(given_); }
  // One past the largest id ever assigned to a term of this dictionary.
  TermId ids_end() const;
  // Returns the id of the term; assigns one if needed. New terms are
  // unpublished.
  TermId Intern(const Term& term);
  TermId FindUnpublished(const Term& term) const;
  // The unpublished terms, in the order they were interned.
  std::vector<std::pair<TermId, const Term*>> Unpublished() const;
  // Reserves space for all unpublished terms, so that Publish cannot fail.
  void PrepareToPublish();
  void Publish() noexcept;
  // Drops all unpublished terms.
  void Discard();
  // Restores recorded terms at their ids (ascending) as published; later terms
  // get ids from `end` on.
  void Restore(std::vector<std::pair<TermId, Term>> terms, TermId end);

  // The published terms of this layer for which `used`, indexed by id, is
  // false.
  std::vector<std::pair<TermId, const Term*>> Unused(
      const std::vector<bool>& used) const;
  // A compacted copy, see above. Ids with `taken` true are not reused for new
  // terms; used ids must be among the taken ones. Precondition: no unpublished
  // terms; afterwards nothing may be interned in this dictionary.
  std::shared_ptr<Dictionary> Compacted(const std::vector<bool>& used,
                                        const std::vector<bool>& taken) const;

 private:
  struct Entry {
    TermId id;
    std::uint32_t hash : 31;
    std::uint32_t is_old : 1;  // Restored or copied: visible to every `end`.
  };
  struct Wanted {  // Look-up key: a term and its hash.
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

  const std::shared_ptr<const Dictionary> base_;  // Null: no base layer.
  const TermId base_end_;
  const TermId first_;               // First id of this layer.
  TermChunks terms_;                 // Indexed by id - first_.
  std::vector<TermId> free_ids_;     // Ascending; used up before
  TermId free_from_;                 // ids from free_from_ on.
  std::size_t given_ = 0;            // Number of new terms.
  std::size_t published_given_ = 0;  // Number of them published.
  EntrySet unpublished_;
  mutable kg_base::WriterFirstMutex mutex_;  // Guards published_.
  EntrySet published_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_DICTIONARY_H_
