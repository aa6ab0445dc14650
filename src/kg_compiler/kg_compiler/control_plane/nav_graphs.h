// The graphs of an agent's windows, in order. Copies share graphs, so graphs
// that did not change between compiles are stored once.

#ifndef KG_COMPILER_CONTROL_PLANE_NAV_GRAPHS_H_
#define KG_COMPILER_CONTROL_PLANE_NAV_GRAPHS_H_

#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "kg_compiler/control_plane/waypoint_graph.h"

namespace kg_compiler {

class NavGraphs {
 public:
  using Pointer = std::shared_ptr<const NavGraph>;

  // Iterates over the graphs, not the pointers.
  class Iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = NavGraph;
    using difference_type = std::ptrdiff_t;
    using pointer = const NavGraph*;
    using reference = const NavGraph&;

    explicit Iterator(std::vector<Pointer>::const_iterator at) : at_(at) {}
    const NavGraph& operator*() const { return **at_; }
    const NavGraph* operator->() const { return at_->get(); }
    Iterator& operator++() {
      ++at_;
      return *this;
    }
    friend bool operator==(Iterator a, Iterator b) { return a.at_ == b.at_; }
    friend bool operator!=(Iterator a, Iterator b) { return a.at_ != b.at_; }

   private:
    std::vector<Pointer>::const_iterator at_;
  };

  NavGraphs() = default;
  NavGraphs(std::vector<NavGraph> graphs) {  // NOLINT: the same, shared.
    for (NavGraph& graph : graphs) push_back(std::move(graph));
  }

  std::size_t size() const { return graphs_.size(); }
  bool empty() const { return graphs_.empty(); }
  const NavGraph& operator[](std::size_t i) const { return *graphs_[i]; }
  const NavGraph& at(std::size_t i) const { return *graphs_.at(i); }
  const NavGraph& front() const { return *graphs_.front(); }
  const NavGraph& back() const { return *graphs_.back(); }
  Iterator begin() const { return Iterator(graphs_.begin()); }
  Iterator end() const { return Iterator(graphs_.end()); }
  const Pointer& Share(std::size_t i) const { return graphs_[i]; }

  void push_back(NavGraph graph) {
    graphs_.push_back(std::make_shared<const NavGraph>(std::move(graph)));
  }
  void push_back(Pointer graph) { graphs_.push_back(std::move(graph)); }
  void resize(std::size_t size) {
    while (graphs_.size() > size) graphs_.pop_back();
    while (graphs_.size() < size) push_back(NavGraph());
  }
  void clear() { graphs_.clear(); }
  void pop_back() { graphs_.pop_back(); }
  // Replaces the i-th graph.
  void Replace(std::size_t i, NavGraph graph) {
    graphs_[i] = std::make_shared<const NavGraph>(std::move(graph));
  }

 private:
  std::vector<Pointer> graphs_;
};

}  // namespace kg_compiler

#endif  // KG_COMPILER_CONTROL_PLANE_NAV_GRAPHS_H_
