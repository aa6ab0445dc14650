#include "kg_core/mission/mission_reader.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "kg_core/base/date_time.h"
#include "kg_core/base/input_error.h"
#include "kg_core/base/units.h"
#include "kg_core/mission/choice.h"
#include "kg_core/mission/class_tree.h"
#include "kg_core/mission/entity.h"
#include "kg_core/mission/expiry.h"
#include "kg_core/mission/grid_check.h"
#include "kg_core/mission/literals.h"
#include "kg_core/mission/policy_reader.h"
#include "kg_core/mission/terms.h"
#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_core/rules/reasons.h"

namespace kg_core {
namespace {

constexpr Named<ConstraintKind> kConstraintKinds[] = {
    {"no_go", ConstraintKind::kNoGo}, {"soft", ConstraintKind::kSoft}};

class Reader {
 public:
  explicit Reader(const GraphView& view) : asserted_(view), view_(view) {}

  Mission Read() {
    const std::vector<Entity> missions = All("Mission");
    if (missions.size() != 1) {
      throw InputError("expected exactly one ex:Mission, not " +
                       std::to_string(missions.size()));
    }
    const Entity& mission = missions[0];
    mission_.iri = mission.iri();
    mission_.name = mission.Text(Ex("name"));
    mission_.coordination = ReadCoordination(mission);
    ReadWindows(mission);
    ReadAgents(mission);
    Collect("Constraint", mission_.constraints, &Reader::ReadConstraint);
    Collect("PriorLayer", mission_.priors, &Reader::ReadPrior);
    DropOutlived(mission_.constraints);
    DropOutlived(mission_.priors);
    Collect("Event", mission_.events, &Reader::ReadEvent);
    Collect("ValueLayer", mission_.value_layers, &Reader::ReadValueLayer);
    Collect("WorkField", mission_.work_fields, &Reader::ReadWorkField);
    DropUnplanned(mission_.value_layers);
    DropUnplanned(mission_.work_fields);
    for (const Entity& file : All("SourceFile")) {
      mission_.files[file.iri()] = ReadFile(file);
    }
    for (const Entity& grid : All("GridSpec")) CheckGrid(grid);
    return std::move(mission_);
  }

 private:
  // All instances in the facts, in the order of their IRIs.
  std::vector<Entity> All(const char* type) const {
    std::vector<Entity> entities;
    for (Term& term : InstancesOf(view_, kFactsGraph, Ex(type))) {
      entities.emplace_back(view_, std::move(term));
    }
    return entities;
  }

  template <typename Value>
  void Collect(const char* type, std::vector<Value>& values,
               Value (Reader::*read)(const Entity&) const) {
    for (const Entity& entity : All(type)) {
      values.push_back((this->*read)(entity));
    }
  }

  static CoordinationFacts ReadCoordination(const Entity& mission) {
    CoordinationFacts facts;
    facts.mode = mission.Text(Ex("teamMode"), facts.mode);
    facts.separation_m =
        KmToMetres(mission.Number(Ex("minimumSeparationKm"), 0.0));
    facts.separation_is_hard =
        mission.Flag(Ex("separationIsHard"), facts.separation_is_hard);
    facts.separation_weight =
        mission.Number(Ex("separationWeight"), facts.separation_weight);
    facts.candidates_per_agent =
        mission.Integer(Ex("candidatesPerAgent"), facts.candidates_per_agent);
    facts.waypoints_per_window =
        mission.Integer(Ex("waypointsPerWindow"), facts.waypoints_per_window);
    facts.waypoint_spacing_m =
        KmToMetres(mission.Number(Ex("waypointSpacingKm"), 0.0));
    facts.max_rounds =
        mission.Integer(Ex("maxCoolingRounds"), facts.max_rounds);
    return facts;
  }

  // Windows. Their ends: time:hasEnd, else the duration, else the next begin.

  void ReadWindows(const Entity& mission) {
    std::vector<Entity> windows;
    for (const Term& term : mission.All(Ex("hasWindow"))) {
      windows.emplace_back(view_, term);
      mission_.windows.push_back(ReadWindow(windows.back()));
    }
    std::sort(mission_.windows.begin(), mission_.windows.end(),
              [](const TimeWindow& a, const TimeWindow& b) {
                return a.index < b.index;
              });
    for (std::size_t i = 0; i < mission_.windows.size(); ++i) {
      CompleteWindow(static_cast<int>(i));
    }
    if (mission_.windows.empty()) {
      mission.Refuse(Ex("hasWindow"), "at least one window");
    }
    LimitHorizon(mission);
  }

