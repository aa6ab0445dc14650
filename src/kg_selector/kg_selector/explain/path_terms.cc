#include "kg_selector/explain/path_terms.h"

#include <algorithm>
#include <utility>

#include "kg_base/common/join_strings.h"
#include "kg_compiler/control_plane/seam_cost.h"
#include "kg_compiler/explain/explain_seam.h"
#include "kg_compiler/explain/explain_tensor.h"
#include "kg_core/rdf/namespaces.h"
#include "kg_planner/k_best/k_best.h"
#include "kg_selector/paths/churn.h"
#include "kg_selector/paths/masking.h"

namespace kg_selector {
namespace {

using kg_compiler::Contribution;
using kg_compiler::Explanation;
using kg_compiler::operator+;
using kg_compiler::Facts;
using kg_compiler::SeamWeights;
using kg_compiler::Short;

// "waypoint 3", "waypoints 1, 3".
std::string StopNames(const std::vector<int>& stops) {
  return (stops.size() == 1 ? "waypoint " : "waypoints ") +
         kg_base::JoinStrings(
             stops, ", ", [](const int stop) { return std::to_string(stop); });
}

std::string EventNames(const Visit& visit) {
  return kg_base::JoinStrings(visit.events, ", ", [](const std::string& event) {
    return kg_core::AbbreviateIri(event);
  });
}

// Terms without a kind of their own are distinguished by `where`.
TermKind KindOf(const kg_compiler::SeamTerm& term) {
  for (const TermKind kind :
       {TermKind::kTime, TermKind::kEnergy, TermKind::kRisk,
        TermKind::kUncertainty, TermKind::kTurn}) {
    if (term.name == Name(kind)) return kind;
  }
  return TermKind::kField;
}

void AddSeam(const TeamMember& member, std::size_t stage,
             const kg_compiler::TraverseEdge& edge,
             std::vector<PathTerm>* terms) {
  const SeamWeights& weights = member.rules.weights;
  const int window = member.graphs[stage].window;
  const double confidence = member.rules.windows[stage].confidence;
  for (const kg_compiler::SeamTerm& term : kg_compiler::SeamTerms()) {
    if (term.is_optional && term.weight(weights) == 0.0) continue;
    const TermKind kind = KindOf(term);
    terms->push_back({window, kind, -term.Cost(weights, edge, confidence),
                      kind == TermKind::kField ? term.name : ""});
  }
}

const std::vector<const char*>& PolicyProperties(TermKind kind) {
  static const std::vector<const char*> properties[] = {
      {"ex:alpha_base", "ex:gamma_front", "ex:beta_poi"},
      {},
      {"ex:lambda_time"},
      {"ex:lambda_energy"},
      {"ex:lambda_risk", "ex:isolationWeight"},
      {"ex:lambda_unc"},
      {"ex:churnWeight"},
      {},
      {},
      {"ex:lambda_turn"}};
  return properties[static_cast<int>(kind)];
}

Facts EventFacts(const PlannedWorld& world, const PathTerm& term) {
  Facts facts;
  for (const kg_mission::Event& event : world.compilation->mission.events) {
    if (std::count(term.events.begin(), term.events.end(), event.iri) > 0) {
      facts = std::move(facts) + world.facts().Event(event.iri);
    }
  }
  return facts;
}

// Facts of the price of a term of the table, and of the window's layers that it
// applies to, if it is that of a field.
Facts FieldFacts(const PlannedWorld& world, const kg_mission::Agent& agent,
                 const PathTerm& term) {
  std::vector<const char*> properties;
  for (const kg_compiler::SeamTerm& row : kg_compiler::SeamTerms()) {
    if (row.name != term.where) continue;
    for (const std::string& property : row.policy_properties) {
      properties.push_back(property.c_str());
    }
  }
  Facts facts = world.facts().Policy(agent, properties);
  for (const auto& field : world.compilation->mission.cost_fields) {
    if (field.quantity != term.where || field.window != term.window) continue;
    facts = std::move(facts) + world.facts().Layer(field.iri);
  }
  return facts;
}

Facts LayerFacts(const PlannedWorld& world, const kg_mission::Agent& agent,
                 int window) {
  const auto inputs =
      kg_compiler::FindTensorInputs(*world.compilation, agent, window);
  return world.facts().Layer(inputs.rasters->value_iri);
}

Facts MotionFacts(const PlannedWorld& world, const kg_mission::Agent& agent,
                  int window) {
  return kg_compiler::MotionFacts(
      kg_compiler::FindSeamContext(*world.compilation, agent,
                                   FindMember(world, agent).rules, window),
      world.facts());
}

bool SameStops(const Pathlet& a, const Pathlet& b) {
  return std::equal(a.visits.begin(), a.visits.end(), b.visits.begin(),
                    b.visits.end(), [](const Visit& x, const Visit& y) {
                      return x.window == y.window && StopsOf(x) == StopsOf(y);
                    });
}

}  // namespace

const char* Name(TermKind kind) {
  static const char* const names[] = {
      "value",       "events", "time",       "energy", "risk",
      "uncertainty", "churn",  "separation", "field",  "turn"};
  return names[static_cast<int>(kind)];
}

std::vector<PathTerm> ListTerms(const PlannedWorld& world,
                                const TeamMember& member,
                                const Pathlet& pathlet) {
  std::vector<PathTerm> terms;
  for (std::size_t s = 0; s < pathlet.visits.size(); ++s) {
    const Visit& visit = pathlet.visits[s];
    const std::vector<int> stops = StopsOf(visit);
    // Scores of the waypoints visited; the rest of the reward is from events.
    double score = 0.0;
    for (const int stop : stops) {
      score += member.graphs[s].waypoints.at(stop).score;
    }
    terms.push_back({visit.window, TermKind::kValue, score, StopNames(stops)});
    terms.push_back({visit.window, TermKind::kEvents, visit.reward - score,
                     EventNames(visit), visit.events});
    AddSeam(member, s, EdgeTaken(member, pathlet, s), &terms);
    terms.push_back({visit.window, TermKind::kChurn,
                     -ChurnCost(member.rules, visit.window, visit.position),
                     ""});
  }
  const double penalty =
      SoftPenalty(world.rules, CommittedBefore(world, pathlet.agent), pathlet);
  if (penalty != 0.0) {
    terms.push_back({-1, TermKind::kSeparation, -penalty, ""});
  }
  return terms;
}

double Sum(const std::vector<PathTerm>& terms) {
  double sum = 0.0;
  for (const PathTerm& term : terms) sum += term.value;
  return sum;
}

Facts TermFacts(const PlannedWorld& world, const kg_mission::Agent& agent,
                const PathTerm& term) {
  const kg_compiler::CitedFacts facts = world.facts();
  const Facts policy = facts.Policy(agent, PolicyProperties(term.kind));
  if (term.kind == TermKind::kSeparation) {
    return facts.Quote({world.compilation->mission.iri,
                        {"ex:minimumSeparationKm", "ex:separationIsHard",
                         "ex:separationWeight"}});
  }
  // Every other term belongs to a window, whose confidence scales it.
  const Facts window =
      facts.Window(world.compilation->mission.windows.at(term.window),
                   {"ex:index", "ex:confidence"});
  switch (term.kind) {
    case TermKind::kValue:
      return policy + LayerFacts(world, agent, term.window) + window;
    case TermKind::kEvents:
      return EventFacts(world, term) + window;
    case TermKind::kTime:
    case TermKind::kEnergy:
      return policy + MotionFacts(world, agent, term.window) +
             facts.Capabilities(agent, {"ex:energyPerKm", "ex:hotelLoadW"});
    case TermKind::kField:
      return FieldFacts(world, agent, term) + window;
    case TermKind::kTurn:
      return policy + MotionFacts(world, agent, term.window) +
             facts.Quote(
                 {FindMember(world, agent).rules.start_iri, {"ex:headingDeg"}});
    case TermKind::kRisk:
    case TermKind::kUncertainty:
    case TermKind::kChurn:
    case TermKind::kSeparation:
      return policy + window;
  }
  return {};
}

std::string Describe(const PathTerm& term) {
  const std::string where = term.where.empty() ? "" : " of " + term.where;
  return (term.window < 0 ? ""
                          : "window " + std::to_string(term.window) + ": ") +
         Name(term.kind) + where;
}

std::vector<Contribution> PathContributions(const PlannedWorld& world,
                                            const TeamMember& member,
                                            const Pathlet& pathlet) {
  const kg_mission::Agent& agent = FindAgent(world, pathlet.agent);
  std::vector<Contribution> parts;
  for (const PathTerm& term : ListTerms(world, member, pathlet)) {
    if (term.value == 0.0) continue;
    parts.push_back({term.value, Name(term.kind), TermFacts(world, agent, term),
                     Describe(term)});
  }
  return parts;
}

Explanation Difference(const PlannedWorld& world, const TeamMember& member,
                       const Pathlet& chosen, const Pathlet& other) {
  const kg_mission::Agent& agent = FindAgent(world, chosen.agent);
  std::vector<PathTerm> ours = ListTerms(world, member, chosen);
  std::vector<PathTerm> theirs = ListTerms(world, member, other);
  Explanation explanation;
  explanation.unit = "reward";
  explanation.value = Sum(ours) - Sum(theirs);
  const auto add = [&](const PathTerm& a, const PathTerm* b) {
    const double value = a.value - (b ? b->value : 0.0);
    const bool moved = b && b->where != a.where && !b->where.empty();
    const Facts facts = TermFacts(world, agent, a) +
                        (moved ? TermFacts(world, agent, *b) : Facts());
    explanation.AddIfAny({value, Name(a.kind), facts,
                          Describe(a) + ": " + Short(a.value) + " against " +
                              Short(b ? b->value : 0.0) +
                              (moved ? " of " + b->where : std::string())});
  };
  for (const PathTerm& a : ours) {
    const auto b =
        std::find_if(theirs.begin(), theirs.end(), [&](const PathTerm& term) {
          // A window may have several field terms, distinguished by `where`.
          return term.window == a.window && term.kind == a.kind &&
                 (a.kind != TermKind::kField || term.where == a.where);
        });
    add(a, b == theirs.end() ? nullptr : &*b);
    if (b != theirs.end()) theirs.erase(b);
  }
  // Remaining terms have no counterpart in ours.
  // Soft separation broken by the other path only.
  for (PathTerm rest : theirs) {
    const PathTerm theirs_alone = rest;
    rest.value = 0.0;
    add(rest, &theirs_alone);
  }
  return explanation;
}

FoundPath FindBest(const PlannedWorld& world, const TeamMember& member,
                   const PathSearch& search) {
  const std::vector<Pathlet> before =
      CommittedBefore(world, member.rules.agent_iri);
  const kg_compiler::SeamRules open =
      CloseEvents(member.rules, FullEvents(world.rules, before));
  kg_planner::PathMasks masks =
      MaskCommitted(world.rules, member.graphs, before);
  masks.nodes.insert(masks.nodes.end(), search.masks.nodes.begin(),
                     search.masks.nodes.end());
  masks.seams.insert(masks.seams.end(), search.masks.seams.begin(),
                     search.masks.seams.end());
  kg_planner::KBestOptions options;
  // Two paths, because one may be excluded; with soft separation all
  // candidates, because the penalty can change which is best.
  options.paths =
      std::max(world.rules.separation_is_hard ? 2 : open.candidates, 2);
  const kg_planner::KBest best =
      kg_planner::FindKBest(ToTrellis(open, member.graphs), masks, options);
  FoundPath found;
  found.proven = best.proven;
  double max_value = 0.0;
  for (const kg_planner::Path& path : best.paths) {
    Pathlet pathlet = ToPathlet(open, member.graphs, path, 0);
    if (search.except && SameStops(pathlet, *search.except)) continue;
    const double value =
        pathlet.score() - SoftPenalty(world.rules, before, pathlet);
    if (found.pathlet && !(value > max_value)) continue;
    max_value = value;
    found.pathlet = std::move(pathlet);
  }
  return found;
}

}  // namespace kg_selector
