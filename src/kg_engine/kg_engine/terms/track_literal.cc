#include "kg_engine/terms/track_literal.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/common/text.h"
#include "kg_base/geo/geodesy.h"

namespace kg_engine {
namespace {

using kg_base::InputError;
using kg_compiler::TimedPoint;

constexpr double kWholeTurn_deg = 360.0;
constexpr double kHalfTurn_deg = 180.0;

// Shorter turn from a to b, in [-180, 180).
double Turn_deg(double from_deg, double to_deg) {
  const double turn_deg = to_deg - from_deg;
  return turn_deg - kWholeTurn_deg *
                        std::floor((turn_deg + kHalfTurn_deg) / kWholeTurn_deg);
}

bool PassesAntimeridian(const TimedPoint& a, const TimedPoint& b) {
  return std::abs(b.position.lon_deg - a.position.lon_deg) > kHalfTurn_deg;
}

TimedPoint At(const TimedPoint& a, const TimedPoint& b, double time_s) {
  const double span_s = b.time_s - a.time_s;
  TimedPoint point =
      span_s > 0.0 ? Between(a, b, (time_s - a.time_s) / span_s) : a;
  point.time_s = time_s;
  return point;
}

// Index and distance [m] of the point furthest from the linear motion from
// `first` to `last`, at its own time.
std::pair<std::size_t, double> Furthest(const Track& track, std::size_t first,
                                        std::size_t last) {
  std::size_t furthest = first;
  double distance_m = 0.0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const TimedPoint straight = At(track[first], track[last], track[i].time_s);
    const double off_m =
        kg_base::Distance_m(straight.position, track[i].position);
    if (!(off_m > distance_m)) continue;
    furthest = i;
    distance_m = off_m;
  }
  return {furthest, distance_m};
}

std::string Text(const char* format, double value) {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  std::string trimmed = text;
  if (trimmed.find('.') == std::string::npos) return trimmed;
  trimmed.erase(trimmed.find_last_not_of('0') + 1);
  if (trimmed.back() == '.') trimmed.pop_back();
  return trimmed == "-0" ? "0" : trimmed;
}

std::string Coordinates(const Track& part) {
  const auto to_text = [](const TimedPoint& point) {
    return Text("%.7f", point.position.lon_deg) + " " +
           Text("%.7f", point.position.lat_deg);
  };
  return "(" + kg_base::JoinStrings(part, ", ", to_text) + ")";
}

// Parses a number and advances; nullopt if there is none.
std::optional<double> TakeNumber(const char** at) {
  char* end = nullptr;
  const double value = std::strtod(*at, &end);
  if (end == *at || !std::isfinite(value)) return std::nullopt;
  *at = end;
  return value;
}

void Skip(const char** at, const char* what) {
  while (**at != '\0' && std::string(what).find(**at) != std::string::npos) {
    ++*at;
  }
}

// Positions of our own LINESTRING or MULTILINESTRING.
std::vector<Track> ReadPositions(const std::string& wkt) {
  const bool many = wkt.rfind("MULTILINESTRING(", 0) == 0;
  if (!many && wkt.rfind("LINESTRING(", 0) != 0) {
    throw InputError("ex:pathWKT: expected a LINESTRING, not " +
                     std::string(kg_base::FirstCharacters(wkt, 40)));
  }
  std::vector<Track> parts(1);
  const char* at = wkt.c_str() + wkt.find('(');
  while (true) {
    Skip(&at, "( ");
    const auto lon = TakeNumber(&at);
    const auto lat = lon ? TakeNumber(&at) : std::nullopt;
    if (!lat) throw InputError("ex:pathWKT: expected two numbers at " + wkt);
    parts.back().push_back({{*lon, *lat}, 0.0});
    const bool part_ends = *at == ')';
    Skip(&at, ") ");
    if (*at == '\0') return parts;
    Skip(&at, ",");
    if (part_ends) parts.emplace_back();
  }
}

}  // namespace

TimedPoint Between(const TimedPoint& a, const TimedPoint& b,
                   const double share) {
  const double turn_deg = Turn_deg(a.position.lon_deg, b.position.lon_deg);
  double lon_deg = a.position.lon_deg + share * turn_deg;
  if (lon_deg >= kHalfTurn_deg) lon_deg -= kWholeTurn_deg;
  if (lon_deg < -kHalfTurn_deg) lon_deg += kWholeTurn_deg;
  return {{lon_deg, a.position.lat_deg +
                        share * (b.position.lat_deg - a.position.lat_deg)},
          a.time_s + share * (b.time_s - a.time_s)};
}

