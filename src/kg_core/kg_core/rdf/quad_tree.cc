#include "kg_core/rdf/quad_tree.h"

#include <algorithm>
#include <atomic>
#include <numeric>

namespace kg_core {
namespace {

constexpr std::size_t kMaxKeys = 64;
// Fill of nodes built from sorted keys.
constexpr std::size_t kFilledKeys = 56;
// Below it, a node is merged with a neighbour.
constexpr std::size_t kMinKeys = 16;
// Largest merged node, so that it can grow.
constexpr std::size_t kMergedKeys = 48;

}  // namespace

// Published nodes are never changed.
struct QuadTree::Node {
  std::uint64_t edit = 0;         // Edit that made the node and may change it.
  std::vector<QuadKey> keys;      // A leaf's keys, or each child's smallest.
  std::vector<NodePtr> children;  // Empty in a leaf.
  std::vector<std::uint32_t> sizes;  // Keys below each child.

  bool is_leaf() const { return children.empty(); }

  // Reserves kMaxKeys: automatic vector growth would allocate 128.
  void CopyWithRoom(const Node& other) {
    keys.reserve(kMaxKeys + 1);
    keys = other.keys;
    if (other.is_leaf()) return;
    children.reserve(kMaxKeys + 1);
    children = other.children;
    sizes.reserve(kMaxKeys + 1);
    sizes = other.sizes;
  }

  std::size_t size() const {
    if (is_leaf()) return keys.size();
    return std::accumulate(sizes.begin(), sizes.end(), std::size_t{0});
  }

  std::size_t ChildFor(const QuadKey& key) const {
    const auto after = std::upper_bound(keys.begin(), keys.end(), key);
    return after == keys.begin() ? 0 : after - keys.begin() - 1;
  }

  void AddChild(std::size_t at, NodePtr child) {
    keys.insert(keys.begin() + at, child->keys[0]);
    sizes.insert(sizes.begin() + at, child->size());
    children.insert(children.begin() + at, std::move(child));
  }

  void RemoveChild(std::size_t at) {
    keys.erase(keys.begin() + at);
    sizes.erase(sizes.begin() + at);
    children.erase(children.begin() + at);
  }

