#include "kg_core/rdf/dictionary.h"

#include <algorithm>
#include <mutex>
#include <shared_mutex>
#include <stdexcept>
#include <string>
#include <utility>

#include "absl/hash/hash.h"

namespace kg_core {
namespace {

using kg_base::WriterFirstMutex;

}  // namespace

Dictionary::Dictionary() : Dictionary(nullptr, 1) {}

Dictionary::Dictionary(std::shared_ptr<const Dictionary> base, TermId base_end)
    : base_(std::move(base)),
      base_end_(base_end),
      first_(base_ ? std::max(base_end, base_->free_from_) : 1),
      free_from_(first_),
      unpublished_(0, Hash{}, Equal{this}),
      published_(0, Hash{}, Equal{this}) {}

Dictionary::Wanted Dictionary::Want(const Term& term) {
  constexpr std::uint32_t kBits = 0x7FFFFFFF;
  return {term, kBits & static_cast<std::uint32_t>(
                            absl::HashOf(static_cast<int>(term.kind), term.text,
                                         term.datatype, term.language))};
}

TermId Dictionary::FindWanted(const Wanted& wanted, TermId end) const {
  {
    const std::shared_lock<WriterFirstMutex> lock(mutex_);
    const auto found = published_.find(wanted);
    if (found != published_.end()) {
      return found->is_old || found->id < end ? found->id : kNoTerm;
    }
  }
  return base_ ? base_->FindWanted(wanted, base_end_) : kNoTerm;
}

TermId Dictionary::FindUnpublished(const Wanted& wanted) const {
  const auto found = unpublished_.find(wanted);
  return found == unpublished_.end() ? kNoTerm : found->id;
}

TermId Dictionary::Find(const Term& term, TermId end) const {
  return FindWanted(Want(term), end);
}

TermId Dictionary::FindUnpublished(const Term& term) const {
  return unpublished_.empty() ? kNoTerm : FindUnpublished(Want(term));
}

const Term& Dictionary::Get(TermId id) const {
  if (base_ && id < first_) return base_->Get(id);
  const Term* term = id >= first_ ? terms_.At(id - first_) : nullptr;
  if (term == nullptr) {
    throw std::out_of_range("no term has the id " + std::to_string(id));
  }
  return *term;
}

std::size_t Dictionary::size() const {
  const std::shared_lock<WriterFirstMutex> lock(mutex_);
  return published_.size();
}

TermId Dictionary::IdAt(std::size_t n) const {
  return n < free_ids_.size()
             ? free_ids_[n]
             : static_cast<TermId>(free_from_ + (n - free_ids_.size()));
}

TermId Dictionary::ids_end() const { return std::max(next_id(), free_from_); }

TermId Dictionary::Intern(const Term& term) {
  const Wanted wanted = Want(term);
  if (const TermId id = FindWanted(wanted, kMaxTerms)) return id;
  if (const TermId id = FindUnpublished(wanted)) return id;
  const TermId id = next_id();
  if (id >= kMaxTerms) throw std::runtime_error("the store has no more terms");
  Term copy = term;
  terms_.Reserve(id - first_);
  unpublished_.insert({id, wanted.hash, 0});
  terms_.Fill(id - first_, std::move(copy));
  ++given_;
  return id;
}

std::vector<std::pair<TermId, const Term*>> Dictionary::Unpublished() const {
  std::vector<std::pair<TermId, const Term*>> terms;
  for (std::size_t n = published_given_; n < given_; ++n) {
    terms.emplace_back(IdAt(n), &Get(IdAt(n)));
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
  published_given_ = given_;
}

void Dictionary::Discard() {
  for (const Entry& entry : unpublished_) terms_.Clear(entry.id - first_);
  unpublished_.clear();
  given_ = published_given_;
}

void Dictionary::Restore(std::vector<std::pair<TermId, Term>> terms,
                         TermId end) {
  const std::lock_guard<WriterFirstMutex> lock(mutex_);
  published_.reserve(terms.size());
  for (auto& [id, term] : terms) {
    terms_.Reserve(id - first_);
    published_.insert({id, Want(term).hash, 1});
    terms_.Fill(id - first_, std::move(term));
  }
  free_from_ = end;
}

std::vector<std::pair<TermId, const Term*>> Dictionary::Unused(
    const std::vector<bool>& used) const {
  std::vector<std::pair<TermId, const Term*>> terms;
  const std::shared_lock<WriterFirstMutex> lock(mutex_);
  for (const Entry& entry : published_) {
    if (!used[entry.id]) terms.emplace_back(entry.id, &Get(entry.id));
  }
  return terms;
}

std::shared_ptr<Dictionary> Dictionary::Compacted(
    const std::vector<bool>& used, const std::vector<bool>& taken) const {
  auto fresh = std::make_shared<Dictionary>(base_, base_end_);
  fresh->terms_.TakeOver(
      terms_, [&](std::size_t index) { return used[first_ + index]; });
  fresh->published_.reserve(std::count(used.begin(), used.end(), true));
  const std::shared_lock<WriterFirstMutex> lock(mutex_);
  for (const Entry& entry : published_) {
    if (used[entry.id]) fresh->published_.insert({entry.id, entry.hash, 1});
  }
  fresh->free_from_ = ids_end();
  for (TermId id = first_; id < fresh->free_from_; ++id) {
    if (!taken[id]) fresh->free_ids_.push_back(id);
  }
  return fresh;
}

}  // namespace kg_core
