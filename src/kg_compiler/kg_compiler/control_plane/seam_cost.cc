#include "kg_compiler/control_plane/seam_cost.h"

#include "kg_mission/mission/source_quantities.h"

namespace kg_compiler {
namespace {

double At(const std::vector<double>& values, std::size_t i) {
  return i < values.size() ? values[i] : 0.0;
}

// The terms of every mission. Columns: name, symbol, unit, weight, quantity,
// policy properties, field, is_optional.
std::vector<SeamTerm> FixedTerms() {
  return {
      {"time",
       "lambda_time * t",
       "s",
       [](const SeamWeights& weights) { return weights.time_per_s; },
       [](const TraverseEdge& edge, double) { return edge.flight.travel_s; },
       {"ex:lambda_time"},
       ""},
      {"energy",
       "lambda_energy * E",
       "J",
       [](const SeamWeights& weights) { return weights.energy_per_j; },
       [](const TraverseEdge& edge, double) { return edge.flight.energy_j; },
       {"ex:lambda_energy"},
       ""},
      {"risk",
       "lambda_risk * (H + I)",
       "s",
       [](const SeamWeights& weights) { return weights.risk_per_s; },
       [](const TraverseEdge& edge, double) {
         return edge.flight.hazard_s + edge.isolation_s;
       },
       {"ex:lambda_risk", "ex:isolationWeight"},
       ""},
      {"uncertainty",
       "lambda_unc * (1 - w)",
       "1",
       [](const SeamWeights& weights) { return weights.uncertainty; },
       [](const TraverseEdge&, double confidence) { return 1.0 - confidence; },
       {"ex:lambda_unc"},
       ""},
      {"turn",
       "lambda_turn * T",
       "rad",
       [](const SeamWeights& weights) { return weights.turn_per_rad; },
       [](const TraverseEdge& edge, double) { return edge.turn_rad; },
       {"ex:lambda_turn"},
       "",
       true}};
}

// The term of the i-th entry of CostQuantities().
SeamTerm FieldTerm(std::size_t i) {
  const kg_mission::SourceQuantity& quantity = kg_mission::CostQuantities()[i];
  SeamTerm term;
  term.name = quantity.name;
  term.symbol = quantity.weight_property + " * X";
  term.unit = quantity.unit + " s";
  term.weight = [i](const SeamWeights& weights) {
    return At(weights.field_per_s, i);
  };
  term.quantity = [i](const TraverseEdge& edge, double) {
    return At(edge.exposures, i);
  };
  term.policy_properties = {"ex:" + quantity.weight_property};
  term.field = quantity.name;
  term.is_optional = true;
  return term;
}

}  // namespace

const std::vector<SeamTerm>& SeamTerms() {
  static const std::vector<SeamTerm> kTerms = [] {
    std::vector<SeamTerm> terms = FixedTerms();
    for (std::size_t i = 0; i < kg_mission::CostQuantities().size(); ++i) {
      terms.push_back(FieldTerm(i));
    }
    return terms;
  }();
  return kTerms;
}

double SeamCost(const SeamWeights& weights, const TraverseEdge& edge,
                double confidence) {
  double cost = 0.0;
  for (const SeamTerm& term : SeamTerms()) {
    if (term.is_optional && term.weight(weights) == 0.0) continue;
    cost += term.Cost(weights, edge, confidence);
  }
  return cost;
}

}  // namespace kg_compiler
