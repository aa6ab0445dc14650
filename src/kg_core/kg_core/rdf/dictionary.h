// Terms and their ids. Grows only; ids are given in order from 1.
//
// One writer appends terms, which nobody else can find until they are
// published; any number of readers look terms up (a short shared lock) and
// fetch them by id (no lock: a term never moves once it has an id).

#ifndef KG_CORE_RDF_DICTIONARY_H_
#define KG_CORE_RDF_DICTIONARY_H_

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
  static constexpr std::size_t kMaxTerms = std::size_t{1} << 28;

  Dictionary();
  ~Dictionary();
  Dictionary(const Dictionary&) = delete;
  Dictionary& operator=(const Dictionary&) = delete;

  // Readers, from any thread.
  TermId Find(const Term& term) const;  // kNoTerm if not published.
  const Term& Get(TermId id) const;     // Throws std::out_of_range.

  // The writer, one thread at a time.
  TermId end() const { return end_; }  // The id that the next term will get.
  // The id of the term, new if needed; new ones are unpublished.
  TermId Intern(const Term& term);
  TermId FindUnpublished(const Term& term) const;
  // Room for all that is unpublished, so that Publish cannot fail.
  void PrepareToPublish();
  void Publish() noexcept;
  // Forgets all that is unpublished.
  void Discard();
  // Puts the terms of the record at their ids, which rise, published.
  void Restore(std::vector<std::pair<TermId, Term>> terms);

 private:
  static constexpr std::size_t kChunk = 1 << 13;

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
  void Put(TermId id, Term term);

  std::unique_ptr<std::atomic<Term*>[]> chunks_;  // kChunk terms each, or null.
  TermId end_ = 1;
  TermId published_end_ = 1;
  EntrySet unpublished_;
  mutable WriterFirstMutex mutex_;  // Guards published_.
  EntrySet published_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_DICTIONARY_H_
