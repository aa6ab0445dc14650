// Quotes the facts of a world for explanations: the triples behind each term of
// the equations. Only triples in the world are quoted; a default value that was
// not stated has no triple.

#ifndef KG_COMPILER_EXPLAIN_CITED_FACTS_H_
#define KG_COMPILER_EXPLAIN_CITED_FACTS_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_compiler/data_plane/active_facts.h"
#include "kg_compiler/data_plane/blend.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_mission/mission/mission.h"

namespace kg_compiler {

using Facts = std::vector<std::string>;

// One subject and some of its properties, by prefixed names.
struct Citation {
  std::string subject;  // IRI.
  std::vector<const char*> properties;
};

class CitedFacts {
 public:
  // Quotes from facts, inferences, the state of the agents and, if named, one
  // plan's graph. `view` must outlive this object.
  explicit CitedFacts(const kg_core::GraphView& view,
                      const std::string& plan_graph = "");

  // Every triple of the subject with one of the properties ("ex:gamma_front").
  Facts Quote(const Citation& citation) const;
  Facts Quote(const std::vector<Citation>& citations) const;
  // The given triple, if it is in the world.
  Facts QuoteTriple(const std::string& subject, const char* property,
                    const std::string& object_iri) const;

  // The agent's policy with the given properties.
  Facts Policy(const kg_mission::Agent& agent,
               const std::vector<const char*>& properties) const;
  Facts Capabilities(const kg_mission::Agent& agent,
                     const std::vector<const char*>& properties) const;
  // Why a work field has no data in a cell, for users: land, or a value that
  // its quantity cannot have, if its file has such values.
  std::string NoData(const std::string& field_iri) const;
  // A layer or work field down to its file's hash.
  Facts Layer(const std::string& iri) const;
  Facts Term(const kg_mission::Agent& agent, const BlendTerm& term) const;
  Facts Constraint(const kg_mission::Agent& agent,
                   const ActiveConstraint& constraint) const;
  // The fact that the agent must avoid a soft zone, and its reasons.
  Facts MustAvoid(const std::string& agent_iri,
                  const std::string& zone_iri) const;
  Facts Window(const kg_mission::TimeWindow& window,
               const std::vector<const char*>& properties) const;
  Facts Event(const std::string& iri) const;

 private:
  // Source of a raster, down to the file's hash.
  Facts File(const std::optional<kg_mission::RasterRef>& raster) const;
  // The node of the policy that names `target`, and its value.
  Facts Entry(const kg_mission::Agent& agent, const char* link,
              const Citation& target) const;

  const kg_core::GraphView& view_;
  std::vector<std::string> graphs_;
};

Facts operator+(Facts a, const Facts& b);

}  // namespace kg_compiler

#endif  // KG_COMPILER_EXPLAIN_CITED_FACTS_H_
