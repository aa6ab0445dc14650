#include "kg_selector/team/stability.h"

#include <cmath>

#include "gtest/gtest.h"
#include "kg_base/geo/geodesy.h"

namespace kg_selector {
namespace {

Pathlet Path(const std::string& agent, int first_window,
             const std::vector<double>& lon_deg) {
  Pathlet pathlet;
  pathlet.agent = agent;
  for (const double lon : lon_deg) {
    Visit visit;
    visit.window = first_window++;
    visit.position = {lon, 25.0};
    pathlet.visits.push_back(visit);
  }
  return pathlet;
}

TEST(StabilityTest, APlanIsAsStableAsItsWindowsThatStay) {
  const PlanStability found = ComputeStability(
      {Path("a", 0, {-90, -91, -92}), Path("b", 0, {-80, -81, -82})},
      {Path("b", 0, {-80, -81, -82}), Path("a", 0, {-90, -91, -92.5})});
  EXPECT_DOUBLE_EQ(found.share, 5.0 / 6.0);
  EXPECT_DOUBLE_EQ(found.displacement_m,
                   kg_base::Distance_m({-92, 25}, {-92.5, 25}) / 6.0);
}

TEST(StabilityTest, OnlyWindowsThatBothHaveCount) {
  const PlanStability found =
      ComputeStability({Path("a", 0, {-90, -91}), Path("gone", 0, {-80, -81})},
                       {Path("a", 1, {-91, -95}), Path("new", 1, {-70, -71})});
  EXPECT_EQ(found.share, 1.0);
  EXPECT_EQ(found.displacement_m, 0.0);
}

TEST(StabilityTest, AMetreIsTheSamePlaceAndALittleMoreIsNot) {
  const double metre_deg = 1.0 / kg_base::Distance_m({-90, 25}, {-89, 25});
  for (const double metres : {0.9, 1.1}) {
    const PlanStability found = ComputeStability(
        {Path("a", 0, {-90})}, {Path("a", 0, {-90 + metres * metre_deg})});
    EXPECT_EQ(found.share, metres < 1.0 ? 1.0 : 0.0);
    EXPECT_NEAR(found.displacement_m, metres, 1e-3);
  }
}

TEST(StabilityTest, IsUndefinedWithoutCommonWindows) {
  for (const auto& before :
       {std::vector<Pathlet>(), std::vector<Pathlet>{Path("b", 0, {-90})}}) {
    const PlanStability found = ComputeStability(before, {Path("a", 0, {-90})});
    EXPECT_TRUE(std::isnan(found.share));
    EXPECT_TRUE(std::isnan(found.displacement_m));
  }
}

}  // namespace
}  // namespace kg_selector