Track CutTrack(const Track& track, const double from_s, const double to_s) {
  Track cut;
  for (std::size_t i = 0; i < track.size(); ++i) {
    const TimedPoint& point = track[i];
    if (i > 0) {
      const TimedPoint& last = track[i - 1];
      if (last.time_s < from_s && from_s < point.time_s) {
        cut.push_back(At(last, point, from_s));
      }
      if (last.time_s < to_s && to_s < point.time_s) {
        cut.push_back(At(last, point, to_s));
      }
    }
    if (from_s <= point.time_s && point.time_s <= to_s) cut.push_back(point);
  }
  return cut;
}

Track SimplifyTrack(const Track& track, const double tolerance_m) {
  if (track.size() < 3) return track;
  std::vector<bool> kept(track.size(), false);
  kept.front() = kept.back() = true;
  // Douglas-Peucker in space and time: split each span at the furthest point
  // until all points are within tolerance.
  std::vector<std::pair<std::size_t, std::size_t>> open = {
      {0, track.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    const auto [furthest, off_m] = Furthest(track, first, last);
    if (off_m <= tolerance_m) continue;
    kept[furthest] = true;
    open.push_back({first, furthest});
    open.push_back({furthest, last});
  }
  Track simple;
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (kept[i]) simple.push_back(track[i]);
  }
  return simple;
}

std::vector<Track> CutAtAntimeridian(const Track& track) {
  std::vector<Track> parts(1);
  for (std::size_t i = 0; i < track.size(); ++i) {
    if (i > 0 && PassesAntimeridian(track[i - 1], track[i])) {
      // Interpolate the crossing; it ends one part at +-180 and starts the next
      // at -+180 degrees.
      const TimedPoint& a = track[i - 1];
      const double turn_deg =
          Turn_deg(a.position.lon_deg, track[i].position.lon_deg);
      const double edge_deg = turn_deg > 0.0 ? kHalfTurn_deg : -kHalfTurn_deg;
      TimedPoint cut =
          Between(a, track[i], (edge_deg - a.position.lon_deg) / turn_deg);
      cut.position.lon_deg = edge_deg;
      parts.back().push_back(cut);
      cut.position.lon_deg = -edge_deg;
      parts.push_back({cut});
    }
    parts.back().push_back(track[i]);
  }
  const auto is_nothing = [](const Track& part) {
    return part.empty() || part.front().time_s == part.back().time_s;
  };
  if (parts.size() > 1) {
    parts.erase(std::remove_if(parts.begin(), parts.end(), is_nothing),
                parts.end());
  }
  return parts;
}

TrackLiteral ToLiteral(const std::vector<Track>& parts) {
  TrackLiteral literal;
  for (const Track& part : parts) {
    if (part.empty()) continue;
    literal.wkt += (literal.wkt.empty() ? "" : ", ") + Coordinates(part);
    for (const TimedPoint& point : part) {
      if (!literal.times.empty()) literal.times += " ";
      literal.times += Text("%.1f", point.time_s);
    }
  }
  if (literal.wkt.empty()) return literal;
  literal.wkt = parts.size() > 1 ? "MULTILINESTRING(" + literal.wkt + ")"
                                 : "LINESTRING" + literal.wkt;
  return literal;
}

std::vector<Track> FromLiteral(const TrackLiteral& literal) {
  std::vector<Track> parts = ReadPositions(literal.wkt);
  const char* at = literal.times.c_str();
  // The times run on across parts, one per point.
  double last_s = -INFINITY;
  for (Track& part : parts) {
    for (TimedPoint& point : part) {
      const auto time_s = TakeNumber(&at);
      if (!time_s || !(*time_s >= last_s)) {
        throw InputError(
            "ex:pathTimes: expected one time for each point of ex:pathWKT, "
            "ascending");
      }
      point.time_s = last_s = *time_s;
    }
  }
  Skip(&at, " ");
  if (*at != '\0') {
    throw InputError("ex:pathTimes: has more times than ex:pathWKT points");
  }
  return parts;
}

}  // namespace kg_engine
