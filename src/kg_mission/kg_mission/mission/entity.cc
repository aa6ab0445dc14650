#include "kg_mission/mission/entity.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "kg_base/common/input_error.h"
#include "kg_core/facts/literals.h"

namespace kg_mission {
namespace {

using kg_base::Geometry;
using kg_core::Term;

}  // namespace

void FactEntity::Refuse(const Term& property,
                        const std::string& expectation) const {
  throw kg_base::InputError(kg_core::ToTurtle(subject_) + " " +
                            kg_core::ToTurtle(property) + ": expected " +
                            expectation);
}

std::vector<Term> FactEntity::All(const Term& property) const {
  std::vector<Term> values =
      kg_core::Objects(*view_, kg_core::kFactsGraph, subject_, property);
  std::sort(values.begin(), values.end());
  return values;
}

std::optional<Term> FactEntity::One(const Term& property) const {
  std::vector<Term> values = All(property);
  if (values.empty()) return std::nullopt;
  if (values.size() > 1) Refuse(property, "one value, not several");
  return std::move(values[0]);
}

FactEntity FactEntity::Follow(const Term& property) const {
  const std::optional<Term> object = One(property);
  if (!object || object->is_literal()) Refuse(property, "one that exists");
  return FactEntity(*view_, *object);
}

std::optional<double> FactEntity::MaybeNumber(const Term& property) const {
  const std::optional<Term> value = One(property);
  if (!value) return std::nullopt;
  const std::optional<double> number = kg_core::NumericValue(*value);
  if (!number || !std::isfinite(*number)) Refuse(property, "a finite number");
  return number;
}

double FactEntity::Number(const Term& property) const {
  const std::optional<double> number = MaybeNumber(property);
  if (!number) Refuse(property, "a number");
  return *number;
}

double FactEntity::Number(const Term& property, double fallback) const {
  return MaybeNumber(property).value_or(fallback);
}

int FactEntity::Integer(const Term& property) const {
  const double number = Number(property);
  const bool is_int = number == std::floor(number) &&
                      std::abs(number) <= std::numeric_limits<int>::max();
  if (!is_int) Refuse(property, "an integer");
  return static_cast<int>(number);
}

int FactEntity::Integer(const Term& property, int fallback) const {
  return One(property) ? Integer(property) : fallback;
}

bool FactEntity::Flag(const Term& property, bool fallback) const {
  const std::optional<Term> value = One(property);
  if (!value) return fallback;
  const std::optional<bool> flag = kg_core::BooleanValue(*value);
  if (!flag) Refuse(property, "true or false");
  return *flag;
}

std::string FactEntity::Text(const Term& property) const {
  const std::optional<Term> value = One(property);
  if (!value || !value->is_literal()) Refuse(property, "a string");
  return value->text;
}

std::string FactEntity::Text(const Term& property,
                             const std::string& fallback) const {
  return One(property) ? Text(property) : fallback;
}

std::optional<double> FactEntity::MaybeTime_s(const Term& property) const {
  const std::optional<Term> value = One(property);
  if (!value) return std::nullopt;
  const std::optional<double> time_s = kg_core::UnixSeconds(*value);
  if (!time_s) Refuse(property, "an xsd:dateTime");
  return time_s;
}

std::vector<std::string> FactEntity::Iris(const Term& property) const {
  std::vector<std::string> iris;
  for (const Term& value : All(property)) {
    if (value.is_literal()) Refuse(property, "IRIs only");
    iris.push_back(value.text);
  }
  return iris;
}

Geometry FactEntity::Wkt() const {
  const Term as_wkt = kg_core::GeoTerm("asWKT");
  try {
    return Geometry::FromWkt(Text(as_wkt));
  } catch (const kg_base::InputError& error) {
    Refuse(as_wkt, std::string("well-known text: ") + error.what());
  }
}

kg_base::LonLat FactEntity::Position() const {
  const Geometry geometry = Wkt();
  if (!geometry.IsPoint()) Refuse(kg_core::GeoTerm("asWKT"), "POINT(lon lat)");
  return geometry.Point();
}

}  // namespace kg_mission
