#include "kg_selector/team/screening.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kg_selector {
namespace {

using kg_compiler::TimedPoint;

bool IsFinite(kg_base::LonLat place) {
  return std::isfinite(place.lon_deg) && std::isfinite(place.lat_deg);
}

std::string MalformedVisits(const TeamRules& rules, const Pathlet& pathlet) {
  for (std::size_t i = 0; i < pathlet.visits.size(); ++i) {
    const Visit& visit = pathlet.visits[i];
    const std::string window = "window " + std::to_string(visit.window);
    if (i > 0 && visit.window <= pathlet.visits[i - 1].window) {
      return window + " does not ascend";
    }
    if (!rules.window_end_s.empty() &&
        rules.window_end_s.count(visit.window) == 0) {
      return window + " is not planned";
    }
    if (!IsFinite(visit.position)) return "the place of " + window;
  }
  return "";
}

std::string MalformedTrack(const std::vector<TimedPoint>& track) {
  for (std::size_t i = 0; i < track.size(); ++i) {
    const std::string point = "point " + std::to_string(i) + " of the track";
    if (!IsFinite(track[i].position) || !std::isfinite(track[i].time_s)) {
      return point + " is not finite";
    }
    if (i > 0 && track[i].time_s < track[i - 1].time_s) {
      return point + " is before the last";
    }
  }
  return "";
}

}  // namespace

std::string Malformed(const TeamRules& rules, const Pathlet& pathlet) {
  if (!std::isfinite(pathlet.reward) || !std::isfinite(pathlet.seam_cost) ||
      !std::isfinite(pathlet.energy_j)) {
    return "reward, cost or energy is not finite";
  }
  const std::string visits = MalformedVisits(rules, pathlet);
  return visits.empty() ? MalformedTrack(pathlet.track) : visits;
}

ScreenedOffer ScreenOffer(const TeamRules& rules, const std::string& agent,
                          std::vector<Pathlet> offered, int round) {
  ScreenedOffer screened;
  for (Pathlet& pathlet : offered) {
    pathlet.agent = agent;
    pathlet.round = round;
    // The rules cannot be evaluated on a malformed path.
    const std::string malformed = Malformed(rules, pathlet);
    const auto violation = malformed.empty() ? FindViolation(rules, pathlet)
                                             : std::optional<Conflict>();
    if (!malformed.empty()) {
      Conflict conflict;
      conflict.kind = ConflictKind::kMalformed;
      screened.rejected.push_back(
          {std::move(pathlet), conflict, "malformed: " + malformed, round});
    } else if (violation) {
      screened.rejected.push_back(
          {std::move(pathlet), *violation, violation->Line(), round});
    } else if (std::none_of(screened.sound.begin(), screened.sound.end(),
                            [&](const Pathlet& other) {
                              return IsSamePath(pathlet, other);
                            })) {
      screened.sound.push_back(std::move(pathlet));
    }
  }
  return screened;
}

}  // namespace kg_selector
