// Anytime search for tours by destroy and repair. Each step removes points:
// strings of neighbouring points [1], or single ones. Unvisited points are
// inserted by reward per added length, even beyond the limit; then the points
// of least reward per saved length are removed until the limit holds, so that a
// tour can move to another region as a whole. Weights of points are randomised,
// and in some steps those of a neighbourhood are raised. Changed tours are
// reordered. The result is accepted if it is better, or not much worse
// (`tolerance`).
//
//   TourSearch search(problem, seed);
//   for (double t = 0.04; t > 0.004; t *= 0.9)
//     search.Run(1000, t * search.reward());
//   search.best(), search.pool()
//
// The same steps, tolerances and restarts give the same result on any machine.
// Lengths may be asymmetric and need not be planar; but insertion makes little
// use of detours that save length.
//
// [1] J. Christiaens and G. Vanden Berghe, "Slack Induction by String Removals"
//     (2020), doi:10.1287/trsc.2019.0914.

#ifndef KG_PLANNER_TOURS_TOUR_SEARCH_H_
#define KG_PLANNER_TOURS_TOUR_SEARCH_H_

#include <cstddef>
#include <cstdint>
#include <random>
#include <unordered_map>
#include <vector>

#include "kg_planner/tours/orienteering.h"

namespace kg_planner {

// A tour of a good solution.
struct PooledTour {
  Tour tour;
  double context = 0.0;  // Reward of the best solution it was part of.
};

class TourSearch {
 public:
  // Throws as Check() does. If no tour is within the limit, all stay empty.
  TourSearch(const OrienteeringProblem& problem, unsigned seed);

  // Runs `steps` steps; `tolerance` is the approximate loss accepted per step
  // [reward].
  void Run(std::size_t steps, double tolerance);
  // Restarts from these tours; they must keep the limit and share no point.
  void Restart(const std::vector<Tour>& tours);

  std::vector<Tour> best() const;
  // Reward of the best solution.
  double reward() const { return best_.reward; }

  // The shortest order of each point set found, best context first, ties by
  // points; at most `at_most`.
  std::vector<PooledTour> pool(std::size_t at_most) const;

 private:
  struct Solution {
    std::vector<std::vector<int>> tours;  // Start and end included.
    std::vector<double> lengths;
    double reward = 0.0;
  };
  struct Place {
    double detour = 0.0;
    int before = 0;  // Index in the tour; -1 = none fits.
  };

  double Length(int from, int to) const { return from_[from * size_ + to]; }
  std::uint32_t RandomBelow(std::uint32_t count);
  double RandomUnit();
  void Clear(Solution* solution) const;
  void IndexPoints();
  bool Better(const Solution& a, const Solution& b) const;
  bool Remeasure();
  void Accept(double tolerance);

  int Visited() const;
  void Destroy();
  void RemoveStrings(int points);
  void RemoveSingles(int points);
  void RemoveRun(int tour, int begin, int count);

  void Repair();
  void Fill(double limit);
  void Drop(int tour);
  void Weigh();
  void FavourNeighbourhood();
  Place BestPlace(int point, int tour) const;
  void Update(int point, int tour, int inserted_before);
  void Measure(int tour);
  void Insert(int point, int tour);

  bool Shorten();  // True if the length was reduced.
  bool Reverse(int tour);
  bool Move(int tour, int count);
  void Remember(const Solution& solution);

  const OrienteeringProblem problem_;
  const int size_;
  std::vector<double> from_;  // Lengths by (from, to).
  std::vector<double> to_;    // Lengths by (to, from).
  // Neighbours of each point, nearest first.
  std::vector<std::vector<int>> near_;
  std::vector<int> useful_;  // Points that a tour can visit.
  std::mt19937 prng_;

  Solution best_;
  Solution kept_;
  Solution now_;
  std::vector<int> tour_of_;   // Tour of each point in now_; -1 = not visited.
  std::vector<char> touched_;  // Tours changed in this step.
  std::vector<double> weights_;  // Weight of each point in this step.
  std::vector<int> open_;        // Points to be inserted.
  std::vector<std::vector<Place>> places_;  // Best place, by tour and point.
  std::vector<double> edges_;        // Edge length into each point of a tour.
  std::vector<std::uint64_t> keys_;  // Zobrist key of each point.
  std::unordered_map<std::uint64_t, PooledTour> pool_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_TOUR_SEARCH_H_
