// Rasters of the data plane <-> messages. Received messages are checked (sizes,
// order, finiteness of axes): kg_base::InputError names the field.

#ifndef KG_ROS_CONVERSION_TENSOR_CONVERSION_H_
#define KG_ROS_CONVERSION_TENSOR_CONVERSION_H_

#include <cstdint>
#include <string>
#include <vector>

#include "kg_base/raster/grid.h"
#include "kg_compiler/compile/mission_compiler.h"
#include "kg_compiler/data_plane/mission_tensor.h"
#include "kg_msgs/Grid.h"
#include "kg_msgs/MissionTensor.h"
#include "kg_msgs/WorkField.h"

namespace kg_ros {

kg_msgs::Grid ToMessage(const kg_base::Grid& grid);
kg_base::Grid FromMessage(const kg_msgs::Grid& message);

// Converts only the named layers.
kg_msgs::MissionTensor ToMessage(const kg_compiler::MissionTensor& tensor,
                                 const std::string& agent_id,
                                 std::uint64_t world_version,
                                 const std::vector<kg_compiler::Layer>& layers);
kg_compiler::MissionTensor FromMessage(const kg_msgs::MissionTensor& message);

kg_msgs::WorkField ToMessage(const kg_compiler::WorkField& field,
                             std::uint64_t world_version);
kg_compiler::WorkField FromMessage(const kg_msgs::WorkField& message);

}  // namespace kg_ros

#endif  // KG_ROS_CONVERSION_TENSOR_CONVERSION_H_
