// Chunked storage for the terms of a dictionary. Terms never move, and chunks
// can be shared with the compacted dictionary.
//
// One writer, any number of readers. A reader may only access slots that it
// knows, by other synchronization, to be filled.

#ifndef KG_CORE_RDF_TERM_CHUNKS_H_
#define KG_CORE_RDF_TERM_CHUNKS_H_

#include <atomic>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "absl/functional/function_ref.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

class TermChunks {
 public:
  TermChunks() = default;
  TermChunks(const TermChunks&) = delete;
  TermChunks& operator=(const TermChunks&) = delete;

  // For readers. Null if there is no chunk at this index.
  const Term* At(std::size_t index) const {
    const Spine* spine = spine_.load(std::memory_order_acquire);
    const std::size_t chunk = index / kChunk;
    if (spine == nullptr || chunk >= spine->size) return nullptr;
    const Chunk* slots = spine->chunks[chunk].load(std::memory_order_acquire);
    return slots == nullptr ? nullptr : slots->slot(index % kChunk);
  }

  // For the writer.
  // Allocates the slot, so that Fill cannot fail.
  void Reserve(std::size_t index);
  void Fill(std::size_t index, Term term) noexcept;
  void Clear(std::size_t index) noexcept;
  // Takes the terms of `other` for which `keep(index)` is true: chunks kept as
  // a whole are shared, from other chunks the kept terms are copied.
  // Precondition: this object is empty; afterwards `other` must not be written
  // to.
  void TakeOver(const TermChunks& other,
                absl::FunctionRef<bool(std::size_t)> keep);

 private:
  static constexpr std::size_t kChunk = 256;

  // A slot without a term is raw memory.
  struct Chunk {
    Chunk() = default;
    ~Chunk();
    Chunk(const Chunk&) = delete;
    Chunk& operator=(const Chunk&) = delete;

    const Term* slot(std::size_t i) const {
      return reinterpret_cast<const Term*>(memory) + i;
    }
    Term* slot(std::size_t i) { return reinterpret_cast<Term*>(memory) + i; }

    std::bitset<kChunk> filled;  // For the writer and the destructor.
    alignas(Term) unsigned char memory[kChunk * sizeof(Term)];
  };
  // Array of chunk pointers. When it is outgrown, the old array is kept for
  // readers that still use it.
  struct Spine {
    explicit Spine(std::size_t size)
        : size(size), chunks(new std::atomic<Chunk*>[size]()) {}
    std::size_t size;
    std::unique_ptr<std::atomic<Chunk*>[]> chunks;
  };

  void SetChunk(std::size_t at, std::shared_ptr<Chunk> chunk);

  std::atomic<const Spine*> spine_{nullptr};  // The last of spines_.
  std::vector<std::unique_ptr<const Spine>> spines_;
  std::vector<std::shared_ptr<Chunk>> chunks_;
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_TERM_CHUNKS_H_
