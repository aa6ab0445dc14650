// Collects statements in one graph, subject by subject.
//
//   FactWriter write(Iri(kg_core::kProvGraph));
//   write.About(run, "PlanRun").Integer("rounds", 2).Time(time, 1.78e9);

#ifndef KG_ENGINE_FACTS_FACT_WRITER_H_
#define KG_ENGINE_FACTS_FACT_WRITER_H_

#include <string>
#include <utility>
#include <vector>

#include "kg_base/common/date_time.h"
#include "kg_base/common/units.h"
#include "kg_base/geo/wkt.h"
#include "kg_compiler/control_plane/edge_cost.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/store.h"

namespace kg_engine {

class FactWriter {
 public:
  explicit FactWriter(kg_core::Term graph) : graph_(std::move(graph)) {}

  // Sets the subject of the following statements.
  FactWriter& About(const kg_core::Term& subject) {
    subject_ = subject;
    return *this;
  }
  FactWriter& About(const kg_core::Term& subject, const std::string& type) {
    return About(subject).Add(kg_core::RdfType(), kg_core::Ex(type));
  }
  FactWriter& Add(const kg_core::Term& property, const kg_core::Term& value) {
    statements_.push_back({subject_, property, value, graph_});
    return *this;
  }
  FactWriter& Number(const std::string& name, double value) {
    return Add(kg_core::Ex(name), kg_core::DoubleLiteral(value));
  }
  FactWriter& Integer(const std::string& name, long long value) {
    return Add(kg_core::Ex(name), kg_core::IntegerLiteral(value));
  }
  FactWriter& Text(const std::string& name, const std::string& value) {
    return Add(kg_core::Ex(name), kg_core::Literal(value));
  }
  FactWriter& Link(const std::string& name, const kg_core::Term& value) {
    return Add(kg_core::Ex(name), value);
  }
  FactWriter& Time(const kg_core::Term& property, double time_s) {
    return Add(property,
               kg_core::Literal(kg_base::FormatDateTime(time_s),
                                std::string(kg_core::kXsd) + "dateTime"));
  }
  FactWriter& Position(const kg_core::Term& property,
                       const kg_base::LonLat& position) {
    return Add(property, kg_core::WktLiteral(kg_base::PointWkt(position)));
  }

  // Writes ex:costHours, ex:costEnergy, ex:costRisk, ex:seamCost, and
  // ex:costTurn if there is a turn.
  FactWriter& Cost(const kg_compiler::EdgeCost& cost) {
    if (cost.turn_rad > 0.0) Number("costTurn", cost.turn_rad);
    return Number("costHours", cost.travel_s / kg_base::kSecondsPerHour)
        .Number("costEnergy", cost.energy_j / kg_base::kJoulesPerWh)
        .Number("costRisk",
                (cost.hazard_s + cost.isolation_s) / kg_base::kSecondsPerHour)
        .Number("seamCost", cost.seam_cost);
  }

  // Writes a prov:Activity of one of the ex: classes, with its times.
  FactWriter& Activity(const kg_core::Term& subject, const std::string& type,
                       double started_s, double ended_s) {
    return About(subject, type)
        .Add(kg_core::RdfType(), kg_core::Prov("Activity"))
        .Time(kg_core::Prov("startedAtTime"), started_s)
        .Time(kg_core::Prov("endedAtTime"), ended_s);
  }
  FactWriter& DerivedFrom(const kg_core::Term& source) {
    return Add(kg_core::Prov("wasDerivedFrom"), source);
  }
  FactWriter& DerivedFrom(const std::vector<std::string>& iris) {
    for (const std::string& iri : iris) DerivedFrom(kg_core::Iri(iri));
    return *this;
  }
  FactWriter& GeneratedBy(const kg_core::Term& activity) {
    return Add(kg_core::Prov("wasGeneratedBy"), activity);
  }
  FactWriter& Used(const kg_core::Term& entity) {
    return Add(kg_core::Prov("used"), entity);
  }

  std::vector<kg_core::Statement> Take() { return std::move(statements_); }

 private:
  kg_core::Term graph_;
  kg_core::Term subject_;
  std::vector<kg_core::Statement> statements_;
};

// Stages all statements.
inline void AddAll(const std::vector<kg_core::Statement>& statements,
                   kg_core::Transaction* transaction) {
  for (const kg_core::Statement& statement : statements) {
    transaction->Add(statement);
  }
}

}  // namespace kg_engine

#endif  // KG_ENGINE_FACTS_FACT_WRITER_H_
