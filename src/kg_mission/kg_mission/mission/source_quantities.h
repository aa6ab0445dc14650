// The quantities that a mission's fields are of, one row each: what a data
// source names by ex:provides, how a file is read for it, and what is stated
// and compiled from it. How files name and scale a component (CF standard
// names, variable names, units, limits) is told by its FieldQuantity
// (field_values.cc).
//
// A new quantity that costs is a row here and a FieldQuantity: ingest, the
// mission reader, the seam cost terms and their hashes, messages and
// explanations go through the rows.

#ifndef KG_MISSION_MISSION_SOURCE_QUANTITIES_H_
#define KG_MISSION_MISSION_SOURCE_QUANTITIES_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"

namespace kg_mission {

enum class FieldRole {
  kMotion,  // A velocity that carries agents: two components, east and north.
  kValue,   // A scalar that value layers are made of.
  kCost,    // A scalar whose integral along a flight is a term of its cost.
};

struct SourceQuantity {
  std::string name;  // ex:provides.
  FieldRole role;
  std::vector<kg_base::FieldQuantity> components;
  // CF standard name of the first component that is of this quantity and of no
  // other; empty = any that is not another row's.
  std::string standard_name;
  std::string layer_class;        // Of what an ingest states: "CurrentField".
  std::string observed_property;  // sosa:observedProperty of it; may be empty.
  // Of ex:Policy, for kCost: reward per `unit` and hour.
  std::string weight_property;
  std::string unit;  // SI.
};

// In a fixed order: motion, value, cost.
const std::vector<SourceQuantity>& SourceQuantities();
// Those with role kCost, in that order. Weights and exposures are kept so.
const std::vector<SourceQuantity>& CostQuantities();

// By name. Throws std::logic_error if there is none: shapes admit no other.
const SourceQuantity& FindFieldQuantity(const std::string& name);

// Throws InputError if a file's first component is of another row's medium: of
// wind where sea water's is asked for.
void CheckMedium(const SourceQuantity& quantity,
                 const kg_base::QuantitySeries& first);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_SOURCE_QUANTITIES_H_