  void RefreshChild(std::size_t at) {
    keys[at] = children[at]->keys[0];
    sizes[at] = children[at]->size();
  }
};

QuadTree QuadTree::FromSorted(const std::vector<QuadKey>& keys) {
  QuadTree tree;
  if (keys.empty()) return tree;
  std::vector<NodePtr> level;
  for (std::size_t at = 0; at < keys.size(); at += kFilledKeys) {
    const std::size_t end = std::min(at + kFilledKeys, keys.size());
    level.push_back(std::make_shared<Node>());
    level.back()->keys.assign(keys.begin() + at, keys.begin() + end);
  }
  // Build inner nodes level by level until one root is left.
  while (level.size() > 1) {
    std::vector<NodePtr> above;
    for (std::size_t i = 0; i < level.size(); ++i) {
      if (i % kFilledKeys == 0) above.push_back(std::make_shared<Node>());
      above.back()->AddChild(i % kFilledKeys, std::move(level[i]));
    }
    level = std::move(above);
  }
  tree.root_ = std::move(level[0]);
  return tree;
}

std::uint64_t QuadTree::NewEdit() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

QuadTree::Node& QuadTree::Editable(NodePtr* slot, std::uint64_t edit) {
  if ((*slot)->edit != edit) {
    const auto copy = std::make_shared<Node>();
    copy->CopyWithRoom(**slot);
    copy->edit = edit;
    *slot = copy;
  }
  return **slot;
}

bool QuadTree::Insert(const QuadKey& key, std::uint64_t edit) {
  if (Contains(key)) return false;
  if (!root_) {
    root_ = std::make_shared<Node>();
    root_->edit = edit;
  }
  InsertBelow(&root_, key, edit);
  if (root_->keys.size() <= kMaxKeys) return true;
  const auto above = std::make_shared<Node>();
  above->edit = edit;
  above->AddChild(0, std::move(root_));
  root_ = above;
  SplitChild(root_.get(), 0, edit);
  return true;
}

void QuadTree::InsertBelow(NodePtr* slot, const QuadKey& key,
                           std::uint64_t edit) {
  Node& node = Editable(slot, edit);
  if (node.is_leaf()) {
    node.keys.insert(std::lower_bound(node.keys.begin(), node.keys.end(), key),
                     key);
    return;
  }
  const std::size_t which = node.ChildFor(key);
  InsertBelow(&node.children[which], key, edit);
  node.RefreshChild(which);
  if (node.children[which]->keys.size() > kMaxKeys) {
    SplitChild(&node, which, edit);
  }
}

void QuadTree::SplitChild(Node* parent, std::size_t which, std::uint64_t edit) {
  Node& left = Editable(&parent->children[which], edit);
  const auto right = std::make_shared<Node>();
  right->edit = edit;
  const std::size_t half = left.keys.size() / 2;
  right->keys.reserve(kMaxKeys + 1);
  right->keys.assign(left.keys.begin() + half, left.keys.end());
  left.keys.resize(half);
  if (!left.is_leaf()) {
    right->children.assign(left.children.begin() + half, left.children.end());
    right->sizes.assign(left.sizes.begin() + half, left.sizes.end());
    left.children.resize(half);
    left.sizes.resize(half);
  }
  parent->RefreshChild(which);
  parent->AddChild(which + 1, right);
}

bool QuadTree::Erase(const QuadKey& key, std::uint64_t edit) {
  if (!Contains(key)) return false;
  EraseBelow(&root_, key, edit);
  while (!root_->is_leaf() && root_->children.size() == 1) {
    const NodePtr only = root_->children[0];
    root_ = only;
  }
  if (root_->keys.empty()) root_.reset();
  return true;
}

void QuadTree::EraseBelow(NodePtr* slot, const QuadKey& key,
                          std::uint64_t edit) {
  Node& node = Editable(slot, edit);
  if (node.is_leaf()) {
    node.keys.erase(std::lower_bound(node.keys.begin(), node.keys.end(), key));
    return;
  }
  const std::size_t which = node.ChildFor(key);
  EraseBelow(&node.children[which], key, edit);
  if (node.children[which]->keys.empty()) {
    node.RemoveChild(which);
    return;
  }
  node.RefreshChild(which);
  if (node.children[which]->keys.size() < kMinKeys) {
    MergeChild(&node, which, edit);
  }
}

// Merges the child with a neighbouring child if the merged node would still
// have free slots.
void QuadTree::MergeChild(Node* parent, std::size_t which, std::uint64_t edit) {
  if (parent->children.size() < 2) return;
  const std::size_t at = which == 0 ? 0 : which - 1;
  const Node& right = *parent->children[at + 1];
  if (parent->children[at]->keys.size() + right.keys.size() > kMergedKeys) {
    return;
  }
  Node& left = Editable(&parent->children[at], edit);
  left.keys.insert(left.keys.end(), right.keys.begin(), right.keys.end());
  left.children.insert(left.children.end(), right.children.begin(),
                       right.children.end());
  left.sizes.insert(left.sizes.end(), right.sizes.begin(), right.sizes.end());
  parent->RefreshChild(at);
  parent->RemoveChild(at + 1);
}

bool QuadTree::Contains(const QuadKey& key) const {
  const Node* node = root_.get();
  if (node == nullptr) return false;
  while (!node->is_leaf()) {
    node = node->children[node->ChildFor(key)].get();
  }
  return std::binary_search(node->keys.begin(), node->keys.end(), key);
}

std::size_t QuadTree::size() const { return root_ ? root_->size() : 0; }

std::size_t QuadTree::CountBefore(const QuadKey& key) const {
  const Node* node = root_.get();
  if (node == nullptr) return 0;
  std::size_t count = 0;
  while (!node->is_leaf()) {
    const std::size_t which = node->ChildFor(key);
    count = std::accumulate(node->sizes.begin(), node->sizes.begin() + which,
                            count);
    node = node->children[which].get();
  }
  return count + (std::lower_bound(node->keys.begin(), node->keys.end(), key) -
                  node->keys.begin());
}

std::size_t QuadTree::CountBetween(const QuadKey& first,
                                   const QuadKey& last) const {
  if (last < first) return 0;
  return CountBefore(last) + (Contains(last) ? 1 : 0) - CountBefore(first);
}

void QuadTree::Scan(const QuadKey& first, const QuadKey& last,
                    absl::FunctionRef<bool(const QuadKey&)> visit) const {
  if (root_) ScanBelow(*root_, first, last, visit);
}

bool QuadTree::ScanBelow(const Node& node, const QuadKey& first,
                         const QuadKey& last,
                         absl::FunctionRef<bool(const QuadKey&)> visit) {
  if (node.is_leaf()) {
    auto key = std::lower_bound(node.keys.begin(), node.keys.end(), first);
    for (; key != node.keys.end(); ++key) {
      if (last < *key || !visit(*key)) return false;
    }
    return true;
  }
  for (std::size_t i = node.ChildFor(first); i < node.children.size(); ++i) {
    if (last < node.keys[i]) return false;
    if (!ScanBelow(*node.children[i], first, last, visit)) return false;
  }
  return true;
}

}  // namespace kg_core
