// TourSearch: insertion of points.

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_planner/tours/tour_search.h"

namespace kg_planner {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRepairTolerance = 1e-9;  // Relative to the limit.
constexpr double kMaxExcess = 0.4;  // Share of the limit that a tour may exceed
                                    // before points are removed.
// Share of steps that favour a neighbourhood.
constexpr double kFavourShare = 0.6;
constexpr double kMaxFavour = 3.0;  // Maximum increase of its weights.

}  // namespace

void TourSearch::Repair() {
  Weigh();
  if (RandomUnit() < kFavourShare) FavourNeighbourhood();
  Fill(problem_.limit * (1.0 + kMaxExcess * RandomUnit()));
  Shorten();
  for (int t = 0; t < problem_.tours; ++t) Drop(t);
  Shorten();
  Fill(problem_.limit);
}

// Weights of points in this step: a random power of the reward, randomised.
void TourSearch::Weigh() {
  const std::uint32_t power = RandomBelow(4);
  const double blur = static_cast<double>(RandomBelow(4)) / 3.0;
  open_.clear();
  for (int p : useful_) {
    const double reward = problem_.rewards[p];
    double weight = reward;
    if (power == 0) weight = std::sqrt(reward);
    if (power == 2) weight = reward * std::sqrt(reward);
    if (power == 3) weight = reward * reward;
    weights_[p] = weight * (1.0 - blur * RandomUnit());
    if (tour_of_[p] < 0) open_.push_back(p);
  }
}

// Raises the weights of a neighbourhood.
void TourSearch::FavourNeighbourhood() {
  const std::uint32_t useful = static_cast<std::uint32_t>(useful_.size());
  const int around = useful_[RandomBelow(useful)];
  const std::uint32_t count = 2 + RandomBelow(std::max(1u, useful / 4));
  const double factor = 1.0 + kMaxFavour * RandomUnit();
  for (std::uint32_t i = 0; i < std::min(count, useful); ++i) {
    weights_[near_[around][i]] *= factor;
  }
}

// Removes points from a tour beyond the limit: lowest weight per saved length
// first.
void TourSearch::Drop(int tour) {
  const std::vector<int>& p = now_.tours[tour];
  const double grain = kRepairTolerance * problem_.limit + 1e-300;
  while (now_.lengths[tour] > problem_.limit && p.size() > 2) {
    double best_weight = kInfinity;  // Smallest rate so far, as a fraction.
    double best_saved = 1.0;
    int best = 1;
    for (int i = 1; i + 1 < static_cast<int>(p.size()); ++i) {
      const double saved = Length(p[i - 1], p[i]) + Length(p[i], p[i + 1]) -
                           Length(p[i - 1], p[i + 1]);
      const double at_least = std::max(saved, grain);
      if (weights_[p[i]] * best_saved < best_weight * at_least) {
        best_weight = weights_[p[i]];
        best_saved = at_least;
        best = i;
      }
    }
    open_.push_back(p[best]);
    RemoveRun(tour, best, 1);
  }
}

void TourSearch::Measure(int tour) {
  const std::vector<int>& points = now_.tours[tour];
  edges_.resize(points.size());
  for (std::size_t i = 1; i < points.size(); ++i) {
    edges_[i] = Length(points[i - 1], points[i]);
  }
}

// Uses the result of Measure() for this tour.
TourSearch::Place TourSearch::BestPlace(int point, int tour) const {
  const std::vector<int>& points = now_.tours[tour];
  const double* from = &from_[static_cast<std::size_t>(point) * size_];
  const double* to = &to_[static_cast<std::size_t>(point) * size_];
  Place best{kInfinity, -1};
  double arrive = to[points[0]];
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double detour = arrive + from[points[i]] - edges_[i];
    if (detour < best.detour) best = {detour, static_cast<int>(i)};
    arrive = to[points[i]];
  }
  return best;
}

// After an insertion before index `at` only two places are new, and one is
// removed.
void TourSearch::Update(int point, int tour, int at) {
  Place& place = places_[tour][point];
  if (place.before == at) {
    place = BestPlace(point, tour);
    return;
  }
  if (place.before > at) ++place.before;
  const std::vector<int>& points = now_.tours[tour];
  const double* from = &from_[static_cast<std::size_t>(point) * size_];
  const double* to = &to_[static_cast<std::size_t>(point) * size_];
  for (int i = at; i <= at + 1; ++i) {
    const double detour = to[points[i - 1]] + from[points[i]] - edges_[i];
    if (detour < place.detour) place = {detour, i};
  }
}

void TourSearch::Insert(int point, int tour) {
  const Place place = places_[tour][point];
  std::vector<int>& points = now_.tours[tour];
  points.insert(points.begin() + place.before, point);
  now_.lengths[tour] += place.detour;
  now_.reward += problem_.rewards[point];
  tour_of_[point] = tour;
  touched_[tour] = 1;
}

// Inserts the point of largest weight per detour while any fits.
void TourSearch::Fill(double limit) {
  const double grain = kRepairTolerance * problem_.limit + 1e-300;
  for (int t = 0; t < problem_.tours; ++t) {
    Measure(t);
    for (int p : open_) places_[t][p] = BestPlace(p, t);
  }
  while (true) {
    // Rates weight / detour are compared by cross multiplication.
    double best_weight = 0.0;  // Largest rate so far, as a fraction.
    double best_detour = 1.0;
    std::size_t best_at = 0;
    int best_tour = -1;
    for (int t = 0; t < problem_.tours; ++t) {
      const double room = limit - now_.lengths[t];
      const std::vector<Place>& places = places_[t];
      for (std::size_t i = 0; i < open_.size(); ++i) {
        const Place& place = places[open_[i]];
        if (!(place.detour <= room)) continue;
        const double weight = weights_[open_[i]];
        const double detour = std::max(place.detour, 0.0) + grain;
        if (weight * best_detour > best_weight * detour) {
          best_weight = weight;
          best_detour = detour;
          best_at = i;
          best_tour = t;
        }
      }
    }
    if (best_tour < 0) break;
    const int point = open_[best_at];
    // Only places beside the insertion change: update instead of search.
    const int at = places_[best_tour][point].before;
    open_.erase(open_.begin() + best_at);
    Insert(point, best_tour);
    Measure(best_tour);
    for (int p : open_) Update(p, best_tour, at);
  }
}

}  // namespace kg_planner
