#include "kg_base/geo/map_projection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "kg_base/geo/geodesy.h"

namespace kg_base {
namespace {

TEST(MapProjection, GoesThereAndBack) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> lat(-80, 80);
  std::uniform_real_distribution<double> lon(-180, 180);
  for (int i = 0; i < 1000; ++i) {
    const MapProjection map({lon(random), lat(random)});
    const LonLat position{lon(random), lat(random)};
    const LonLat back = map.Inverse(map.Forward(position));
    EXPECT_NEAR(std::remainder(back.lon_deg - position.lon_deg, 360), 0, 1e-11);
    EXPECT_NEAR(back.lat_deg, position.lat_deg, 1e-11);
    EXPECT_TRUE(back.lon_deg >= -180.0 && back.lon_deg < 180.0);
  }
}

TEST(MapProjection, PutsTheCentreAtTheOriginEastAlongXAndNorthAlongY) {
  const MapProjection map({-90, 25});
  EXPECT_EQ(map.Forward({-90, 25}).x_m, 0.0);
  EXPECT_EQ(map.Forward({-90, 25}).y_m, 0.0);
  EXPECT_GT(map.Forward({-89, 25}).x_m, 0.0);
  EXPECT_EQ(map.Forward({-89, 25}).y_m, 0.0);
  EXPECT_GT(map.Forward({-90, 26}).y_m, 0.0);
}

TEST(MapProjection, IsTrueToScaleAtItsCentre) {
  const LonLat centre{-90, 25};
  const MapProjection map(centre);
  for (const double bearing_rad : {0.0, 0.7, 1.6, 2.9, 4.4}) {
    const MapPoint p = map.Forward(Destination(centre, bearing_rad, 100.0));
    EXPECT_NEAR(std::hypot(p.x_m, p.y_m), 100.0, 2e-3);
    EXPECT_NEAR(p.x_m, 100.0 * std::sin(bearing_rad), 2e-3);
  }
}

TEST(MapProjection, IsTrueToScaleAlongTheCentralParallelOnTheEquator) {
  const MapProjection map({-90, 0});
  EXPECT_NEAR(map.Forward({-80, 0}).x_m, Distance_m({-90, 0}, {-80, 0}), 1e-6);
}

TEST(MapProjection, TakesTheShortWayAcrossTheAntimeridian) {
  const MapProjection map({179.5, 10});
  EXPECT_NEAR(map.Forward({-179.5, 10}).x_m, -map.Forward({178.5, 10}).x_m,
              1e-6);
  EXPECT_NEAR(map.Inverse(map.Forward({-179.5, 10})).lon_deg, -179.5, 1e-9);
}

}  // namespace
}  // namespace kg_base
