#include "kg_engine/simulation/track_position.h"

#include "gtest/gtest.h"

namespace kg_engine {
namespace {

TEST(TrackPosition, APositionLiesBetweenItsNeighboursInTime) {
  const std::vector<kg_compiler::TimedPoint> track = {{{-90.0, 25.0}, 100.0},
                                                      {{-89.0, 26.0}, 200.0}};
  EXPECT_EQ(PositionAt(track, 50.0), (kg_base::LonLat{-90.0, 25.0}));
  EXPECT_EQ(PositionAt(track, 250.0), (kg_base::LonLat{-89.0, 26.0}));
  EXPECT_NEAR(PositionAt(track, 125.0).lon_deg, -89.75, 1e-12);
  EXPECT_NEAR(PositionAt(track, 125.0).lat_deg, 25.25, 1e-12);
}

}  // namespace
}  // namespace kg_engine
