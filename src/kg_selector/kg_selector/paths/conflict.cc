#include "kg_selector/paths/conflict.h"

#include <algorithm>
#include <limits>
#include <sstream>

namespace kg_selector {
namespace {

using kg_compiler::TimedPoint;

constexpr double kAlways = std::numeric_limits<double>::infinity();

// Agents rewarded by each event, in order of commitment.
using Rewarded = std::map<std::string, std::vector<std::string>>;

Rewarded RewardedBy(const std::vector<Pathlet>& committed) {
  Rewarded rewarded;
  for (const Pathlet& pathlet : committed) {
    for (const Visit& visit : pathlet.visits) {
      for (const std::string& event : visit.events) {
        std::vector<std::string>& agents = rewarded[event];
        if (std::count(agents.begin(), agents.end(), pathlet.agent) == 0) {
          agents.push_back(pathlet.agent);
        }
      }
    }
  }
  return rewarded;
}

struct WindowSpan {
  int window = -1;
  bool is_first = false;
  TimeSpan span;
};

// One span per window; a single span of unknown window if window ends are
// unknown.
std::vector<WindowSpan> WindowSpans(const TeamRules& rules,
                                    const Pathlet& pathlet) {
  std::vector<WindowSpan> spans;
  double from_s = -kAlways;
  for (const Visit& visit : pathlet.visits) {
    const auto end = rules.window_end_s.find(visit.window);
    if (end == rules.window_end_s.end()) return {{-1, true, TimeSpan()}};
    spans.push_back({visit.window, spans.empty(), {from_s, end->second}});
    from_s = end->second;
  }
  if (spans.empty()) return {{-1, true, TimeSpan()}};
  spans.back().span.to_s = kAlways;
  return spans;
}

std::optional<Conflict> SeparationConflict(
    const TeamRules& rules, const std::vector<Pathlet>& committed,
    const Pathlet& pathlet, const WindowSpan& window) {
  const int first_window =
      pathlet.visits.empty() ? -1 : pathlet.visits.front().window;
  const double separation_m = HardSeparation_m(rules);
  std::optional<Conflict> worst;
  for (const Pathlet& other : committed) {
    // In the first window agents may start too close together (launched from
    // one ship): the rule applies from when they are apart.
    TimeSpan span = window.span;
    if (window.is_first) {
      span.from_s = std::max(
          span.from_s,
          SeparationBegins_s(rules, first_window, pathlet.track, other.track));
    }
    if (!ComeCloserThan(pathlet.track, other.track, separation_m, span)) {
      continue;
    }
    // Report the agent it comes closest to.
    const double missing_m =
        separation_m -
        ClosestApproach(pathlet.track, other.track, span)->distance_m;
    if (worst && missing_m <= worst->margin) continue;
    worst = Conflict{ConflictKind::kSeparation, other.agent, window.window, "",
                     missing_m};
  }
  return worst;
}

std::optional<Conflict> CapacityConflict(const TeamRules& rules,
                                         const Rewarded& rewarded,
                                         const std::string& agent,
                                         const Visit& visit) {
  for (const std::string& event : visit.events) {
    const auto capacity = rules.event_capacity.find(event);
    if (capacity == rules.event_capacity.end()) continue;
    const auto place = rewarded.find(event);
    const std::vector<std::string> agents =
        place == rewarded.end() ? std::vector<std::string>() : place->second;
    if (std::count(agents.begin(), agents.end(), agent) > 0) continue;
    // Capacity left including this agent.
    const int left = capacity->second - static_cast<int>(agents.size()) - 1;
    if (left < 0) {
      return Conflict{ConflictKind::kCapacity,
                      agents.empty() ? "" : agents.back(), visit.window, event,
                      static_cast<double>(left)};
    }
  }
  return std::nullopt;
}

// margin = number of windows after the event's last one, or before its first
// (negative).
std::optional<Conflict> ExpiredConflict(const TeamRules& rules, int window,
                                        const std::string& event) {
  const auto open = rules.event_windows.find(event);
  if (open == rules.event_windows.end() || open->second.count(window) > 0) {
    return std::nullopt;
  }
  Conflict conflict{ConflictKind::kExpired, "", window, event, 0.0};
  if (open->second.empty()) return conflict;
  const int past = window - *open->second.rbegin();
  const int early = window - *open->second.begin();
  conflict.margin = past > 0 ? past : std::min(early, 0);
  return conflict;
}

}  // namespace

const char* Name(ConflictKind kind) {
  switch (kind) {
    case ConflictKind::kSeparation:
      return "separation";
    case ConflictKind::kCapacity:
      return "capacity";
    case ConflictKind::kEnergy:
      return "energy";
    case ConflictKind::kExpired:
      return "expired";
    case ConflictKind::kOutbid:
      return "outbid";
    case ConflictKind::kMalformed:
      return "malformed";
  }
  return "";
}

std::optional<ConflictKind> ParseConflictKind(const std::string& name) {
  for (const ConflictKind kind :
       {ConflictKind::kSeparation, ConflictKind::kCapacity,
        ConflictKind::kEnergy, ConflictKind::kExpired, ConflictKind::kOutbid,
        ConflictKind::kMalformed}) {
    if (name == Name(kind)) return kind;
  }
  return std::nullopt;
}

std::string Conflict::Line() const {
  std::ostringstream line;
  switch (kind) {
    case ConflictKind::kSeparation:
      line << margin << " m too close to " << with_agent;
      break;
    case ConflictKind::kCapacity:
      line << event << " is at capacity"
           << (with_agent.empty() ? "" : " after " + with_agent);
      break;
    case ConflictKind::kEnergy:
      line << margin << " J above the energy budget";
      break;
    case ConflictKind::kExpired:
      line << event << " has expired";
      break;
    case ConflictKind::kOutbid:
      line << "outbid by " << (with_agent.empty() ? "the others" : with_agent)
           << ", " << margin << " short";
      break;
    case ConflictKind::kMalformed:
      line << "malformed";
      break;
  }
  if (window >= 0) line << ", window " << window;
  return line.str();
}

double HardSeparation_m(const TeamRules& rules) {
  if (!rules.separation_is_hard) return kSamePlace_m;
  return std::max(kSamePlace_m, rules.separation_m);
}

double SeparationBegins_s(const TeamRules& rules, int first_window,
                          const std::vector<TimedPoint>& a,
                          const std::vector<TimedPoint>& b) {
  const auto end = rules.window_end_s.find(first_window);
  if (end == rules.window_end_s.end() || a.empty() || b.empty()) {
    return -kAlways;
  }
  const double begin_s = std::max(a.front().time_s, b.front().time_s);
  if (!(begin_s < end->second)) return -kAlways;
  return FirstTimeApart(a, b, HardSeparation_m(rules), {begin_s, end->second})
      .value_or(end->second);
}

std::optional<Conflict> FindViolation(const TeamRules& rules,
                                      const Pathlet& pathlet) {
  const auto budget_j = rules.energy_budget_j.find(pathlet.agent);
  if (budget_j != rules.energy_budget_j.end() &&
      !(pathlet.energy_j <= budget_j->second)) {
    return Conflict{ConflictKind::kEnergy, "", -1, "",
                    pathlet.energy_j - budget_j->second};
  }
  for (const Visit& visit : pathlet.visits) {
    for (const std::string& event : visit.events) {
      if (const auto expired = ExpiredConflict(rules, visit.window, event)) {
        return expired;
      }
    }
  }
  return std::nullopt;
}

std::set<std::string> FullEvents(const TeamRules& rules,
                                 const std::vector<Pathlet>& committed) {
  const Rewarded rewarded = RewardedBy(committed);
  std::set<std::string> full;
  for (const auto& [event, capacity] : rules.event_capacity) {
    const auto agents = rewarded.find(event);
    const std::size_t taken =
        agents == rewarded.end() ? 0 : agents->second.size();
    if (static_cast<int>(taken) >= capacity) full.insert(event);
  }
  return full;
}

double SoftPenalty(const TeamRules& rules,
                   const std::vector<Pathlet>& committed,
                   const Pathlet& pathlet) {
  if (rules.separation_is_hard) return 0.0;
  double missing_m = 0.0;
  for (const Pathlet& other : committed) {
    const auto approach = ClosestApproach(pathlet.track, other.track);
    if (approach) {
      missing_m += std::max(0.0, rules.separation_m - approach->distance_m);
    }
  }
  return rules.separation_weight_per_m * missing_m;
}

std::optional<Conflict> FindConflict(const TeamRules& rules,
                                     const std::vector<Pathlet>& committed,
                                     const Pathlet& pathlet) {
  const Rewarded rewarded = RewardedBy(committed);
  for (const WindowSpan& window : WindowSpans(rules, pathlet)) {
    auto conflict = SeparationConflict(rules, committed, pathlet, window);
    if (conflict) return conflict;
    for (const Visit& visit : pathlet.visits) {
      if (window.window >= 0 && visit.window != window.window) continue;
      conflict = CapacityConflict(rules, rewarded, pathlet.agent, visit);
      if (conflict) return conflict;
    }
  }
  return std::nullopt;
}

}  // namespace kg_selector
