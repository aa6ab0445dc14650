// The facts about one subject, as typed values. What is missing or of another
// type is refused with one line: "ex:alpha ex:id: expected ...".

#ifndef KG_CORE_MISSION_ENTITY_H_
#define KG_CORE_MISSION_ENTITY_H_

#include <optional>
#include <string>
#include <vector>

#include "kg_core/facts/terms.h"
#include "kg_core/geo/wkt.h"
#include "kg_core/rdf/graph_view.h"
#include "kg_core/rdf/term.h"

namespace kg_core {

class FactEntity {
 public:
  FactEntity(const GraphView& view, Term subject)
      : view_(&view), subject_(std::move(subject)) {}

  const Term& subject() const { return subject_; }
  const std::string& iri() const { return subject_.text; }

  std::vector<Term> All(const Term& property) const;    // Sorted.
  std::optional<Term> One(const Term& property) const;  // Refuses two.
  FactEntity Follow(const Term& property) const;  // The one object; required.

  // In the unit of the facts. All throw InputError.
  std::optional<double> MaybeNumber(const Term& property) const;
  double Number(const Term& property) const;
  double Number(const Term& property, double fallback) const;
  int Integer(const Term& property) const;
  int Integer(const Term& property, int fallback) const;
  bool Flag(const Term& property, bool fallback) const;
  std::string Text(const Term& property) const;
  std::string Text(const Term& property, const std::string& fallback) const;
  std::optional<double> MaybeTime_s(const Term& property) const;
  std::vector<std::string> Iris(const Term& property) const;
  Geometry Wkt() const;     // geo:asWKT
  LonLat Position() const;  // geo:asWKT, a POINT.

  [[noreturn]] void Refuse(const Term& property,
                           const std::string& expectation) const;

 private:
  const GraphView* view_;
  Term subject_;
};

}  // namespace kg_core

#endif  // KG_CORE_MISSION_ENTITY_H_