  static TimeWindow ReadWindow(const Entity& entity) {
    TimeWindow window;
    window.iri = entity.iri();
    window.index = entity.Integer(Ex("index"));
    const auto begin_s = entity.MaybeTime_s(TimeTerm("hasBeginning"));
    if (!begin_s) entity.Refuse(TimeTerm("hasBeginning"), "an xsd:dateTime");
    window.begin_s = *begin_s;
    window.end_s = std::nan("");
    const auto hours = entity.MaybeNumber(Ex("durationHours"));
    if (hours) window.end_s = window.begin_s + HoursToSeconds(*hours);
    const auto end_s = entity.MaybeTime_s(TimeTerm("hasEnd"));
    if (end_s) window.end_s = *end_s;
    window.confidence = entity.Number(Ex("confidence"));
    return window;
  }

  void CompleteWindow(int i) {
    TimeWindow& window = mission_.windows[i];
    const Entity entity(view_, Iri(window.iri));
    if (window.index != i) {
      entity.Refuse(Ex("index"), std::to_string(i) +
                                     ": the windows' indices run from 0 " +
                                     "without gap or twin");
    }
    const bool is_last = i + 1 == static_cast<int>(mission_.windows.size());
    if (std::isnan(window.end_s) && !is_last) {
      window.end_s = mission_.windows[i + 1].begin_s;
    }
    if (!(window.end_s > window.begin_s)) {
      entity.Refuse(TimeTerm("hasEnd"),
                    "an end after the begin (time:hasEnd, ex:durationHours or "
                    "the next window's begin)");
    }
    if (!is_last && !(window.end_s <= mission_.windows[i + 1].begin_s)) {
      entity.Refuse(TimeTerm("hasEnd"),
                    "an end by the next window's begin, " +
                        FormatDateTime(mission_.windows[i + 1].begin_s));
    }
  }

  void LimitHorizon(const Entity& mission) {
    const int count = static_cast<int>(mission_.windows.size());
    const int horizon = mission.Integer(Ex("horizon"), count);
    if (!(horizon <= count)) {
      mission.Refuse(Ex("horizon"),
                     "at most the number of windows, " + std::to_string(count));
    }
    for (const TimeWindow& window : mission_.windows) {
      index_of_[window.iri] = window.index;
    }
    mission_.windows.resize(horizon);
  }

  // Of windows beyond the horizon nothing is kept.
  bool IsPlanned(int window) const {
    return window < static_cast<int>(mission_.windows.size());
  }

  template <typename Layer>
  void DropUnplanned(std::vector<Layer>& layers) const {
    layers.erase(std::remove_if(layers.begin(), layers.end(),
                                [&](const Layer& layer) {
                                  return !IsPlanned(layer.window);
                                }),
                 layers.end());
  }

  // The windows among `named` (empty: all) that begin while the facts about
  // `entity` hold; {kNoWindow} if there is none.
  std::vector<int> Alive(const Entity& entity, std::vector<int> named) const {
    const double end_s = ValidUntil_s(entity);
    if (std::isinf(end_s)) return named;
    std::vector<int> alive;
    for (const TimeWindow& window : mission_.windows) {
      const bool is_named =
          named.empty() ||
          std::count(named.begin(), named.end(), window.index) > 0;
      if (is_named && window.begin_s < end_s) alive.push_back(window.index);
    }
    return alive.empty() ? std::vector<int>{kNoWindow} : alive;
  }
  static constexpr int kNoWindow = -1;

  // What applies in no window: an empty list would mean all of them.
  template <typename Value>
  static void DropOutlived(std::vector<Value>& values) {
    const auto is_over = [](const Value& value) {
      return value.windows == std::vector<int>{kNoWindow};
    };
    values.erase(std::remove_if(values.begin(), values.end(), is_over),
                 values.end());
  }

  std::vector<int> WindowsOf(const Entity& entity, const Term& property) const {
    std::vector<int> windows;
    for (const std::string& iri : entity.Iris(property)) {
      const auto found = index_of_.find(iri);
      if (found == index_of_.end()) {
        entity.Refuse(property,
                      "a window of the mission, not " + ToTurtle(Iri(iri)));
      }
      windows.push_back(found->second);
    }
    std::sort(windows.begin(), windows.end());
    return windows;
  }

