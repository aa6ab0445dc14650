#include "kg_compiler/explain/explain_seam.h"

#include <map>
#include <string>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_compiler/control_plane/seam_cost.h"

namespace kg_compiler {
namespace {

std::string HoursText(double seconds) {
  return Short(seconds / kg_base::kSecondsPerHour) + " h";
}
std::string WattHours(double joules) {
  return Short(joules / kg_base::kJoulesPerWh) + " Wh";
}

std::string DegreesText(double angle_rad) {
  return Short(kg_base::RadToDeg(angle_rad)) + " degrees";
}

const WorkField* FindField(const Compilation& compilation, int window) {
  for (const auto& field : compilation.fields) {
    if (field->window == window) return field.get();
  }
  return nullptr;
}

class SeamExplainer {
 public:
  SeamExplainer(const SeamContext& context, const TraverseEdge& edge,
                const CitedFacts& facts)
      : in_(context), edge_(edge), flight_(edge.flight), facts_(facts) {
    explanation_.value = edge.seam_cost;
    explanation_.unit = "reward";
  }

  Explanation Explain() {
    for (const SeamTerm& term : SeamTerms()) AddTerm(term);
    return std::move(explanation_);
  }

 private:
  // Terms with several parts, or with a specific text, have their own method;
  // the others are explained from their table row.
  void AddTerm(const SeamTerm& term) {
    using Teller = void (SeamExplainer::*)();
    static const std::map<std::string, Teller> kTellers = {
        {"time", &SeamExplainer::AddTime},
        {"energy", &SeamExplainer::AddEnergy},
        {"risk", &SeamExplainer::AddRisk},
        {"uncertainty", &SeamExplainer::AddUncertainty},
        {"turn", &SeamExplainer::AddTurn}};
    const auto teller = kTellers.find(term.name);
    if (teller == kTellers.end()) return AddField(term);
    (this->*teller->second)();
  }

  void AddField(const SeamTerm& term) {
    const double confidence = in_.window->confidence;
    const double value = term.Cost(in_.rules->weights, edge_, confidence);
    if (value == 0.0) return;
    std::vector<const char*> properties;
    for (const std::string& property : term.policy_properties) {
      properties.push_back(property.c_str());
    }
    Facts facts =
        facts_.Policy(*in_.agent, properties) + MotionFacts(in_, facts_);
    // Cite the layers of this window that provided the quantity.
    for (const auto& field : in_.compilation->mission.cost_fields) {
      const bool is_met =
          field.quantity == term.field && field.window == in_.window->window;
      if (is_met) facts = std::move(facts) + facts_.Layer(field.iri);
    }
    Add(value, term.symbol,
        term.name + ": " + term.policy_properties.front() + " for " +
            Short(term.quantity(edge_, confidence)) + " " + term.unit +
            " under way",
        std::move(facts));
  }

  void Add(double value, std::string term, std::string text, Facts facts) {
    explanation_.AddIfAny(
        {value, std::move(term), std::move(facts), std::move(text)});
  }

  void AddTime() {
    Add(in_.rules->weights.time_per_s * flight_.travel_s, "lambda_time * t",
        "time: ex:lambda_time for " + HoursText(flight_.travel_s) +
            " under way",
        facts_.Policy(*in_.agent, {"ex:lambda_time"}) +
            MotionFacts(in_, facts_));
  }

  void AddEnergy() {
    const double weight = in_.rules->weights.energy_per_j;
    const MotionModel& motion = in_.rules->motion;
    // V t through the medium until the arrival; the rest is station keeping.
    const double swum_m = flight_.speed_mps * flight_.travel_s;
    const double held_m = flight_.through_water_m - swum_m;
    const double whole_s = in_.window->end_s - in_.window->begin_s;
    const Facts policy = facts_.Policy(*in_.agent, {"ex:lambda_energy"});
    const Facts swims = policy +
                        facts_.Capabilities(*in_.agent, {"ex:energyPerKm"}) +
                        MotionFacts(in_, facts_);
    const double swum_j = motion.energy_per_m_j * swum_m;
    const double held_j = motion.energy_per_m_j * held_m;
    const double hotel_j = motion.hotel_load_w * whole_s;
    Add(weight * swum_j, "lambda_energy * energy_per_m V t",
        "energy under way: ex:lambda_energy for " + WattHours(swum_j), swims);
    Add(weight * held_j, "lambda_energy * energy_per_m held",
        "energy on station: ex:lambda_energy for " + WattHours(held_j), swims);
    Add(weight * hotel_j, "lambda_energy * hotel_load",
        "hotel load: ex:lambda_energy for " + WattHours(hotel_j) + " in " +
            HoursText(whole_s),
        policy + facts_.Capabilities(*in_.agent, {"ex:hotelLoadW"}) +
            WindowFacts());
  }

