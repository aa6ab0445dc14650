#include "kg_mission/mission/source_quantities.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "kg_base/common/input_error.h"

namespace kg_mission {
namespace {

using kg_base::FieldQuantity;

}  // namespace

const std::vector<SourceQuantity>& SourceQuantities() {
  static const std::vector<SourceQuantity> kQuantities = {
      {"current",
       FieldRole::kMotion,
       {FieldQuantity::kEastwardVelocity, FieldQuantity::kNorthwardVelocity},
       "",
       "CurrentField",
       "seaWaterVelocity",
       "",
       "m/s"},
      {"wind",
       FieldRole::kMotion,
       {FieldQuantity::kEastwardVelocity, FieldQuantity::kNorthwardVelocity},
       "eastward_wind",
       "WorkField",
       "windVelocity",
       "",
       "m/s"},
      {"temperature",
       FieldRole::kValue,
       {FieldQuantity::kTemperature},
       "",
       "ValueLayer",
       "",
       "",
       "degree Celsius"},
      {"wave_height",
       FieldRole::kCost,
       {FieldQuantity::kWaveHeight},
       "",
       "CostField",
       "waveHeight",
       "lambda_waveHeight",
       "m"}};
  return kQuantities;
}

const std::vector<SourceQuantity>& CostQuantities() {
  static const std::vector<SourceQuantity> kCosts = [] {
    std::vector<SourceQuantity> costs;
    std::copy_if(SourceQuantities().begin(), SourceQuantities().end(),
                 std::back_inserter(costs), [](const SourceQuantity& row) {
                   return row.role == FieldRole::kCost;
                 });
    return costs;
  }();
  return kCosts;
}

const SourceQuantity& FindFieldQuantity(const std::string& name) {
  for (const SourceQuantity& row : SourceQuantities()) {
    if (row.name == name) return row;
  }
  throw std::logic_error("no field quantity \"" + name + "\"");
}

void CheckMedium(const SourceQuantity& quantity,
                 const kg_base::QuantitySeries& first) {
  for (const SourceQuantity& row : SourceQuantities()) {
    if (row.role != quantity.role || row.standard_name.empty()) continue;
    const bool is_it = first.standard_name == row.standard_name;
    if (is_it == (row.name == quantity.name)) continue;
    throw kg_base::InputError(
        "variable " + first.variable + " has standard_name \"" +
        first.standard_name + "\": expected " + row.standard_name +
        " where ex:provides is \"" + row.name + "\", and only there");
  }
}

}  // namespace kg_mission
