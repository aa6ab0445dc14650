#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/join_strings.h"
#include "kg_base/common/units.h"
#include "kg_core/facts/literals.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_selector/explain/explain_via.h"
#include "kg_selector/explain/why_not.h"
#include "kg_selector/explain/why_not_place.h"

namespace kg_selector {
namespace {

using kg_base::InputError;
using kg_compiler::Explanation;
using kg_compiler::Facts;
using kg_compiler::Short;
using kg_compiler::Waypoint;
using kg_core::AbbreviateIri;
using kg_mission::Agent;
using kg_mission::Event;

std::string EventWindowName(int window) {
  return "window " + std::to_string(window);
}

std::string Hours(double seconds) {
  return Short(seconds / kg_base::kSecondsPerHour) + " h";
}

class EventQuestion {
 public:
  EventQuestion(const PlannedWorld& world, const Agent& agent,
                const Event& event)
      : world_(world),
        agent_(agent),
        event_(event),
        name_(AbbreviateIri(event.iri)),
        member_(FindMember(world, agent)),
        facts_(world.facts()) {}

  Explanation Explain(int window) const {
    for (const Visit& visit : NeedPath(world_, agent_).visits) {
      if (Names(visit.events)) {
        return ExplainTaken(world_, agent_, visit, name_);
      }
    }
    if (HasVisited()) return Visited();
    if (window >= 0) {
      const std::size_t stage = FindStage(member_, window);
      if (!IsActive(window)) return NotActive(window);
      return IsFull() ? Full() : InStage(stage);
    }
    return InAnyWindow();
  }

 private:
  bool Names(const std::vector<std::string>& events) const {
    return std::count(events.begin(), events.end(), event_.iri) > 0;
  }
  bool IsActive(int window) const {
    return std::count(event_.windows.begin(), event_.windows.end(), window) > 0;
  }
  std::vector<std::string> PastVisitors() const {
    const auto past = world_.past_visits.find(event_.iri);
    return past == world_.past_visits.end() ? std::vector<std::string>()
                                            : past->second;
  }
  bool HasVisited() const {
    const auto past = PastVisitors();
    return std::count(past.begin(), past.end(), agent_.iri) > 0;
  }

  Explanation Named(const char* verdict, const char* unit,
                    const std::string& why) const {
    Explanation explanation;
    explanation.verdict = verdict;
    explanation.unit = unit;
    explanation.text = agent_.id + " does not go to " + name_ + ": " + why;
    return explanation;
  }

  Explanation Visited() const {
    Explanation explanation =
        Named("visited", "1", "it has been there, and is rewarded once.");
    explanation.parts = {{0.0, "visit", facts_.Event(event_.iri),
                          "the visit in a window that is over"}};
    return explanation;
  }

  // Agents that count against the capacity: past visitors, then agents
  // committed earlier.
  struct Holder {
    std::string agent;
    Facts facts;
    std::string when;
  };
  std::vector<Holder> Holders() const {
    std::vector<Holder> holders;
    for (const std::string& agent : PastVisitors()) {
      holders.push_back({agent, facts_.Quote({agent, {"ex:id"}}),
                         "in a window that is over"});
    }
    for (const Pathlet& other : CommittedBefore(world_, agent_.iri)) {
      for (const Visit& visit : other.visits) {
        if (Names(visit.events)) holders.push_back(ToHolder(other, visit));
      }
    }
    return holders;
  }
  Holder ToHolder(const Pathlet& other, const Visit& visit) const {
    const std::string assignment = world_.run_iri + "/" +
                                   FindAgent(world_, other.agent).id + "/w" +
                                   std::to_string(visit.window);
    Facts facts = world_.run_iri.empty()
                      ? Facts()
                      : facts_.QuoteTriple(assignment, "ex:visits", event_.iri);
    if (facts.empty()) facts = facts_.Quote({other.agent, {"ex:id"}});
    return {other.agent, std::move(facts),
            "in " + EventWindowName(visit.window)};
  }

  bool IsFull() const {
    return static_cast<int>(Holders().size()) >= event_.capacity;
  }
  Explanation Full() const {
    Explanation explanation = Named("capacity", "agents", "");
    const Facts facts = facts_.Event(event_.iri);
    explanation.parts = {{static_cast<double>(event_.capacity), "capacity",
                          facts, name_ + " rewards that many agents"}};
    std::vector<std::string> names;
    for (const Holder& holder : Holders()) {
      const std::string name = AbbreviateIri(holder.agent);
      explanation.parts.push_back(
          {-1.0, "- " + name, holder.facts, name + " has it, " + holder.when});
      names.push_back(name + " " + holder.when);
    }
    // Including the agent itself the capacity is exceeded: the margin is
    // negative.
    explanation.parts.push_back({-1.0, "- itself",
                                 facts_.Quote({agent_.iri, {"ex:id"}}),
                                 agent_.id + " would be one more"});
    explanation.value = explanation.Sum();
    explanation.text += "it rewards " + std::to_string(event_.capacity) +
                        " and is used up by " + kg_base::JoinStrings(names) +
                        ".";
    return explanation;
  }

