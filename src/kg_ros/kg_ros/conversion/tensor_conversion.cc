#include "kg_ros/conversion/tensor_conversion.h"

#include <cmath>
#include <utility>

#include "kg_base/common/input_error.h"
#include "kg_base/common/units.h"
#include "kg_ros/conversion/message_units.h"

namespace kg_ros {
namespace {

using kg_base::InputError;
using kg_compiler::Layer;

constexpr Layer kAllLayers[] = {Layer::kReward,      Layer::kUncertainty,
                                Layer::kPolicy,      Layer::kAttenuation,
                                Layer::kFeasibility, Layer::kFused};

Layer LayerNamed(const std::string& name) {
  for (const Layer layer : kAllLayers) {
    if (name == kg_compiler::Name(layer)) return layer;
  }
  throw InputError("MissionTensor.layers: no layer is named '" + name + "'");
}

std::vector<double> InRadians(const std::vector<double>& deg) {
  std::vector<double> rad;
  rad.reserve(deg.size());
  for (const double value : deg) rad.push_back(kg_base::DegToRad(value));
  return rad;
}

std::vector<double> AxisInDegrees(const std::vector<double>& rad,
                                  const std::string& field) {
  if (rad.size() < 2) throw InputError(field + " has fewer than two entries");
  std::vector<double> deg;
  deg.reserve(rad.size());
  for (const double value : rad) {
    if (!std::isfinite(value) || !(std::abs(value) <= 2.0 * kg_base::kPi)) {
      throw InputError(field + " must be angles in rad");
    }
    if (!deg.empty() && !(kg_base::RadToDeg(value) > deg.back())) {
      throw InputError(field + " must ascend");
    }
    deg.push_back(kg_base::RadToDeg(value));
  }
  return deg;
}

void CheckSize(const kg_base::Grid& grid, std::size_t size,
               const std::string& field) {
  if (size == grid.size()) return;
  throw InputError(field + " has " + std::to_string(size) + " values for " +
                   std::to_string(grid.size()) + " cells");
}

}  // namespace

kg_msgs::Grid ToMessage(const kg_base::Grid& grid) {
  kg_msgs::Grid message;
  message.lon_rad = InRadians(grid.lon_deg());
  message.lat_rad = InRadians(grid.lat_deg());
  return message;
}

kg_base::Grid FromMessage(const kg_msgs::Grid& message) {
  return kg_base::Grid(AxisInDegrees(message.lon_rad, "Grid.lon_rad"),
                       AxisInDegrees(message.lat_rad, "Grid.lat_rad"));
}

kg_msgs::MissionTensor ToMessage(const kg_compiler::MissionTensor& tensor,
                                 const std::string& agent_id,
                                 const std::uint64_t world_version,
                                 const std::vector<Layer>& layers) {
  kg_msgs::MissionTensor message;
  message.world_version = world_version;
  message.agent = agent_id;
  message.agent_iri = tensor.agent_iri;
  message.window = tensor.window;
  message.confidence = tensor.confidence;
  message.hash = tensor.hash;
  message.grid = ToMessage(tensor.grid);
  for (const Layer layer : layers) {
    message.layers.emplace_back();
    message.layers.back().name = kg_compiler::Name(layer);
    message.layers.back().values = tensor.Get(layer);
  }
  return message;
}

kg_compiler::MissionTensor FromMessage(const kg_msgs::MissionTensor& message) {
  kg_compiler::MissionTensor tensor;
  tensor.agent_iri = message.agent_iri;
  tensor.window = message.window;
  tensor.confidence = message.confidence;
  tensor.hash = message.hash;
  tensor.grid = FromMessage(message.grid);
  std::vector<kg_compiler::TensorLayer> layers;
  for (const kg_msgs::TensorLayer& layer : message.layers) {
    CheckSize(tensor.grid, layer.values.size(), "layer " + layer.name);
    layers.push_back({LayerNamed(layer.name), layer.values});
  }
  tensor.content = kg_compiler::HoldLayers(std::move(layers));
  return tensor;
}

namespace {

std::vector<kg_msgs::ScalarSlice> ToMessage(
    const std::vector<kg_base::ScalarField>& fields) {
  std::vector<kg_msgs::ScalarSlice> message;
  for (const kg_base::ScalarField& field : fields) {
    for (const kg_base::ScalarSlice& slice : field.slices) {
      message.emplace_back();
      message.back().quantity = field.quantity;
      message.back().stamp = ToRosTime(slice.time_s);
      message.back().values = slice.values;
    }
  }
  return message;
}

// Requires that slices of one quantity are adjacent.
std::vector<kg_base::ScalarField> FromMessage(
    const std::vector<kg_msgs::ScalarSlice>& message,
    const kg_base::Grid& grid) {
  std::vector<kg_base::ScalarField> fields;
  for (const kg_msgs::ScalarSlice& slice : message) {
    CheckSize(grid, slice.values.size(), "ScalarSlice.values");
    if (fields.empty() || fields.back().quantity != slice.quantity) {
      fields.push_back({slice.quantity, {}});
    }
    std::vector<kg_base::ScalarSlice>& slices = fields.back().slices;
    const double time_s = FromRosTime(slice.stamp);
    if (!slices.empty() && !(time_s > slices.back().time_s)) {
      throw InputError("WorkField.scalars must ascend in time");
    }
    slices.push_back({time_s, slice.values});
  }
  return fields;
}

}  // namespace

kg_msgs::WorkField ToMessage(const kg_compiler::WorkField& field,
                             const std::uint64_t world_version) {
  kg_msgs::WorkField message;
  message.world_version = world_version;
  message.iri = field.iri;
  message.window = field.window;
  message.hash = field.hash;
  message.grid = ToMessage(field.field.grid);
  for (const kg_base::FieldSlice& slice : field.field.slices) {
    message.slices.emplace_back();
    message.slices.back().stamp = ToRosTime(slice.time_s);
    message.slices.back().east_mps = slice.east_mps;
    message.slices.back().north_mps = slice.north_mps;
  }
  message.scalars = ToMessage(field.field.scalars);
  return message;
}

kg_compiler::WorkField FromMessage(const kg_msgs::WorkField& message) {
  kg_compiler::WorkField field;
  field.iri = message.iri;
  field.window = message.window;
  field.hash = message.hash;
  field.field.grid = FromMessage(message.grid);
  if (message.slices.empty()) throw InputError("WorkField.slices is empty");
  for (const kg_msgs::FieldSlice& slice : message.slices) {
    CheckSize(field.field.grid, slice.east_mps.size(), "FieldSlice.east_mps");
    CheckSize(field.field.grid, slice.north_mps.size(), "FieldSlice.north_mps");
    const double time_s = FromRosTime(slice.stamp);
    if (!field.field.slices.empty() &&
        !(time_s > field.field.slices.back().time_s)) {
      throw InputError("WorkField.slices must ascend in time");
    }
    field.field.slices.push_back({time_s, slice.east_mps, slice.north_mps});
  }
  field.field.scalars = FromMessage(message.scalars, field.field.grid);
  return field;
}

}  // namespace kg_ros
