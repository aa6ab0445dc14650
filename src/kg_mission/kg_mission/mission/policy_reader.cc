#include "kg_mission/mission/policy_reader.h"

#include <map>
#include <string>

#include "kg_base/common/units.h"
#include "kg_core/facts/terms.h"
#include "kg_mission/mission/choice.h"
#include "kg_mission/mission/source_quantities.h"

namespace kg_mission {
namespace {

using kg_base::KmToMetres;
using kg_core::Ex;

constexpr NamedChoice<Normalisation> kNormalisations[] = {
    {"max", Normalisation::kMax},
    {"minmax", Normalisation::kMinMax},
    {"percentile", Normalisation::kPercentile}};
constexpr NamedChoice<ConfidenceMode> kConfidenceModes[] = {
    {"post", ConfidenceMode::kPost},
    {"pre", ConfidenceMode::kPre},
    {"horizon", ConfidenceMode::kHorizon}};
constexpr NamedChoice<FrontOperator> kFrontOperators[] = {
    {"sobel", FrontOperator::kSobel}, {"central", FrontOperator::kCentral}};
constexpr NamedChoice<LayerScale> kLayerScales[] = {
    {"window", LayerScale::kWindow},
    {"fixed", LayerScale::kFixed},
    {"none", LayerScale::kNone}};
constexpr NamedChoice<bool> kPathChoices[] = {{"best", false},
                                              {"diverse", true}};
constexpr NamedChoice<SoftOverlap> kSoftOverlaps[] = {
    {"product", SoftOverlap::kProduct}, {"min", SoftOverlap::kMin}};

std::string LocalName(const std::string& iri) {
  return iri.substr(iri.find_last_of("/#") + 1);
}

struct WeightNames {
  const char* link;
  const char* target;
  const char* value;
};
std::map<std::string, double> Weights(
    const kg_core::GraphView& view, const FactEntity& policy,
    const WeightNames& names, std::map<std::string, std::string>* iris) {
  std::map<std::string, double> weights;
  for (const kg_core::Term& term : policy.All(Ex(names.link))) {
    const FactEntity node(view, term);
    const std::string target = node.Follow(Ex(names.target)).iri();
    (*iris)[target] = node.iri();
    if (!weights.emplace(target, node.Number(Ex(names.value))).second) {
      policy.Refuse(Ex(names.link),
                    "one weight for " +
                        kg_core::ToTurtle(kg_core::Iri(target)) + ", not two");
    }
  }
  return weights;
}

// Reads the modes of Eq. 1, apart from its weights.
void ReadModes(const FactEntity& entity, Policy* policy) {
  policy->normalisation = Choice(entity, Ex("normalisation"), kNormalisations,
                                 policy->normalisation);
  policy->confidence_mode = Choice(entity, Ex("confidenceMode"),
                                   kConfidenceModes, policy->confidence_mode);
  policy->front_operator = Choice(entity, Ex("frontOperator"), kFrontOperators,
                                  policy->front_operator);
  policy->layer_scale =
      Choice(entity, Ex("layerScale"), kLayerScales, policy->layer_scale);
  policy->soft_overlap =
      Choice(entity, Ex("softOverlap"), kSoftOverlaps, policy->soft_overlap);
  policy->paper_literal =
      entity.Flag(Ex("paperLiteral"), policy->paper_literal);
}

// Reads the options for path selection, apart from the cost terms.
void ReadPathRules(const FactEntity& entity, Policy* policy) {
  if (const auto hours = entity.MaybeNumber(Ex("riskBudgetHours"))) {
    policy->hazard_budget_s = kg_base::HoursToSeconds(*hours);
  }
  policy->diverse_paths =
      Choice(entity, Ex("pathChoice"), kPathChoices, policy->diverse_paths);
  policy->minimum_difference =
      entity.Integer(Ex("minimumDifference"), policy->minimum_difference);
  policy->churn_weight = entity.Number(Ex("churnWeight"), policy->churn_weight);
}

}  // namespace

Capabilities ReadCapabilities(const FactEntity& entity) {
  Capabilities can;
  can.iri = entity.iri();
  can.cruise_mps = kg_base::KnotsToMps(entity.Number(Ex("cruiseSpeedKts")));
  can.max_mps = kg_base::KnotsToMps(entity.Number(Ex("maxSpeedKts")));
  can.energy_per_m_j =
      kg_base::WhPerKmToJoulesPerMetre(entity.Number(Ex("energyPerKm")));
  can.hotel_load_w = entity.Number(Ex("hotelLoadW"), can.hotel_load_w);
  can.boost_gain = entity.Number(Ex("boostGain"), can.boost_gain);
  if (const auto km = entity.MaybeNumber(Ex("baseTravel"))) {
    can.base_travel_m = KmToMetres(*km);
  }
  can.energy_budget_j = kg_base::WhToJoules(entity.Number(Ex("energyBudget")));
  can.sensor_radius_m = KmToMetres(entity.Number(Ex("sensorRadiusKm")));
  return can;
}

Policy ReadPolicy(const kg_core::GraphView& view, const FactEntity& entity) {
  Policy policy;
  policy.iri = entity.iri();
  policy.name = entity.Text(Ex("name"), LocalName(policy.iri));
  policy.alpha_base = entity.Number(Ex("alpha_base"));
  policy.beta_poi = entity.Number(Ex("beta_poi"), policy.beta_poi);
  policy.gamma_front = entity.Number(Ex("gamma_front"), policy.gamma_front);
  // Cost weights are per hour and per Wh in facts, per SI unit in the mission.
  policy.lambda_time_per_s =
      entity.Number(Ex("lambda_time"), 0.0) / kg_base::kSecondsPerHour;
  policy.lambda_energy_per_j =
      entity.Number(Ex("lambda_energy"), 0.0) / kg_base::kJoulesPerWh;
  policy.lambda_risk = entity.Number(Ex("lambda_risk"), policy.lambda_risk);
  policy.lambda_uncertainty =
      entity.Number(Ex("lambda_unc"), policy.lambda_uncertainty);
  policy.lambda_turn_per_rad =
      entity.Number(Ex("lambda_turn"), policy.lambda_turn_per_rad);
  for (const SourceQuantity& quantity : CostQuantities()) {
    const auto lambda = entity.MaybeNumber(Ex(quantity.weight_property));
    if (lambda) {
      policy.lambda_fields[quantity.name] = *lambda / kg_base::kSecondsPerHour;
    }
  }
  policy.value_kind = entity.Text(Ex("valueKind"), policy.value_kind);
  if (const auto km = entity.MaybeNumber(Ex("hazardRangeKm"))) {
    policy.hazard_range_m = KmToMetres(*km);
  }
  policy.isolation_weight =
      entity.Number(Ex("isolationWeight"), policy.isolation_weight);
  ReadPathRules(entity, &policy);
  ReadModes(entity, &policy);
  policy.beta = Weights(view, entity, {"hasPriorWeight", "layer", "beta"},
                        &policy.weight_iris);
  policy.soft_overrides =
      Weights(view, entity, {"hasSoftOverride", "constraint", "attenuation"},
              &policy.weight_iris);
  return policy;
}

}  // namespace kg_mission