  // Time ----------------------------------------------------------------------

  const kg_mission::TimeWindow& Window(int index) const {
    return world_.compilation->mission.windows.at(index);
  }
  // The stated expiry, else the end of its last window.
  double Expiry_s() const {
    const auto stated = kg_core::FirstObject(
        *world_.view, kg_core::kFactsGraph, kg_core::Iri(event_.iri),
        kg_core::Iri(std::string(kg_core::kEx) + "expiresAfter"));
    if (stated) {
      if (const auto time_s = kg_core::UnixSeconds(*stated)) return *time_s;
      const auto duration_s = kg_core::DurationSeconds(*stated);
      if (duration_s) {
        return Window(event_.windows.front()).begin_s + *duration_s;
      }
    }
    return Window(event_.windows.back()).end_s;
  }

  // Times are relative to the mission's begin.
  Explanation NotActive(int window) const {
    const double begin_s = Window(window).begin_s;
    const double zero_s = world_.compilation->mission.windows.front().begin_s;
    const Facts facts = facts_.Event(event_.iri);
    const Facts when =
        facts_.Window(Window(window), {"ex:index", "time:hasBeginning"});
    if (event_.windows.empty()) return NoWindow();
    // Before the first window of the event, or after its expiry.
    const bool is_early = window < event_.windows.front();
    const double edge_s =
        is_early ? Window(event_.windows.front()).begin_s : Expiry_s();
    const double sign = is_early ? -1.0 : 1.0;
    Explanation explanation =
        Named(is_early ? "not_active" : "expired", "s",
              EventWindowName(window) + " begins " +
                  Hours(sign * (begin_s - edge_s)) +
                  (is_early ? " before it does." : " after it has expired."));
    explanation.value = sign * (begin_s - edge_s);
    explanation.parts = {
        {sign * (begin_s - zero_s), "begin of the window", when,
         EventWindowName(window) + " begins " + Hours(begin_s - zero_s) +
             " into the mission"},
        {-sign * (edge_s - zero_s),
         is_early ? "- begin of the event" : "- expiry", facts,
         name_ + (is_early ? " begins " : " expires ") +
             Hours(edge_s - zero_s) + " into the mission"}};
    return explanation;
  }

  Explanation NoWindow() const {
    Explanation explanation =
        Named("not_active", "1", "it is in none of the mission's windows.");
    explanation.parts = {
        {0.0, "windows", facts_.Event(event_.iri), "the windows it names"}};
    return explanation;
  }

  // Paths ---------------------------------------------------------------------

  Explanation InStage(std::size_t stage) const {
    ViaWaypoints by;
    by.stage = stage;
    by.name = name_ + " in " + EventWindowName(member_.graphs[stage].window);
    for (const Waypoint& waypoint : member_.graphs[stage].waypoints) {
      if (Names(waypoint.events)) by.waypoints.insert(waypoint.id);
    }
    return by.waypoints.empty()
               ? NoWaypointThere(world_, agent_, event_.position, stage)
               : ExplainPathVia(world_, agent_, by);
  }

  // The smallest shortfall, if a path is possible in any window.
  Explanation InAnyWindow() const {
    std::vector<Explanation> all;
    for (std::size_t s = 0; s < member_.graphs.size(); ++s) {
      if (IsActive(member_.graphs[s].window)) {
        if (IsFull()) return Full();
        all.push_back(InStage(s));
      }
    }
    // The event is in no planned window: before or after them.
    if (all.empty()) {
      return event_.windows.empty()
                 ? NoWindow()
                 : NotActive(event_.windows.back() <
                                     member_.graphs.front().window
                                 ? member_.graphs.front().window
                                 : member_.graphs.back().window);
    }
    const auto key = [](const Explanation& e) {
      return std::make_pair(e.verdict != "worth_less", e.value);
    };
    return *std::min_element(all.begin(), all.end(),
                             [&](const Explanation& a, const Explanation& b) {
                               return key(a) < key(b);
                             });
  }

  const PlannedWorld& world_;
  const Agent& agent_;
  const Event& event_;
  std::string name_;
  const TeamMember& member_;
  kg_compiler::CitedFacts facts_;
};

}  // namespace

const Event* FindEvent(const PlannedWorld& world, const std::string& name) {
  for (const Event& event : world.compilation->mission.events) {
    if (event.iri == name || AbbreviateIri(event.iri) == name) return &event;
  }
  return nullptr;
}

Explanation WhyNotEvent(const PlannedWorld& world, const Agent& agent,
                        const std::string& name, int window) {
  const Event* event = FindEvent(world, name);
  if (event != nullptr) {
    return EventQuestion(world, agent, *event).Explain(window);
  }
  const std::string known = kg_base::JoinStrings(
      world.compilation->mission.events, ", ",
      [](const Event& one) { return AbbreviateIri(one.iri); });
  throw InputError("event '" + name + "' is not known; there are " +
                   (known.empty() ? "none" : known));
}

}  // namespace kg_selector
