#include "kg_selector/team/team_rows.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "kg_base/geo/geodesy.h"

namespace kg_selector {
namespace {

// Covers the difference between geodesics (here) and the plane used for
// conflicts (conflict.h).
constexpr double kSafetyFactor = 0.999;
constexpr double kSamePosition_deg = 1e-9;

bool SamePosition(kg_base::LonLat a, kg_base::LonLat b) {
  return std::abs(a.lon_deg - b.lon_deg) <= kSamePosition_deg &&
         std::abs(a.lat_deg - b.lat_deg) <= kSamePosition_deg;
}

}  // namespace

TeamRows::TeamRows(const TeamRules& rules)
    : rules_(rules), separation_m_(kSafetyFactor * HardSeparation_m(rules)) {
  for (const auto& [event, capacity] : rules.event_capacity) {
    events_[event] = static_cast<int>(capacities_.size());
    capacities_.push_back(std::max(0, capacity));
  }
}

bool TeamRows::HoldsStation(const Pathlet& pathlet, const Visit& visit) const {
  const auto end = rules_.window_end_s.find(visit.window);
  if (end == rules_.window_end_s.end()) return false;
  // First track point at or after the window's end.
  const auto after =
      std::lower_bound(pathlet.track.begin(), pathlet.track.end(), end->second,
                       [](const kg_compiler::TimedPoint& point, double time_s) {
                         return point.time_s < time_s;
                       });
  if (after == pathlet.track.end()) return false;
  if (after->time_s > end->second && after == pathlet.track.begin()) {
    return false;
  }
  const bool before_there =
      after->time_s == end->second ||
      SamePosition(std::prev(after)->position, visit.position);
  return before_there && SamePosition(after->position, visit.position);
}

bool TeamRows::AreClose(int window, int a, int b) const {
  const std::vector<Place>& places = places_.at(window);
  return a == b || kg_base::Distance_m(places[a].position, places[b].position) <
                       separation_m_;
}

bool TeamRows::FitsInto(int place, const Clique& clique) const {
  return std::all_of(clique.places.begin(), clique.places.end(),
                     [&](int q) { return AreClose(clique.window, place, q); });
}

void TeamRows::AddToClique(int row, int place) {
  Clique& clique = cliques_.at(row);
  clique.places.push_back(place);
  places_.at(clique.window)[place].rows.push_back(row);
}

void TeamRows::JoinCliques(int window, int place) {
  for (const auto& [row, clique] : cliques_) {
    if (clique.window == window && FitsInto(place, clique)) {
      AddToClique(row, place);
    }
  }
}

// Adds a row for every close place (including itself) that shares none yet.
void TeamRows::AddMissingRows(int window, int place) {
  const int count = static_cast<int>(places_.at(window).size());
  for (int other = 0; other < count; ++other) {
    if (!AreClose(window, place, other)) continue;
    // Skip pairs that already share a row.
    const std::vector<int>& mine = places_.at(window)[place].rows;
    const std::vector<int>& its = places_.at(window)[other].rows;
    if (std::any_of(mine.begin(), mine.end(), [&](int row) {
          return std::count(its.begin(), its.end(), row) > 0;
        })) {
      continue;
    }
    // Grow a maximal clique around the pair greedily.
    const int row = static_cast<int>(capacities_.size());
    capacities_.push_back(1);
    cliques_[row] = {window, {}};
    AddToClique(row, place);
    if (other != place) AddToClique(row, other);
    for (int third = 0; third < count; ++third) {
      if (third != place && third != other &&
          FitsInto(third, cliques_.at(row))) {
        AddToClique(row, third);
      }
    }
  }
}

int TeamRows::AddPlace(int window, kg_base::LonLat position) {
  std::vector<Place>& places = places_[window];
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (SamePosition(places[i].position, position)) return static_cast<int>(i);
  }
  places.push_back({position, {}, {}});
  const int place = static_cast<int>(places.size()) - 1;
  JoinCliques(window, place);
  AddMissingRows(window, place);
  return place;
}

void TeamRows::Add(const Pathlet& pathlet) {
  for (const Visit& visit : pathlet.visits) {
    if (!HoldsStation(pathlet, visit)) continue;
    const int place = AddPlace(visit.window, visit.position);
    places_.at(visit.window)[place].waypoints.insert(
        {pathlet.agent, visit.waypoint});
  }
}

std::vector<int> TeamRows::UsedRows(const Pathlet& pathlet) const {
  std::set<int> rows;
  for (const Visit& visit : pathlet.visits) {
    for (const std::string& event : visit.events) {
      const auto row = events_.find(event);
      if (row != events_.end()) rows.insert(row->second);
    }
    const auto places = places_.find(visit.window);
    if (places == places_.end() || !HoldsStation(pathlet, visit)) continue;
    for (const Place& place : places->second) {
      if (SamePosition(place.position, visit.position)) {
        rows.insert(place.rows.begin(), place.rows.end());
        break;
      }
    }
  }
  return {rows.begin(), rows.end()};
}

void TeamRows::PutPrices(const std::string& agent,
                         const std::vector<double>& prices,
                         PlanRequest* request) const {
  // Rows added after the prices were computed have price 0.
  const auto price_of = [&](int row) {
    return row < static_cast<int>(prices.size()) ? prices[row] : 0.0;
  };
  for (const auto& [event, row] : events_) {
    if (price_of(row) > 0.0) request->event_prices[event] = price_of(row);
  }
  for (const auto& [window, places] : places_) {
    for (const Place& place : places) {
      double sum = 0.0;
      for (const int row : place.rows) sum += price_of(row);
      if (!(sum > 0.0)) continue;
      // Use the agent's own waypoint ids.
      for (const auto& [owner, waypoint] : place.waypoints) {
        if (owner == agent) {
          request->waypoint_prices.push_back({window, waypoint, sum});
        }
      }
    }
  }
}

}  // namespace kg_selector
