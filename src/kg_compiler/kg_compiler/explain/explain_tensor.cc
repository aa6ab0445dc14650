#include "kg_compiler/explain/explain_tensor.h"

#include <algorithm>
#include <cmath>

#include "kg_base/common/input_error.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/data_plane/masks.h"
#include "kg_core/rdf/namespaces.h"

namespace kg_compiler {
namespace {

using kg_core::AbbreviateIri;

std::string WindowName(const kg_mission::TimeWindow& window) {
  return "window " + std::to_string(window.index);
}

std::size_t TensorIndex(const Compilation& compilation,
                        const kg_mission::Agent& agent, int window) {
  for (std::size_t i = 0; i < compilation.tensors.size(); ++i) {
    const MissionTensor& tensor = *compilation.tensors[i];
    if (tensor.agent_iri == agent.iri && tensor.window == window) return i;
  }
  throw kg_base::InputError(
      "window " + std::to_string(window) + " of " + agent.id +
      " is not planned: the windows are " +
      std::to_string(compilation.first_window) + " to " +
      std::to_string(static_cast<int>(compilation.mission.windows.size()) - 1));
}

}  // namespace

const MissionTensor& FindTensor(const Compilation& compilation,
                                const kg_mission::Agent& agent, int window) {
  return *compilation.tensors[TensorIndex(compilation, agent, window)];
}

TensorInputs FindTensorInputs(const Compilation& compilation,
                              const kg_mission::Agent& agent, int window) {
  TensorInputs inputs;
  const std::size_t i = TensorIndex(compilation, agent, window);
  inputs.mission = &compilation.mission;
  inputs.agent = &agent;
  inputs.rasters = compilation.rasters.at(i).get();
  inputs.window = &compilation.mission.windows.at(window);
  const auto horizon = compilation.horizons.find(agent.iri);
  if (horizon != compilation.horizons.end()) inputs.horizon = &horizon->second;
  return inputs;
}

TensorExplainer::TensorExplainer(const TensorInputs& inputs,
                                 const CitedFacts& facts)
    : in_(inputs), facts_(facts) {
  const ActiveFacts active =
      FindActiveFacts(*in_.mission, *in_.agent, *in_.window);
  made_ =
      BlendTensor(*in_.agent, *in_.window, *in_.rasters, active, in_.horizon);
  if (made_.n.range > 0.0) scale_ = 1.0 / made_.n.range;
  AddTerms(active);
  AddZones(active);
  DescribeParts();
}

void TensorExplainer::AddTerms(const ActiveFacts& active) {
  terms_ = BlendTerms(active, in_.agent->policy);
  for (const BlendTerm& term : terms_) {
    std::vector<double>& values = term_values_.emplace_back();
    values.assign(in_.rasters->grid.size(), 0.0);
    AddTerm(*in_.rasters, in_.agent->policy, made_.blend.open, term, &values);
  }
}

void TensorExplainer::AddZones(const ActiveFacts& active) {
  for (const ActiveConstraint& constraint : active.constraints) {
    if (!constraint.forbids() && constraint.attenuation == 1.0) continue;
    (constraint.forbids() ? hard_ : soft_)
        .push_back({constraint, ConstraintExtent(*in_.rasters, constraint)});
  }
}

// Fills the descriptions, in the order of the values from Evaluate().

void TensorExplainer::DescribeParts() {
  for (const BlendTerm& term : terms_) Describe(term);
  parts_.push_back({"max(0, V) - V", "the blend is held at 0 or above",
                    facts_.Policy(*in_.agent, {})});
  for (const Zone& zone : soft_) DescribeSoft(zone);
  DescribeScale();
  DescribeHard();
}

void TensorExplainer::Describe(const BlendTerm& term) {
  const std::string weight = Short(term.weight);
  Part part;
  part.facts = facts_.Term(*in_.agent, term);
  const Facts layer = facts_.Layer(in_.rasters->value_iri);
  switch (term.kind) {
    case BlendTerm::Kind::kBase:
      part = {"alpha_base * B'",
              "value: ex:alpha_base " + weight + " on " +
                  AbbreviateIri(in_.rasters->value_iri),
              part.facts + layer, true};
      break;
    case BlendTerm::Kind::kFront:
      part = {"gamma_front * F'",
              "front: ex:gamma_front " + weight + " on the gradient of " +
                  AbbreviateIri(in_.rasters->value_iri),
              part.facts + layer, true};
      break;
    case BlendTerm::Kind::kPrior:
      part.term = "beta * P(" + AbbreviateIri(term.prior->iri) + ")";
      part.text =
          "prior: weight " + weight + " on " + AbbreviateIri(term.prior->iri);
      break;
    case BlendTerm::Kind::kEvent:
      part.term = "beta_poi * P(" + AbbreviateIri(term.event->iri) + ")";
      part.text = "event: ex:beta_poi " + weight + " on the bump of " +
                  AbbreviateIri(term.event->iri);
      break;
  }
  parts_.push_back(std::move(part));
}

void TensorExplainer::DescribeSoft(const Zone& zone) {
  const std::string iri = AbbreviateIri(zone.constraint.fact->iri);
  parts_.push_back(
      {"M_soft(" + iri + ")",
       "soft zone " + iri + ": times " + Short(zone.constraint.attenuation),
       facts_.Constraint(*in_.agent, zone.constraint)});
}

TensorExplainer::Part TensorExplainer::ConfidencePart() const {
  return {"w_t",
          "confidence of " + WindowName(*in_.window) + ": times " +
              Short(in_.window->confidence),
          facts_.Window(*in_.window, {"ex:index", "ex:confidence"}) +
              facts_.Policy(*in_.agent, {"ex:confidenceMode"})};
}

void TensorExplainer::DescribeScale() {
  const Facts policy =
      facts_.Policy(*in_.agent, {"ex:normalisation", "ex:confidenceMode"});
  const std::string over =
      in_.horizon ? "of all windows" : "of the window's open cells";
  parts_.push_back(ConfidencePart());
  parts_.push_back({"-low / range",
                    "normalisation: the lowest value " + over + " counts 0",
                    policy});
  const bool is_flat = !(made_.n.range > 0.0);
  parts_.push_back(
      {"N in [0, 1]",
       is_flat ? "normalisation: nothing " + over + " is of value, so all is 0"
               : "normalisation is held in [0, 1]",
       policy});
  parts_.push_back(ConfidencePart());
}

void TensorExplainer::DescribeHard() {
  parts_.push_back({"M_hard(land)", facts_.NoData(in_.rasters->field_iri),
                    facts_.Layer(in_.rasters->field_iri)});
  for (const Zone& zone : hard_) {
    const std::string iri = AbbreviateIri(zone.constraint.fact->iri);
    const bool is_soft =
        !kg_mission::EffectOf(zone.constraint.fact->kind).forbids;
    parts_.push_back(
        {"M_hard(" + iri + ")",
         "forbidden by " + iri +
             (is_soft ? ", a soft zone that the agent must avoid" : ""),
         facts_.Constraint(*in_.agent, zone.constraint)});
  }
}

// Values ----------------------------------------------------------------------

void TensorExplainer::Evaluate(std::size_t cell,
                               std::vector<double>* values) const {
  double* next = values->data();
  double v = 0.0;
  for (const std::vector<double>& term : term_values_) {
    *next++ += scale_ * term[cell];
    v += term[cell];
  }
  const kg_mission::Policy& policy = in_.agent->policy;
  double y = policy.paper_literal ? v : std::max(0.0, v);
  *next++ += scale_ * (y - v);
  const double unmasked = y;
  double factor = 1.0;
  for (const Zone& zone : soft_) {
    const double own = zone.inside[cell] ? zone.constraint.attenuation : 1.0;
    factor = policy.soft_overlap == kg_mission::SoftOverlap::kProduct
                 ? factor * own
                 : std::min(factor, own);
    *next++ += scale_ * (unmasked * factor - y);
    y = unmasked * factor;
  }
  // Parts of M_hard (land, then the hard zones) follow four parts of the scale.
  double* const hard = next + 4;
  if (policy.paper_literal) {
    const double left = scale_ * y;
    Forbid(cell, left, hard);
    if (!made_.blend.open[cell]) y = 0.0;
  }
  *next++ += scale_ * (y * made_.before - y);
  y *= made_.before;
  *next++ -= scale_ * made_.n.low;
  const double z = made_.n.Apply(y);
  *next++ += z - scale_ * (y - made_.n.low);
  *next++ += z * made_.after - z;
  if (!made_.blend.counted[cell]) {
    if (policy.paper_literal) *hard -= z;
  }
  if (!policy.paper_literal) Forbid(cell, z * made_.after, hard);
}

void TensorExplainer::Forbid(std::size_t cell, double value,
                             double* parts) const {
  double left = value;
  const auto take = [&left](bool closed, double* part) {
    if (!closed) return;
    *part -= left;
    left = 0.0;
  };
  take(in_.rasters->land[cell] != 0, parts++);
  for (const Zone& zone : hard_) take(zone.inside[cell] != 0, parts++);
}

Explanation TensorExplainer::Collect(const std::vector<double>& values) const {
  Explanation explanation;
  explanation.unit = "1";
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (values[i] == 0.0 && !parts_[i].is_kept) continue;
    explanation.parts.push_back(
        {values[i], parts_[i].term, parts_[i].facts, parts_[i].text});
  }
  return explanation;
}

