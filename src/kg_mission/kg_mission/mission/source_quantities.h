// Table of the physical quantities of a mission's fields, one row each: the
// name in ex:provides of a data source, how it is read from a file, and the
// facts and compiled terms made from it. The FieldQuantity of each component
// (field_values.cc) defines how files name and scale it (CF standard names,
// variable names, units, limits).
//
// A new cost quantity needs only a row here and a FieldQuantity: ingest, the
// mission reader, the seam cost terms and their hashes, messages and
// explanations iterate over the rows.

#ifndef KG_MISSION_MISSION_SOURCE_QUANTITIES_H_
#define KG_MISSION_MISSION_SOURCE_QUANTITIES_H_

#include <string>
#include <vector>

#include "kg_base/raster/field_file.h"

namespace kg_mission {

enum class FieldRole {
  kMotion,  // Velocity that carries agents; components east, north.
  kValue,   // Scalar from which value layers are made.
  kCost,    // Scalar whose integral along a flight is a cost term.
};

struct SourceQuantity {
  std::string name;  // Value of ex:provides.
  FieldRole role;
  std::vector<kg_base::FieldQuantity> components;
  // CF standard name of the first component that identifies this quantity;
  // empty = any name that is not in another row.
  std::string standard_name;
  // Class of the ingested layer: "CurrentField".
  std::string layer_class;
  std::string observed_property;  // Its sosa:observedProperty; may be empty.
  // For kCost: property of ex:Policy with the weight in reward per `unit` and
  // hour.
  std::string weight_property;
  std::string unit;  // SI unit.
};

// All quantities in a fixed order: motion, value, cost.
const std::vector<SourceQuantity>& SourceQuantities();
// The quantities with role kCost, in that order, which is also the order of
// weights and exposures.
const std::vector<SourceQuantity>& CostQuantities();

// Look-up by name. Throws std::logic_error if unknown, since the shapes reject
// other names.
const SourceQuantity& FindFieldQuantity(const std::string& name);

// Throws InputError if a file's first component belongs to the medium of
// another row, e.g. wind instead of sea water.
void CheckMedium(const SourceQuantity& quantity,
                 const kg_base::QuantitySeries& first);

}  // namespace kg_mission

#endif  // KG_MISSION_MISSION_SOURCE_QUANTITIES_H_
