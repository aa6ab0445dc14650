// Slots for the terms of a dictionary, which never move and can be shared with
// the dictionary that follows it.
//
// One writer, any number of readers; a reader only asks for slots of which it
// knows, through something else, that they were filled.

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

  // Readers. Null if there is no chunk at this index.
  const Term* At(std::size_t index) const {
    const Spine* spine = spine_.load(std::memory_order_acquire);
    const std::size_t chunk = index / kChunk;
    if (spine == nullptr || chunk >= spine->size) return nullptr;
    const Chunk* slots = spine->chunks[chunk].load(std::memory_order_acquire);
    return slots == nullptr ? nullptr : slots->slot(index % kChunk);
  }

  // The writer.
  void Reserve(std::size_t index);  // Room at it, so that Fill cannot fail.
  void Fill(std::size_t index, Term term) noexcept;
  void Clear(std::size_t index) noexcept;
  // Takes over what `other` has where `keep(index)` is true: whole chunks are
  // shared, of others the kept terms are copied. This must be empty, and
  // `other` is not to be written to any more.
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
  // The way to the chunks. One that has become too short is kept for readers
  // that have it in hand.
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