Explanation TensorExplainer::ExplainSum(const std::vector<int>& cells) const {
  std::vector<double> values(parts_.size(), 0.0);
  double sum = 0.0;
  const int size = static_cast<int>(made_.blend.open.size());
  for (const int cell : cells) {
    if (cell < 0 || cell >= size) {
      throw kg_base::InputError("cell " + std::to_string(cell) +
                                " of a footprint is not one of the grid's " +
                                std::to_string(size));
    }
    Evaluate(static_cast<std::size_t>(cell), &values);
    if (!made_.blend.counted[cell]) continue;
    sum += made_.after * made_.n.Apply(made_.blend.masked[cell]);
  }
  Explanation explanation = Collect(values);
  explanation.value = sum;
  return explanation;
}

Explanation TensorExplainer::ExplainCell(kg_base::Cell cell) const {
  const std::size_t i = in_.rasters->grid.Index(cell);
  Explanation explanation = ExplainSum({static_cast<int>(i)});
  // Constraints that forbid the cell are listed even if they change nothing.
  const std::size_t first = parts_.size() - hard_.size() - 1;
  const auto add = [&](bool closed, const Part& part) {
    const auto same = [&](const Contribution& c) {
      return c.term == part.term;
    };
    if (!closed ||
        std::any_of(explanation.parts.begin(), explanation.parts.end(), same)) {
      return;
    }
    explanation.parts.push_back({0.0, part.term, part.facts, part.text});
  };
  add(in_.rasters->land[i] != 0, parts_[first]);
  for (std::size_t k = 0; k < hard_.size(); ++k) {
    add(hard_[k].inside[i] != 0, parts_[first + 1 + k]);
  }
  explanation.text = "U of " + in_.agent->id + " in " +
                     WindowName(*in_.window) + " at " +
                     kg_base::PointWkt(in_.rasters->grid.Centre(cell)) +
                     " is " + Short(explanation.value) + ".";
  return explanation;
}

}  // namespace kg_compiler
