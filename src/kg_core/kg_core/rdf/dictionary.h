// Terms and their ids: those of one store, or of a fork of it.
//
// One writer appends terms, which nobody else can find until they are
// published; any number of readers look terms up (a short shared lock) and
// fetch them by id (no lock: a term never moves once it has an id). Terms are
// only added. New ids rise, so `next_id()` at the time of a commit tells what a
// snapshot of it knows: Find(term, end) does not see what came later, and a
// reader gets the same answer however long it reads.
//
// A layer adds its own terms to what another dictionary held when the layer
// was made (Store::Fork). Its ids begin after all of those; what the other one
// adds later is neither seen nor in the way, though ids of both may then have
// the same number: they belong to different stores.

#ifndef KG_CORE_RDF_DICTIONARY_H_
#define KG_CORE_RDF_DICTIONARY_H_

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "absl/container/flat_hash_set.h"
#include "kg_core/base/writer_first_mutex.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

class Dictionary {
 public:
  // Ids are smaller. Those of a query's own terms (sparql/term_table.h) and
  // marks on ids may therefore use the upper bits.
  static constexpr TermId kMaxTerms = TermId{1} << 28;

  Dictionary();
  // A layer over the terms that `base` had published when its next_id() was
  // `base_end`.
  Dictionary(std::shared_ptr<const Dictionary> base, TermId base_end);
  ~Dictionary();
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  // Readers, from any thread. kNoTerm if it was not published when next_id()
  // was `end`.
  TermId Find(const Term& term, TermId end) const;
  const Term& Get(TermId id) const;  // Throws std::out_of_range.

  // The writer, one thread at a time.
  TermId next_id() const { return next_id_; }
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
  // Puts the terms of the record at their ids, which rise, published.
  void Restore(std::vector<std::pair<TermId, Term>> terms);

 private:
  // Chunk i has kFirstChunk << i slots; it is made when it is first needed.
  // Slots without a term are raw memory, and cost none before they are used.
  static constexpr int kFirstChunkBits = 9;
  static constexpr int kChunks = 28 - kFirstChunkBits + 1;

  struct Entry {
    TermId id;
    std::uint32_t hash;
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
  static TermId FindIn(const EntrySet& entries, const Wanted& wanted);
  TermId FindWanted(const Wanted& wanted, TermId end) const;
  Term* Slot(TermId id) const;  // Null if its chunk is not there.
  Term* MakeSlot(TermId id);

  const std::shared_ptr<const Dictionary> base_;  // Null: no layer below.
  const TermId base_end_ = 1;
  const TermId first_ = 1;  // The first id of this layer.
  std::array<std::atomic<Term*>, kChunks> chunks_{};
  TermId next_id_ = first_;
  TermId published_end_ = first_;
  EntrySet unpublished_;
  mutable WriterFirstMutex mutex_;  // Guards published_.
  EntrySet published_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_DICTIONARY_H_