  void AddRisk() {
    AddHazard();
    AddIsolation();
  }

  void AddHazard() {
    const double value = in_.rules->weights.risk_per_s * flight_.hazard_s;
    if (value == 0.0) return;
    Facts facts =
        facts_.Policy(*in_.agent, {"ex:lambda_risk", "ex:hazardRangeKm"});
    const ActiveFacts active =
        FindActiveFacts(in_.compilation->mission, *in_.agent, TimeWindowOf());
    for (const ActiveConstraint& constraint : active.constraints) {
      facts = std::move(facts) + facts_.Constraint(*in_.agent, constraint);
    }
    Add(value, "lambda_risk * H",
        "risk: ex:lambda_risk for " + HoursText(flight_.hazard_s) +
            " at hazard 1, near what is forbidden or in soft zones",
        std::move(facts));
  }

  void AddIsolation() {
    const double value = in_.rules->weights.risk_per_s * edge_.isolation_s;
    if (value == 0.0) return;
    const double share = edge_.isolation_s / flight_.travel_s;
    const double others = in_.rules->weights.isolation / share - 1.0;
    Add(value, "lambda_risk * I",
        "isolation: ex:lambda_risk for " + HoursText(flight_.travel_s) +
            " at ex:isolationWeight " + Short(in_.rules->weights.isolation) +
            " / (1 + " + Short(others) +
            "), the other waypoints within half of the base travel",
        facts_.Policy(*in_.agent, {"ex:lambda_risk", "ex:isolationWeight"}) +
            MotionFacts(in_, facts_));
  }

  void AddUncertainty() {
    const double doubt = 1.0 - in_.window->confidence;
    Add(in_.rules->weights.uncertainty * doubt, "lambda_unc * (1 - w)",
        "uncertainty: ex:lambda_unc for a confidence of " +
            Short(in_.window->confidence),
        facts_.Policy(*in_.agent, {"ex:lambda_unc"}) +
            facts_.Window(TimeWindowOf(), {"ex:confidence"}));
  }

  void AddTurn() {
    const SeamRules& rules = *in_.rules;
    Add(rules.weights.turn_per_rad * edge_.turn_rad, "lambda_turn * T",
        "turn: ex:lambda_turn for " + DegreesText(edge_.turn_rad) +
            " from the start heading of " +
            DegreesText(rules.start_heading_rad),
        facts_.Policy(*in_.agent, {"ex:lambda_turn"}) +
            facts_.Quote({rules.start_iri, {"ex:headingDeg"}}) +
            MotionFacts(in_, facts_));
  }

  const kg_mission::TimeWindow& TimeWindowOf() const {
    return in_.compilation->mission.windows.at(in_.window->window);
  }
  Facts WindowFacts() const {
    return facts_.Window(TimeWindowOf(), {"time:hasBeginning", "time:hasEnd",
                                          "ex:durationHours"});
  }

  const SeamContext& in_;
  const TraverseEdge& edge_;
  const FlownPath& flight_;
  const CitedFacts& facts_;
  Explanation explanation_;
};

}  // namespace

SeamContext FindSeamContext(const Compilation& compilation,
                            const kg_mission::Agent& agent,
                            const SeamRules& rules, int window) {
  for (const WindowRules& one : rules.windows) {
    if (one.window == window) return {&compilation, &agent, &rules, &one};
  }
  throw kg_base::InputError("window " + std::to_string(window) + " of " +
                            agent.id + " is not planned");
}

Facts MotionFacts(const SeamContext& context, const CitedFacts& facts) {
  const kg_mission::TimeWindow& window =
      context.compilation->mission.windows.at(context.window->window);
  Facts quoted =
      facts.Capabilities(*context.agent, {"ex:cruiseSpeedKts", "ex:maxSpeedKts",
                                          "ex:boostGain", "ex:baseTravel"}) +
      facts.Window(window,
                   {"time:hasBeginning", "time:hasEnd", "ex:durationHours"});
  const WorkField* field = FindField(*context.compilation, window.index);
  return field ? std::move(quoted) + facts.Layer(field->iri) : quoted;
}

Explanation ExplainSeam(const SeamContext& context, const TraverseEdge& edge,
                        const CitedFacts& facts) {
  return SeamExplainer(context, edge, facts).Explain();
}

}  // namespace kg_compiler