  int WindowOf(const Entity& entity) const {
    const std::vector<int> windows = WindowsOf(entity, Ex("forWindow"));
    if (windows.size() != 1) entity.Refuse(Ex("forWindow"), "one window");
    return windows[0];
  }

  // Agents.

  void ReadAgents(const Entity& mission) {
    for (const Term& term : mission.All(Ex("hasAgent"))) {
      mission_.agents.push_back(ReadAgent(Entity(view_, term)));
    }
    auto& agents = mission_.agents;
    if (agents.empty()) mission.Refuse(Ex("hasAgent"), "at least one agent");
    std::sort(agents.begin(), agents.end(),
              [](const Agent& a, const Agent& b) { return a.id < b.id; });
    const auto twin = std::adjacent_find(
        agents.begin(), agents.end(),
        [](const Agent& a, const Agent& b) { return a.id == b.id; });
    if (twin != agents.end()) {
      Entity(view_, Iri(twin->iri))
          .Refuse(Ex("id"), "an id of its own, not \"" + twin->id + "\" twice");
    }
  }

  Agent ReadAgent(const Entity& entity) const {
    Agent agent;
    agent.iri = entity.iri();
    agent.id = entity.Text(Ex("id"));
    agent.mobility = entity.Text(Ex("mobility"), "");
    agent.policy = ReadPolicy(view_, entity.Follow(Ex("usesPolicy")));
    agent.capabilities = ReadCapabilities(entity.Follow(Ex("hasCapabilities")));
    const Entity start = StartOf(entity);
    agent.start = start.Position();
    agent.start_heading_rad = DegToRad(start.Number(Ex("headingDeg"), 0.0));
    agent.start_iri = start.iri();
    for (const std::string& zone : entity.Iris(Ex("mustAvoid"))) {
      agent.must_avoid[zone] = SourcesOf(agent.iri, Ex("mustAvoid"), zone);
    }
    return agent;
  }

  // Where it is said: the subject if it is asserted, and the inferences.
  std::vector<std::string> SourcesOf(const std::string& subject,
                                     const Term& property,
                                     const std::string& object) const {
    const Triple triple = {Iri(subject), property, Iri(object)};
    std::vector<std::string> sources;
    if (Has(asserted_, kFactsGraph, triple.subject, property, triple.object)) {
      sources.push_back(subject);
    }
    for (Inference& inference : WhyInferred(asserted_, triple)) {
      sources.push_back(std::move(inference.iri));
    }
    return sources;
  }

