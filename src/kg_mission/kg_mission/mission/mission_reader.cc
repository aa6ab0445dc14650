#include "kg_mission/mission/mission_reader.h"

#include <algorithm>
#include <string>
#include <vector>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_core/facts/class_tree.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rules/facts_and_conclusions.h"
#include "kg_mission/mission/agent_reader.h"
#include "kg_mission/mission/area_reader.h"
#include "kg_mission/mission/calendar.h"
#include "kg_mission/mission/choice.h"
#include "kg_mission/mission/entity.h"
#include "kg_mission/mission/grid_check.h"
#include "kg_mission/mission/layer_reader.h"
#include "kg_mission/mission/option_names.h"

namespace kg_mission {
namespace {

using kg_core::Ex;
using kg_core::GraphView;

// All instances of a class in the facts, sorted by IRI.
std::vector<FactEntity> All(const GraphView& view, const char* type) {
  std::vector<FactEntity> entities;
  for (kg_core::Term& term :
       kg_core::FindInstances(view, kg_core::kFactsGraph, Ex(type))) {
    entities.emplace_back(view, std::move(term));
  }
  return entities;
}

FactEntity TheMission(const GraphView& view) {
  const std::vector<FactEntity> missions = All(view, "Mission");
  if (missions.size() != 1) {
    throw kg_base::InputError("expected exactly one ex:Mission, not " +
                              std::to_string(missions.size()));
  }
  return missions[0];
}

// Reads the options for team selection.
void ReadChoice(const FactEntity& mission, CoordinationFacts* facts) {
  facts->mode = NameChoice(mission, Ex("teamMode"), kTeamModeNames);
  facts->gap_goal = mission.Number(Ex("gapGoal"), facts->gap_goal);
  facts->auction_epsilon =
      mission.Number(Ex("auctionEpsilon"), facts->auction_epsilon);
  facts->select_limit_s =
      mission.Number(Ex("selectTimeLimitS"), facts->select_limit_s);
  facts->fairness = NameChoice(mission, Ex("fairness"), kFairnessNames);
  facts->fairness_weight =
      mission.Number(Ex("fairnessWeight"), facts->fairness_weight);
}

CoordinationFacts ReadCoordination(const FactEntity& mission) {
  CoordinationFacts facts;
  // Convert lengths from km to m; absent properties keep the defaults.
  ReadChoice(mission, &facts);
  facts.separation_m =
      kg_base::KmToMetres(mission.Number(Ex("minimumSeparationKm"), 0.0));
  facts.separation_is_hard =
      mission.Flag(Ex("separationIsHard"), facts.separation_is_hard);
  facts.separation_weight =
      mission.Number(Ex("separationWeight"), facts.separation_weight);
  facts.candidates_per_agent =
      mission.Integer(Ex("candidatesPerAgent"), facts.candidates_per_agent);
  facts.waypoints_per_window =
      mission.Integer(Ex("waypointsPerWindow"), facts.waypoints_per_window);
  facts.waypoint_spacing_m =
      kg_base::KmToMetres(mission.Number(Ex("waypointSpacingKm"), 0.0));
  facts.max_rounds = mission.Integer(Ex("maxCoolingRounds"), facts.max_rounds);
  facts.movement_mode =
      NameChoice(mission, Ex("movementMode"), kMovementModeNames);
  return facts;
}

// Reads all entities of one class, sorted by IRI.
template <typename Value>
std::vector<Value> ReadAll(const GraphView& view,
                           const WindowCalendar& calendar, const char* type,
                           Value (*read)(const WindowCalendar&,
                                         const FactEntity&)) {
  std::vector<Value> values;
  for (const FactEntity& entity : All(view, type)) {
    values.push_back(read(calendar, entity));
  }
  return values;
}

// Removes entities that apply in no window, since an empty list would mean all
// windows.
template <typename Value>
void DropOutlived(std::vector<Value>* values) {
  const auto is_over = [](const Value& value) {
    return value.windows == std::vector<int>{WindowCalendar::kNoWindow};
  };
  values->erase(std::remove_if(values->begin(), values->end(), is_over),
                values->end());
}

template <typename Layer>
void DropUnplanned(const WindowCalendar& calendar, std::vector<Layer>* layers) {
  const auto is_unplanned = [&](const Layer& layer) {
    return !calendar.IsPlanned(layer.window);
  };
  layers->erase(std::remove_if(layers->begin(), layers->end(), is_unplanned),
                layers->end());
}

}  // namespace

Mission ReadMission(const GraphView& asserted) {
  const kg_core::FactsAndConclusions view(asserted);
  const FactEntity entity = TheMission(view);
  Mission mission;
  mission.iri = entity.iri();
  mission.name = entity.Text(Ex("name"));
  mission.coordination = ReadCoordination(entity);
  const WindowCalendar calendar(view, entity);
  mission.windows = calendar.planned();
  mission.agents = ReadAgents(asserted, view, calendar, entity);
  mission.constraints = ReadAll(view, calendar, "Constraint", ReadConstraint);
  mission.priors = ReadAll(view, calendar, "PriorLayer", ReadPrior);
  // Entities that apply in no planned window have no effect.
  DropOutlived(&mission.constraints);
  DropOutlived(&mission.priors);
  mission.events = ReadAll(view, calendar, "Event", ReadEvent);
  mission.value_layers = ReadAll(view, calendar, "ValueLayer", ReadValueLayer);
  mission.work_fields = ReadAll(view, calendar, "WorkField", ReadWorkField);
  mission.cost_fields = ReadAll(view, calendar, "CostField", ReadCostField);
  DropUnplanned(calendar, &mission.value_layers);
  DropUnplanned(calendar, &mission.work_fields);
  DropUnplanned(calendar, &mission.cost_fields);
  for (const FactEntity& file : All(view, "SourceFile")) {
    mission.files[file.iri()] = ReadSourceFile(file);
  }
  for (const FactEntity& grid : All(view, "GridSpec")) CheckGrid(grid);
  return mission;
}

}  // namespace kg_mission
