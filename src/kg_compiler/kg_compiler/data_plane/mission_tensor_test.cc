#include "kg_compiler/data_plane/mission_tensor.h"

#include <gtest/gtest.h>

#include <set>
#include <stdexcept>

namespace kg_compiler {
namespace {

TEST(MissionTensor, GivesTheLayerAskedForAndRefusesOneItHasNot) {
  MissionTensor tensor;
  EXPECT_FALSE(tensor.Has(Layer::kFused));
  tensor.grid = kg_base::Grid({0.0, 1.0}, {0.0, 1.0});
  tensor.content = HoldLayers({{Layer::kReward, kg_base::Raster(4, 1.0f)},
                               {Layer::kFused, {0.5f, 0.25f, 0.0f, 1.0f}}});
  EXPECT_TRUE(tensor.Has(Layer::kFused));
  EXPECT_EQ(0.5f, tensor.Get(Layer::kFused)[0]);
  EXPECT_EQ(0.25f, tensor.At(Layer::kFused, 1));
  EXPECT_THROW(tensor.At(Layer::kFused, 4), std::out_of_range);
  EXPECT_FALSE(tensor.Has(Layer::kPolicy));
  EXPECT_THROW(tensor.Get(Layer::kPolicy), std::logic_error);
  EXPECT_THROW(tensor.At(Layer::kPolicy, 0), std::logic_error);
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