  // The agent's state for the earliest window.
  Entity StartOf(const Entity& agent) const {
    std::vector<std::pair<int, Entity>> states;
    for (const Entity& state : All("AgentState")) {
      if (state.Iris(Ex("forAgent")) != std::vector<std::string>{agent.iri()}) {
        continue;
      }
      states.emplace_back(WindowOf(state), state);
    }
    const Term state = Ex("AgentState");
    if (states.empty()) {
      agent.Refuse(state, "an ex:AgentState with ex:forAgent " +
                              ToTurtle(agent.subject()) + " to start from");
    }
    std::stable_sort(
        states.begin(), states.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
    if (states.size() > 1 && states[0].first == states[1].first) {
      agent.Refuse(state, "one state for window " +
                              std::to_string(states[0].first) + ", not two");
    }
    return states[0].second;
  }

  // Constraints, priors, events.

  Constraint ReadConstraint(const Entity& entity) const {
    Constraint constraint;
    constraint.iri = entity.iri();
    constraint.kind =
        Choice(entity, Ex("kind"), kConstraintKinds, ConstraintKind::kNoGo);
    constraint.is_land = entity.One(Ex("gridRef")).has_value();
    if (!constraint.is_land) constraint.area = ReadArea(entity);
    constraint.buffer_cells = entity.Number(Ex("bufferCells"), 0.0);
    constraint.attenuation = entity.Number(Ex("attenuation"), 1.0);
    const bool is_cooling = entity.One(Ex("expires")).has_value();
    constraint.windows = Alive(
        entity, WindowsOf(entity, Ex(is_cooling ? "forWindow" : "appliesIn")));
    constraint.agents = entity.Iris(Ex(is_cooling ? "forAgent" : "appliesTo"));
    return constraint;
  }

  static Geometry ReadArea(const Entity& entity) {
    Geometry area = entity.Wkt();
    if (!area.IsArea()) {
      entity.Refuse(GeoTerm("asWKT"), "POLYGON or MULTIPOLYGON");
    }
    return area;
  }

  PriorLayer ReadPrior(const Entity& entity) const {
    return {entity.iri(),
            entity.Text(Ex("name")),
            ReadArea(entity),
            KmToMetres(entity.Number(Ex("edgeKm"), 0.0)),
            Alive(entity, WindowsOf(entity, Ex("appliesIn"))),
            entity.Iris(Ex("appliesTo"))};
  }

  Event ReadEvent(const Entity& entity) const {
    Event event;
    event.iri = entity.iri();
    event.position = entity.Position();
    event.value = entity.Number(Ex("value"));
    event.capacity = entity.Integer(Ex("capacity"), event.capacity);
    event.radius_m =
        KmToMetres(entity.Number(Ex("radiusKm"), kDefaultEventRadiusKm));
    event.windows = EventWindows(entity);
    if (!event.windows.empty()) {
      event.windows = Alive(entity, std::move(event.windows));
    }
    if (event.windows == std::vector<int>{kNoWindow}) event.windows.clear();
    return event;
  }
  static constexpr double kDefaultEventRadiusKm = 10.0;

  // A42: without an expiry its windows are those it names; with one, all from
  // the first it names that begin before the expiry.
  std::vector<int> EventWindows(const Entity& entity) const {
    const std::vector<int> named = WindowsOf(entity, Ex("forWindow"));
    if (named.empty()) entity.Refuse(Ex("forWindow"), "at least one window");
    std::vector<int> windows;
    if (!entity.One(Ex("expiresAfter"))) {
      std::copy_if(named.begin(), named.end(), std::back_inserter(windows),
                   [&](int window) { return IsPlanned(window); });
      return windows;
    }
    if (!IsPlanned(named.front())) return windows;
    const double expiry_s =
        Expiry_s(entity, mission_.windows[named.front()].begin_s);
    for (const TimeWindow& window : mission_.windows) {
      if (window.index >= named.front() && window.begin_s < expiry_s) {
        windows.push_back(window.index);
      }
    }
    return windows;
  }

  static double Expiry_s(const Entity& entity, double begin_s) {
    const std::optional<Term> expiry = entity.One(Ex("expiresAfter"));
    if (const auto time_s = UnixSeconds(*expiry)) return *time_s;
    if (const auto duration_s = DurationSeconds(*expiry)) {
      return begin_s + *duration_s;
    }
    entity.Refuse(Ex("expiresAfter"), "an xsd:dateTime or xsd:duration");
  }

  // Layers.

  ValueLayer ReadValueLayer(const Entity& entity) const {
    ValueLayer layer;
    layer.iri = entity.iri();
    layer.window = WindowOf(entity);
    layer.kind = entity.Text(Ex("kind"));
    layer.file_iri = entity.Follow(Prov("wasDerivedFrom")).iri();
    layer.time_index = entity.Integer(Ex("timeIndex"));
    layer.previous_time_index =
        entity.Integer(Ex("previousTimeIndex"), layer.time_index);
    return layer;
  }

  WorkFieldRef ReadWorkField(const Entity& entity) const {
    WorkFieldRef field;
    field.iri = entity.iri();
    field.window = WindowOf(entity);
    field.file_iri = entity.Follow(Prov("wasDerivedFrom")).iri();
    field.first_time_index = entity.Integer(Ex("firstTimeIndex"));
    field.last_time_index = entity.Integer(Ex("lastTimeIndex"));
    return field;
  }

  static SourceFile ReadFile(const Entity& entity) {
    return {entity.iri(), entity.Text(Ex("path")), entity.Text(Ex("sha256"))};
  }

  const GraphView& asserted_;       // As it is,
  const FactsAndConclusions view_;  // and as it is read.
  Mission mission_;
  std::map<std::string, int> index_of_;  // Of all windows, by IRI.
};

}  // namespace

Mission ReadMission(const GraphView& view) { return Reader(view).Read(); }

}  // namespace kg_core
