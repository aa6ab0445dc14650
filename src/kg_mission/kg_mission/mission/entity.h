// The facts about one subject, as typed values. Missing values and values of
// another type throw InputError with one line: "ex:alpha ex:id: expected ...".

#ifndef KG_MISSION_MISSION_ENTITY_H_
#define KG_MISSION_MISSION_ENTITY_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_base/geo/wkt.h"
#include "kg_core/facts/terms.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_mission {

class FactEntity {
 public:
  FactEntity(const kg_core::GraphView& view, kg_core::Term subject)
      : view_(&view), subject_(std::move(subject)) {}

  const kg_core::Term& subject() const { return subject_; }
  const std::string& iri() const { return subject_.text; }

  std::vector<kg_core::Term> All(
      const kg_core::Term& property) const;  // Sorted.
  std::optional<kg_core::Term> One(
      const kg_core::Term& property) const;  // Rejects two.
  FactEntity Follow(
      const kg_core::Term& property) const;  // The one object; required.

  // In the unit of the facts. All throw InputError.
  std::optional<double> MaybeNumber(const kg_core::Term& property) const;
  double Number(const kg_core::Term& property) const;
  double Number(const kg_core::Term& property, double fallback) const;
  int Integer(const kg_core::Term& property) const;
  int Integer(const kg_core::Term& property, int fallback) const;
  bool Flag(const kg_core::Term& property, bool fallback) const;
  std::string Text(const kg_core::Term& property) const;
  std::string Text(const kg_core::Term& property,
                   const std::string& fallback) const;
  std::optional<double> MaybeTime_s(const kg_core::Term& property) const;
  std::vector<std::string> Iris(const kg_core::Term& property) const;
  kg_base::Geometry Wkt() const;     // geo:asWKT
  kg_base::LonLat Position() const;  // geo:asWKT, a POINT.

  [[noreturn]] void Refuse(const kg_core::Term& property,
                           const std::string& expectation) const;

 private:
  const kg_core::GraphView* view_;
  kg_core::Term subject_;
};

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_ENTITY_H_
