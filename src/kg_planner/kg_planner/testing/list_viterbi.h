// List Viterbi, the standard algorithm for K best paths and the baseline of the
// benchmark: the K best suffixes of every node, merged from those of its
// successors by a heap [1]. O(stages nodes (nodes + K log nodes)).
//
// [1] N. Seshadri and C.-E. W. Sundberg, "List Viterbi Decoding Algorithms with
//     Applications", IEEE Trans. Communications 42 (1994), 313-323.

#ifndef KG_PLANNER_TESTING_LIST_VITERBI_H_
#define KG_PLANNER_TESTING_LIST_VITERBI_H_

#include <algorithm>
#include <cstddef>
#include <vector>

#include "kg_planner/trellis/trellis.h"

namespace kg_planner {

class ListViterbi {
 public:
  // For trellises without tokens, stops and limits, seams ascending by `from`.
  ListViterbi(const Trellis& trellis, std::size_t paths)
      : trellis_(trellis), paths_(paths), levels_(trellis.stages.size() + 1) {
    const std::size_t stages = trellis.stages.size();
    levels_[stages].assign(trellis.stages.back().nodes.size(), {{0.0, -1, 0}});
    for (std::size_t s = stages; s-- > 0;) Merge(s);
  }

  // Scores, best first.
  std::vector<double> Scores() const {
    std::vector<double> scores;
    for (const Rest& rest : levels_[0][0]) scores.push_back(rest.score);
    return scores;
  }

  // Nodes of the path of this rank.
  std::vector<int> Nodes(int rank) const {
    std::vector<int> nodes;
    int node = 0;
    for (std::size_t s = 0; s < trellis_.stages.size(); ++s) {
      const Rest& rest = levels_[s][node][rank];
      node = trellis_.stages[s].seams[rest.seam].to;
      rank = rest.rank;
      nodes.push_back(node);
    }
    return nodes;
  }

 private:
  struct Rest {
    double score = 0.0;
    int seam = -1;
    int rank = 0;  // Rank among the suffixes of the seam's target.
  };
  static bool Worse(const Rest& a, const Rest& b) {
    if (a.score != b.score) return a.score < b.score;
    return a.seam > b.seam || (a.seam == b.seam && a.rank > b.rank);
  }

  void Merge(std::size_t s) {
    const Stage& stage = trellis_.stages[s];
    levels_[s].resize(s == 0 ? 1 : trellis_.stages[s - 1].nodes.size());
    std::vector<Rest> heap;
    std::size_t i = 0;
    while (i < stage.seams.size()) {
      const int from = stage.seams[i].from;
      heap.clear();
      for (; i < stage.seams.size() && stage.seams[i].from == from; ++i) {
        AddRest(s, static_cast<int>(i), 0, &heap);
      }
      std::make_heap(heap.begin(), heap.end(), Worse);
      TakeBest(s, &heap, &levels_[s][from]);
    }
  }
  void AddRest(std::size_t s, int seam, int rank,
               std::vector<Rest>* rests) const {
    const Seam& over = trellis_.stages[s].seams[seam];
    const std::vector<Rest>& there = levels_[s + 1][over.to];
    if (rank >= static_cast<int>(there.size())) return;
    rests->push_back({there[rank].score - over.cost +
                          trellis_.stages[s].nodes[over.to].reward,
                      seam, rank});
  }
  void TakeBest(std::size_t s, std::vector<Rest>* heap,
                std::vector<Rest>* best) const {
    best->reserve(paths_);
    while (!heap->empty() && best->size() < paths_) {
      std::pop_heap(heap->begin(), heap->end(), Worse);
      best->push_back(heap->back());
      heap->pop_back();
      const std::size_t size = heap->size();
      AddRest(s, best->back().seam, best->back().rank + 1, heap);
      if (heap->size() > size) {
        std::push_heap(heap->begin(), heap->end(), Worse);
      }
    }
  }

  const Trellis& trellis_;
  std::size_t paths_;
  // Indexed by level, node and rank.
  std::vector<std::vector<std::vector<Rest>>> levels_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TESTING_LIST_VITERBI_H_
