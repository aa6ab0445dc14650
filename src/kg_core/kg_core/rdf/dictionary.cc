#include "kg_core/rdf/dictionary.h"

#include <mutex>
#include <new>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "absl/hash/hash.h"

namespace kg_core {
namespace {

// Where a slot lies: which chunk, and where in it. Counting from the size of
// the first chunk, the highest bit of the number tells the chunk.
struct Place {
  int chunk;
  std::uint32_t offset;
};

Place PlaceOf(std::uint32_t index, int first_chunk_bits) {
  const std::uint32_t number = index + (1u << first_chunk_bits);
  const int bit = 31 - __builtin_clz(number);
  return {bit - first_chunk_bits, number - (1u << bit)};
}

}  // namespace

Dictionary::Dictionary() : Dictionary(nullptr, 1) {}

Dictionary::Dictionary(std::shared_ptr<const Dictionary> base, TermId base_end)
    : base_(std::move(base)),
      base_end_(base_end),
      first_(base_end),
      unpublished_(0, Hash{}, Equal{this}),
      published_(0, Hash{}, Equal{this}) {}

Dictionary::~Dictionary() {
  Discard();
  for (const Entry& entry : published_) Slot(entry.id)->~Term();
  for (int i = 0; i < kChunks; ++i) ::operator delete(chunks_[i].load());
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

TermId Dictionary::FindWanted(const Wanted& wanted, TermId end) const {
  TermId id = kNoTerm;
  {
    const std::shared_lock<WriterFirstMutex> lock(mutex_);
    id = FindIn(published_, wanted);
  }
  if (id != kNoTerm) return id < end ? id : kNoTerm;
  return base_ ? base_->FindWanted(wanted, base_end_) : kNoTerm;
}

TermId Dictionary::Find(const Term& term, TermId end) const {
  return FindWanted(Want(term), end);
}

TermId Dictionary::FindUnpublished(const Term& term) const {
  return unpublished_.empty() ? kNoTerm : FindIn(unpublished_, Want(term));
}

Term* Dictionary::Slot(TermId id) const {
  const Place place = PlaceOf(id - first_, kFirstChunkBits);
  Term* chunk = chunks_[place.chunk].load(std::memory_order_acquire);
  return chunk == nullptr ? nullptr : chunk + place.offset;
}

const Term& Dictionary::Get(TermId id) const {
  if (base_ && id < first_) return base_->Get(id);
  const Term* slot = id >= first_ && id < kMaxTerms ? Slot(id) : nullptr;
  if (slot == nullptr) {
    throw std::out_of_range("no term has the id " + std::to_string(id));
  }
  return *slot;
}

Term* Dictionary::MakeSlot(TermId id) {
  if (id >= kMaxTerms) throw std::runtime_error("the store has no more terms");
  const Place place = PlaceOf(id - first_, kFirstChunkBits);
  std::atomic<Term*>& chunk = chunks_[place.chunk];
  if (chunk.load() == nullptr) {
    const std::size_t size = std::size_t{1} << (kFirstChunkBits + place.chunk);
    chunk.store(static_cast<Term*>(::operator new(size * sizeof(Term))));
  }
  return chunk.load() + place.offset;
}

TermId Dictionary::Intern(const Term& term) {
  const Wanted wanted = Want(term);
  if (const TermId id = FindWanted(wanted, kMaxTerms)) return id;
  if (const TermId id = FindIn(unpublished_, wanted)) return id;
  const TermId id = next_id_;
  Term copy = term;
  Term* slot = MakeSlot(id);
  unpublished_.insert({id, wanted.hash});
  new (slot) Term(std::move(copy));
  next_id_ = id + 1;
  return id;
}

std::vector<std::pair<TermId, const Term*>> Dictionary::Unpublished() const {
  std::vector<std::pair<TermId, const Term*>> terms;
  for (TermId id = published_end_; id < next_id_; ++id) {
    terms.emplace_back(id, &Get(id));
  }
  return terms;
}

void Dictionary::PrepareToPublish() {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.reserve(published_.size() + unpublished_.size());
}

void Dictionary::Publish() noexcept {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.insert(unpublished_.begin(), unpublished_.end());
  unpublished_.clear();
  published_end_ = next_id_;
}

void Dictionary::Discard() {
  for (const Entry& entry : unpublished_) Slot(entry.id)->~Term();
  unpublished_.clear();
  next_id_ = published_end_;
}

void Dictionary::Restore(std::vector<std::pair<TermId, Term>> terms) {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.reserve(published_.size() + terms.size());
  for (auto& [id, term] : terms) {
    Term* slot = MakeSlot(id);
    published_.insert({id, Want(term).hash});
    new (slot) Term(std::move(term));
    next_id_ = published_end_ = id + 1;
  }
}

}  // namespace kg_core
