#include "kg_core/rdf/dictionary.h"

#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "absl/hash/hash.h"

namespace kg_core {

Dictionary::Dictionary()
    : chunks_(new std::atomic<Term*>[kMaxTerms / kChunk]()),
      unpublished_(0, Hash{}, Equal{this}),
      published_(0, Hash{}, Equal{this}) {}

Dictionary::~Dictionary() {
  for (std::size_t i = 0; i < kMaxTerms / kChunk; ++i) delete[] chunks_[i];
}

Dictionary::Wanted Dictionary::Want(const Term& term) {
  return {term, static_cast<std::uint32_t>(
                    absl::HashOf(static_cast<int>(term.kind), term.text,
                                 term.datatype, term.language))};
}

TermId Dictionary::FindIn(const EntrySet& entries, const Wanted& wanted) {
  const auto found = entries.find(wanted);
  return found == entries.end() ? kNoTerm : found->id;
}

TermId Dictionary::Find(const Term& term) const {
  const Wanted wanted = Want(term);
  const std::shared_lock<WriterFirstMutex> lock(mutex_);
  return FindIn(published_, wanted);
}

TermId Dictionary::FindUnpublished(const Term& term) const {
  return FindIn(unpublished_, Want(term));
}

const Term& Dictionary::Get(TermId id) const {
  const Term* chunk = id < kMaxTerms
                          ? chunks_[id / kChunk].load(std::memory_order_acquire)
                          : nullptr;
  if (chunk == nullptr || id == kNoTerm) {
    throw std::out_of_range("no term has the id " + std::to_string(id));
  }
  return chunk[id % kChunk];
}

TermId Dictionary::Intern(const Term& term) {
  if (const TermId id = Find(term)) return id;
  if (const TermId id = FindUnpublished(term)) return id;
  const TermId id = end_;
  Put(id, term);
  unpublished_.insert({id, Want(term).hash});
  end_ = id + 1;
  return id;
}

void Dictionary::Put(TermId id, Term term) {
  if (id >= kMaxTerms) throw std::runtime_error("the store has no more terms");
  std::atomic<Term*>& chunk = chunks_[id / kChunk];
  if (chunk == nullptr) {
    chunk.store(new Term[kChunk], std::memory_order_release);
  }
  chunk.load()[id % kChunk] = std::move(term);
}

void Dictionary::PrepareToPublish() {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.reserve(published_.size() + unpublished_.size());
}

void Dictionary::Publish() noexcept {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.insert(unpublished_.begin(), unpublished_.end());
  unpublished_.clear();
  published_end_ = end_;
}

void Dictionary::Discard() {
  unpublished_.clear();
  end_ = published_end_;
}

void Dictionary::Restore(std::vector<std::pair<TermId, Term>> terms) {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.reserve(terms.size());
  for (auto& [id, term] : terms) {
    published_.insert({id, Want(term).hash});
    Put(id, std::move(term));
    end_ = published_end_ = id + 1;
  }
}

}  // namespace kg_core
