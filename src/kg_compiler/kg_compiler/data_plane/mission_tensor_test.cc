#include "kg_compiler/data_plane/mission_tensor.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace kg_compiler {
namespace {

TEST(MissionTensor, GivesTheLayerAskedForAndRefusesOneItHasNot) {
  MissionTensor tensor;
  tensor.layers = {{Layer::kReward, {1.0f}}, {Layer::kFused, {0.5f}}};
  EXPECT_EQ(0.5f, tensor.Get(Layer::kFused)[0]);
  EXPECT_THROW(tensor.Get(Layer::kPolicy), std::logic_error);
}

TEST(MissionTensor, NamesEveryLayerDifferently) {
  std::set<std::string> names;
  for (int layer = 0; layer < 6; ++layer) {
    names.insert(Name(static_cast<Layer>(layer)));
  }
  EXPECT_EQ(6u, names.size());
  EXPECT_EQ(1u, names.count("FUSED"));
}

}  // namespace
}  // namespace kg_compiler
