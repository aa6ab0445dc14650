#include "kg_compiler/explain/cited_facts.h"

#include <algorithm>
#include <stdexcept>

#include "kg_core/rdf/namespaces.h"
#include "kg_core/rdf/term.h"
#include "kg_core/rules/reasons.h"

namespace kg_compiler {
namespace {

kg_core::Term Property(const char* name) {
  const auto iri = kg_core::ExpandPrefixed(name);
  if (!iri) throw std::logic_error(std::string(name) + ": unknown prefix");
  return kg_core::Iri(*iri);
}

std::string Triple(const kg_core::Term& subject, const kg_core::Term& property,
                   const kg_core::Term& object) {
  return ToTurtle(subject) + " " + ToTurtle(property) + " " + ToTurtle(object);
}

}  // namespace

Facts operator+(Facts a, const Facts& b) {
  for (const std::string& fact : b) {
    if (std::find(a.begin(), a.end(), fact) == a.end()) a.push_back(fact);
  }
  return a;
}

CitedFacts::CitedFacts(const kg_core::GraphView& view,
                       const std::string& plan_graph)
    : view_(view),
      graphs_{kg_core::kFactsGraph, kg_core::kInferredGraph,
              kg_core::kStateGraph} {
  if (!plan_graph.empty()) graphs_.push_back(plan_graph);
}

Facts CitedFacts::Quote(const Citation& citation) const {
  Facts facts;
  const kg_core::Term subject = kg_core::Iri(citation.subject);
  for (const char* name : citation.properties) {
    const kg_core::Term property = Property(name);
    for (const std::string& graph : graphs_) {
      for (const auto& object : Objects(view_, graph, subject, property)) {
        facts = std::move(facts) + Facts{Triple(subject, property, object)};
      }
    }
  }
  return facts;
}

Facts CitedFacts::Quote(const std::vector<Citation>& citations) const {
  Facts facts;
  for (const Citation& citation : citations) {
    facts = std::move(facts) + Quote(citation);
  }
  return facts;
}

Facts CitedFacts::QuoteTriple(const std::string& subject, const char* property,
                              const std::string& object_iri) const {
  const kg_core::Term s = kg_core::Iri(subject), p = Property(property);
  const kg_core::Term o = kg_core::Iri(object_iri);
  for (const std::string& graph : graphs_) {
    if (Has(view_, graph, s, p, o)) return {Triple(s, p, o)};
  }
  return {};
}

Facts CitedFacts::Policy(const kg_mission::Agent& agent,
                         const std::vector<const char*>& properties) const {
  return QuoteTriple(agent.iri, "ex:usesPolicy", agent.policy.iri) +
         Quote({agent.policy.iri, properties});
}

Facts CitedFacts::Capabilities(
    const kg_mission::Agent& agent,
    const std::vector<const char*>& properties) const {
  return QuoteTriple(agent.iri, "ex:hasCapabilities", agent.capabilities.iri) +
         Quote({agent.capabilities.iri, properties});
}

std::string CitedFacts::NoData(const std::string& field_iri) const {
  std::string text = "land: the currents have no data here";
  const char* const graph = kg_core::kFactsGraph;
  for (const auto& file : Objects(view_, graph, kg_core::Iri(field_iri),
                                  Property("prov:wasDerivedFrom"))) {
    for (const auto& report : kg_core::Subjects(
             view_, graph, Property("prov:wasDerivedFrom"), file)) {
      const auto count = kg_core::FirstObject(view_, graph, report,
                                              Property("ex:impossibleValues"));
      const auto variable =
          kg_core::FirstObject(view_, graph, report, Property("ex:variable"));
      if (!count || !variable || count->text == "0") continue;
      text += "; or not land: " + count->text + " impossible values of " +
              variable->text + " in the file count as no data";
    }
  }
  return text;
}

Facts CitedFacts::Layer(const std::string& iri) const {
  Facts facts =
      Quote({iri,
             {"ex:kind", "ex:forWindow", "ex:timeIndex", "ex:previousTimeIndex",
              "ex:firstTimeIndex", "ex:lastTimeIndex", "ex:resampling",
              "ex:fullScale", "ex:frontFullScale", "prov:wasDerivedFrom"}});
  for (const auto& file :
       Objects(view_, kg_core::kFactsGraph, kg_core::Iri(iri),
               Property("prov:wasDerivedFrom"))) {
    facts = std::move(facts) + Quote({file.text, {"ex:path", "ex:sha256"}});
  }
  return facts;
}

Facts CitedFacts::File(
    const std::optional<kg_mission::RasterRef>& raster) const {
  if (!raster) return {};
  return Quote({raster->file_iri, {"ex:path", "ex:sha256"}});
}

Facts CitedFacts::Entry(const kg_mission::Agent& agent, const char* link,
                        const Citation& target) const {
  Facts facts;
  const kg_core::Term policy = kg_core::Iri(agent.policy.iri);
  for (const auto& node :
       Objects(view_, kg_core::kFactsGraph, policy, Property(link))) {
    const Facts names =
        QuoteTriple(node.text, target.properties[0], target.subject);
    if (names.empty()) continue;
    facts = std::move(facts) + QuoteTriple(agent.policy.iri, link, node.text) +
            names + Quote({node.text, {target.properties[1]}});
  }
  return facts;
}

Facts CitedFacts::Term(const kg_mission::Agent& agent,
                       const BlendTerm& term) const {
  switch (term.kind) {
    case BlendTerm::Kind::kBase:
      return Policy(agent, {"ex:alpha_base", "ex:valueKind", "ex:layerScale"});
    case BlendTerm::Kind::kFront:
      return Policy(agent, {"ex:gamma_front", "ex:valueKind", "ex:layerScale",
                            "ex:frontOperator"});
    case BlendTerm::Kind::kPrior:
      return Policy(agent, {}) +
             Entry(agent, "ex:hasPriorWeight",
                   {term.prior->iri, {"ex:layer", "ex:beta"}}) +
             Quote({term.prior->iri,
                    {"ex:edgeKm", "ex:gridRef", "ex:resampling",
                     "geo:hasGeometry", "ex:appliesIn", "ex:appliesTo"}}) +
             File(term.prior->raster);
    case BlendTerm::Kind::kEvent:
      return Policy(agent, {"ex:beta_poi"}) + Event(term.event->iri);
  }
  return {};
}

Facts CitedFacts::Constraint(const kg_mission::Agent& agent,
                             const ActiveConstraint& constraint) const {
  const std::string& iri = constraint.fact->iri;
  Facts facts = Quote({iri,
                       {"ex:kind", "ex:attenuation", "ex:gridRef",
                        "ex:bufferCells", "ex:bufferMetric", "ex:resampling",
                        "geo:hasGeometry", "ex:appliesIn", "ex:appliesTo",
                        "ex:forAgent", "ex:forWindow", "ex:expires"}}) +
                File(constraint.fact->mask);
  if (kg_mission::EffectOf(constraint.fact->kind).forbids) return facts;
  facts = std::move(facts) + Policy(agent, {}) +
          Entry(agent, "ex:hasSoftOverride",
                {iri, {"ex:constraint", "ex:attenuation"}});
  if (!constraint.forbids()) return facts;
  return std::move(facts) + MustAvoid(agent.iri, iri);
}

// Stated by an operator, or inferred: then quotes the rule and its facts.
Facts CitedFacts::MustAvoid(const std::string& agent_iri,
                            const std::string& zone_iri) const {
  Facts facts = QuoteTriple(agent_iri, "ex:mustAvoid", zone_iri);
  const kg_core::Triple conclusion = {kg_core::Iri(agent_iri),
                                      Property("ex:mustAvoid"),
                                      kg_core::Iri(zone_iri)};
  for (const auto& inference : WhyInferred(view_, conclusion)) {
    facts = std::move(facts) +
            QuoteTriple(inference.iri, "ex:byRule", inference.rule_iri);
    for (const kg_core::Triple& premise : inference.premises) {
      facts = std::move(facts) +
              Facts{Triple(premise.subject, premise.predicate, premise.object)};
    }
  }
  return facts;
}

Facts CitedFacts::Window(const kg_mission::TimeWindow& window,
                         const std::vector<const char*>& properties) const {
  return Quote({window.iri, properties});
}

Facts CitedFacts::Event(const std::string& iri) const {
  return Quote({iri,
                {"ex:value", "ex:radiusKm", "ex:capacity", "ex:forWindow",
                 "ex:expiresAfter"}});
}

}  // namespace kg_compiler
