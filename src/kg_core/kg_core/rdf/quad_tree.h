// One sort order of the quads: a persistent B+ tree of packed keys whose copies
// share nodes (path copying).
//
// Copying a tree copies one pointer. Changing a copy copies only the nodes on
// the path from the root to the change (about 4 KB for a million keys), so
// older copies are unaffected. This makes snapshots cheap and safe to read
// without locks while a writer continues. Within one edit (a number from
// NewEdit), nodes created by that edit are changed in place.
//
// Subtree sizes are kept in the nodes, so counting a range costs O(log n).

#ifndef KG_CORE_RDF_QUAD_TREE_H_
#define KG_CORE_RDF_QUAD_TREE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "absl/functional/function_ref.h"

namespace kg_core {

// Four term ids in the order of an index; the first is in the high 32 bits of
// `high`.
struct QuadKey {
  std::uint64_t high = 0;
  std::uint64_t low = 0;
};

inline bool operator==(const QuadKey& a, const QuadKey& b) {
  return a.high == b.high && a.low == b.low;
}
inline bool operator<(const QuadKey& a, const QuadKey& b) {
  return a.high != b.high ? a.high < b.high : a.low < b.low;
}

class QuadTree {
 public:
  QuadTree() = default;
  // `keys` must be sorted and without duplicates.
  static QuadTree FromSorted(const std::vector<QuadKey>& keys);

  // Returns an edit number not used before in this process.
  static std::uint64_t NewEdit();

  // False if already present.
  bool Insert(const QuadKey& key, std::uint64_t edit);
  bool Erase(const QuadKey& key, std::uint64_t edit);  // False if absent.

  bool Contains(const QuadKey& key) const;
  std::size_t size() const;
  // Number of keys in [first, last].
  std::size_t CountBetween(const QuadKey& first, const QuadKey& last) const;
  // Visits the keys in [first, last] in order until `visit` returns false.
  void Scan(const QuadKey& first, const QuadKey& last,
            absl::FunctionRef<bool(const QuadKey&)> visit) const;

 private:
  struct Node;
  using NodePtr = std::shared_ptr<Node>;

  static Node& Editable(NodePtr* slot, std::uint64_t edit);
  static void InsertBelow(NodePtr* slot, const QuadKey& key,
                          std::uint64_t edit);
  static void EraseBelow(NodePtr* slot, const QuadKey& key, std::uint64_t edit);
  static void SplitChild(Node* parent, std::size_t which, std::uint64_t edit);
  static void MergeChild(Node* parent, std::size_t which, std::uint64_t edit);
  static bool ScanBelow(const Node& node, const QuadKey& first,
                        const QuadKey& last,
                        absl::FunctionRef<bool(const QuadKey&)> visit);
  std::size_t CountBefore(const QuadKey& key) const;

  NodePtr root_;  // Null when empty.
};

}  // namespace kg_core

#endif  // KG_CORE_RDF_QUAD_TREE_H_
