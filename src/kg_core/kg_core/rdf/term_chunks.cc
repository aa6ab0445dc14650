#include "kg_core/rdf/term_chunks.h"

#include <algorithm>
#include <new>
#include <utility>

namespace kg_core {

TermChunks::Chunk::~Chunk() {
  for (std::size_t i = 0; i < kChunk; ++i) {
    if (filled[i]) slot(i)->~Term();
  }
}

void TermChunks::SetChunk(std::size_t at, std::shared_ptr<Chunk> chunk) {
  if (at >= chunks_.size()) chunks_.resize(at + 1);
  if (spines_.empty() || at >= spines_.back()->size) {
    auto longer = std::make_unique<const Spine>(std::max(2 * at, at + 4));
    for (std::size_t i = 0; i < chunks_.size(); ++i) {
      longer->chunks[i].store(chunks_[i].get(), std::memory_order_relaxed);
    }
    spines_.push_back(std::move(longer));
    spine_.store(spines_.back().get(), std::memory_order_release);
  }
  spines_.back()->chunks[at].store(chunk.get(), std::memory_order_release);
  chunks_[at] = std::move(chunk);
}

void TermChunks::Reserve(std::size_t index) {
  const std::size_t at = index / kChunk;
  if (at >= chunks_.size() || !chunks_[at]) {
    SetChunk(at, std::make_shared<Chunk>());
  }
}

void TermChunks::Fill(std::size_t index, Term term) noexcept {
  Chunk& chunk = *chunks_[index / kChunk];
  new (chunk.slot(index % kChunk)) Term(std::move(term));
  chunk.filled[index % kChunk] = true;
}

void TermChunks::Clear(std::size_t index) noexcept {
  Chunk& chunk = *chunks_[index / kChunk];
  chunk.slot(index % kChunk)->~Term();
  chunk.filled[index % kChunk] = false;
}

void TermChunks::TakeOver(const TermChunks& other,
                          absl::FunctionRef<bool(std::size_t)> keep) {
  for (std::size_t at = 0; at < other.chunks_.size(); ++at) {
    const std::shared_ptr<Chunk>& old = other.chunks_[at];
    if (!old) continue;
    std::bitset<kChunk> kept = old->filled;
    for (std::size_t i = 0; i < kChunk; ++i) {
      if (kept[i]) kept[i] = keep(at * kChunk + i);
    }
    if (kept == old->filled) {
      SetChunk(at, old);
    } else if (kept.any()) {
      SetChunk(at, std::make_shared<Chunk>());
      for (std::size_t i = 0; i < kChunk; ++i) {
        if (kept[i]) Fill(at * kChunk + i, *old->slot(i));
      }
    }
  }
}

}  // namespace kg_core
