#include "kg_planner/tours/tour_search.h"

#include <algorithm>
#include <utility>

namespace kg_planner {
namespace {

constexpr std::size_t kMaxPool = 30000;

}  // namespace

TourSearch::TourSearch(const OrienteeringProblem& problem, unsigned seed)
    : problem_((Check(problem), problem)),
      size_(problem.size()),
      from_(problem.lengths),
      to_(problem.lengths.size()),
      near_(problem.size()),
      prng_(seed),
      tour_of_(problem.size(), -1),
      touched_(problem.tours, 0),
      weights_(problem.size(), 0.0),
      places_(problem.tours, std::vector<Place>(problem.size())) {
  for (int i = 0; i < size_; ++i) {
    for (int j = 0; j < size_; ++j) to_[j * size_ + i] = Length(i, j);
  }
  const int end = size_ - 1;
  // Points with a reward that a tour can reach within the limit.
  for (int p = 1; p < end; ++p) {
    if (problem_.rewards[p] > 0.0 &&
        Length(0, p) + Length(p, end) <= problem_.limit) {
      useful_.push_back(p);
    }
  }
  for (int p : useful_) {
    near_[p] = useful_;
    std::sort(near_[p].begin(), near_[p].end(), [&](int a, int b) {
      return std::make_pair(Length(p, a), a) < std::make_pair(Length(p, b), b);
    });
  }
  // Zobrist keys: a set of points is hashed by the xor of theirs.
  for (int p = 0; p < size_; ++p) {
    keys_.push_back((static_cast<std::uint64_t>(prng_()) << 32) | prng_());
  }
  // Initial solution: greedy insertion into empty tours.
  Clear(&now_);
  IndexPoints();
  best_ = kept_ = now_;
  if (!useful_.empty()) {
    Repair();
    Accept(0.0);
  }
}

std::uint32_t TourSearch::RandomBelow(std::uint32_t count) {
  return static_cast<std::uint32_t>(
      (static_cast<std::uint64_t>(prng_()) * count) >> 32);
}

double TourSearch::RandomUnit() {
  return static_cast<double>(prng_()) * 0x1p-32;
}

void TourSearch::Clear(Solution* solution) const {
  solution->tours.assign(problem_.tours, {0, size_ - 1});
  solution->lengths.assign(problem_.tours, Length(0, size_ - 1));
  solution->reward = 0.0;
}

void TourSearch::IndexPoints() {
  std::fill(tour_of_.begin(), tour_of_.end(), -1);
  for (int t = 0; t < problem_.tours; ++t) {
    for (int p : now_.tours[t]) tour_of_[p] = t;
  }
}

void TourSearch::Run(std::size_t steps, double tolerance) {
  if (useful_.empty()) return;
  for (std::size_t step = 0; step < steps; ++step) {
    now_ = kept_;
    IndexPoints();
    std::fill(touched_.begin(), touched_.end(), 0);
    Destroy();
    Repair();
    Accept(tolerance);
  }
}

void TourSearch::Restart(const std::vector<Tour>& tours) {
  Clear(&now_);
  for (std::size_t t = 0; t < tours.size() && t < now_.tours.size(); ++t) {
    now_.tours[t].insert(now_.tours[t].begin() + 1, tours[t].points.begin(),
                         tours[t].points.end());
    now_.lengths[t] = tours[t].length;
    now_.reward += tours[t].reward;
  }
  IndexPoints();
  std::fill(touched_.begin(), touched_.end(), 1);
  kept_ = now_;
  Accept(0.0);
}

bool TourSearch::Better(const Solution& a, const Solution& b) const {
  if (a.reward != b.reward) return a.reward > b.reward;
  double a_length = 0.0;
  double b_length = 0.0;
  for (double length : a.lengths) a_length += length;
  for (double length : b.lengths) b_length += length;
  return a_length < b_length;
}

// Recomputes lengths, because incremental updates drift. False if one exceeds
// the limit.
bool TourSearch::Remeasure() {
  for (std::size_t t = 0; t < now_.tours.size(); ++t) {
    if (touched_[t] == 0) continue;
    const std::vector<int>& points = now_.tours[t];
    double length = 0.0;
    for (std::size_t i = 1; i < points.size(); ++i) {
      length += Length(points[i - 1], points[i]);
    }
    now_.lengths[t] = length;
    if (points.size() > 2 && !(length <= problem_.limit)) return false;
  }
  now_.reward = 0.0;
  for (int p : useful_) {
    if (tour_of_[p] >= 0) now_.reward += problem_.rewards[p];
  }
  return true;
}

// Accepts a loss of up to tolerance * (1 - u) / (u + 1/4), u uniform in [0, 1):
// usually small, at most 4 times the tolerance.
void TourSearch::Accept(double tolerance) {
  if (!Remeasure()) return;
  const double chance = RandomUnit();
  const double loss = tolerance * (1.0 - chance) / (chance + 0.25);
  if (now_.reward + loss < kept_.reward) return;
  kept_ = now_;
  Remember(now_);
  if (Better(now_, best_)) best_ = now_;
}

void TourSearch::Remember(const Solution& solution) {
  for (std::size_t t = 0; t < solution.tours.size(); ++t) {
    const auto& points = solution.tours[t];
    std::uint64_t key = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) key ^= keys_[points[i]];
    if (points.size() <= 2) continue;
    if (pool_.size() >= kMaxPool && pool_.count(key) == 0) continue;
    PooledTour& pooled = pool_[key];
    pooled.context = std::max(pooled.context, solution.reward);
    if (pooled.tour.points.empty() ||
        solution.lengths[t] < pooled.tour.length) {
      pooled.tour = MakeTour(problem_, {points.begin() + 1, points.end() - 1});
    }
  }
}

std::vector<PooledTour> TourSearch::pool(std::size_t at_most) const {
  std::vector<PooledTour> tours;
  for (const auto& [key, tour] : pool_) tours.push_back(tour);
  std::sort(tours.begin(), tours.end(),
            [](const PooledTour& a, const PooledTour& b) {
              if (a.context != b.context) return a.context > b.context;
              return a.tour.points < b.tour.points;
            });
  if (tours.size() > at_most) tours.resize(at_most);
  return tours;
}

std::vector<Tour> TourSearch::best() const {
  std::vector<Tour> tours;
  for (const auto& points : best_.tours) {
    tours.push_back(MakeTour(problem_, {points.begin() + 1, points.end() - 1}));
  }
  return tours;
}

}  // namespace kg_planner
