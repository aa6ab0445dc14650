// Anytime search for tours. In each step some points leave: strings of them
// near one another [1], or single ones. The others are inserted where they give
// most for the length they cost, beyond the limit; then those that give least
// leave again until the limit is kept, so that a tour can move somewhere else
// as a whole. What a point counts is blurred by chance, and that of a whole
// neighbourhood is raised in some steps. Tours touched are put in better order.
// The outcome is kept if it is better, or not much worse (`tolerance`).
//
//   TourSearch search(problem, seed);
//   for (double t = 0.04; t > 0.004; t *= 0.9)
//     search.Run(1000, t * search.reward());
//   search.best(), search.pool()
//
// The same steps, tolerances and restarts give the same answer wherever it
// runs. Symmetric or not, lengths need not be those of a plane; but insertion
// thinks little of detours that save length.
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
  // Throws as Check() does. Without any tour within the limit all stay empty.
  TourSearch(const OrienteeringProblem& problem, unsigned seed);

  // So many steps; `tolerance` is about what a step may lose [reward].
  void Run(std::size_t steps, double tolerance);
  // Goes on from these; they must keep the limit and share no point.
  void Restart(const std::vector<Tour>& tours);

  std::vector<Tour> best() const;
  double reward() const { return best_.reward; }  // Of the best solution.

  // Of each set of points met the shortest order, best context first, ties by
  // points; at most so many.
  std::vector<PooledTour> pool(std::size_t at_most) const;

 private:
  struct Solution {
    std::vector<std::vector<int>> tours;  // With start and end.
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

  bool Shorten();  // Did anything save length?
  bool Reverse(int tour);
  bool Move(int tour, int count);
  void Remember(const Solution& solution);

  const OrienteeringProblem problem_;
  const int size_;
  std::vector<double> from_;  // Lengths, row by row of where they begin,
  std::vector<double> to_;    // and of where they end.
  std::vector<std::vector<int>> near_;  // By point, the nearest first.
  std::vector<int> useful_;             // Points that a tour can visit.
  std::mt19937 prng_;

  Solution best_;
  Solution kept_;
  Solution now_;
  std::vector<int> tour_of_;     // By point in now_; -1 = not visited.
  std::vector<char> touched_;    // By tour: changed in this step.
  std::vector<double> weights_;  // By point, of this step.
  std::vector<int> open_;        // Points that wait for insertion.
  std::vector<std::vector<Place>> places_;  // By tour, by point.
  std::vector<double> edges_;  // Lengths of a tour, into each of its points.
  std::vector<std::uint64_t> keys_;  // By point, for hashes of sets.
  std::unordered_map<std::uint64_t, PooledTour> pool_;
};

}  // namespace kg_planner

#endif  // KG_PLANNER_TOURS_TOUR_SEARCH_H_
