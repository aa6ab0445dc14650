#include "kg_base/geo/geodesy.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "kg_base/common/units.h"

namespace kg_base {
namespace {

constexpr double kA = 6378137.0;
constexpr double kF = 1.0 / 298.257223563;

double Dms(double degrees, double minutes, double seconds) {
  return degrees + minutes / 60.0 + seconds / 3600.0;
}

// T. Vincenty, Direct and Inverse Solutions of Geodesics on the Ellipsoid,
// Survey Review 23 (1975): the inverse by iteration, an independent method.
double VincentyDistance_m(LonLat from, LonLat to) {
  const double b = kA * (1.0 - kF);
  const double u1 = std::atan((1.0 - kF) * std::tan(DegToRad(from.lat_deg)));
  const double u2 = std::atan((1.0 - kF) * std::tan(DegToRad(to.lat_deg)));
  const double l = DegToRad(to.lon_deg - from.lon_deg);
  double lambda = l;
  double sin_sigma = 0, cos_sigma = 0, sigma = 0, cos_sq_alpha = 0, cos_2m = 0;
  for (int i = 0; i < 100; ++i) {
    sin_sigma = std::hypot(std::cos(u2) * std::sin(lambda),
                           std::cos(u1) * std::sin(u2) -
                               std::sin(u1) * std::cos(u2) * std::cos(lambda));
    cos_sigma = std::sin(u1) * std::sin(u2) +
                std::cos(u1) * std::cos(u2) * std::cos(lambda);
    sigma = std::atan2(sin_sigma, cos_sigma);
    const double sin_alpha =
        std::cos(u1) * std::cos(u2) * std::sin(lambda) / sin_sigma;
    cos_sq_alpha = 1.0 - sin_alpha * sin_alpha;
    cos_2m = cos_sigma - 2.0 * std::sin(u1) * std::sin(u2) / cos_sq_alpha;
    const double c = kF / 16 * cos_sq_alpha * (4 + kF * (4 - 3 * cos_sq_alpha));
    lambda = l + (1 - c) * kF * sin_alpha *
                     (sigma +
                      c * sin_sigma *
                          (cos_2m + c * cos_sigma * (2 * cos_2m * cos_2m - 1)));
  }
  const double u_sq = cos_sq_alpha * (kA * kA - b * b) / (b * b);
  const double big_a =
      1 + u_sq / 16384 * (4096 + u_sq * (-768 + u_sq * (320 - 175 * u_sq)));
  const double big_b =
      u_sq / 1024 * (256 + u_sq * (-128 + u_sq * (74 - 47 * u_sq)));
  const double delta =
      big_b * sin_sigma *
      (cos_2m + big_b / 4 *
                    (cos_sigma * (2 * cos_2m * cos_2m - 1) -
                     big_b / 6 * cos_2m * (4 * sin_sigma * sin_sigma - 3) *
                         (4 * cos_2m * cos_2m - 3)));
  return b * big_a * (sigma - delta);
}

TEST(Geodesy, MeasuresFlindersPeakToBuninyongAsTheSurveyDid) {
  const LonLat flinders{Dms(144, 25, 29.52440), -Dms(37, 57, 3.72030)};
  const LonLat buninyong{Dms(143, 55, 35.38390), -Dms(37, 39, 10.15610)};
  EXPECT_NEAR(Distance_m(flinders, buninyong), 54972.271, 1e-3);
  EXPECT_NEAR(Bearing_rad(flinders, buninyong), DegToRad(Dms(306, 52, 5.37)),
              DegToRad(0.01 / 3600));
}

// Test data of C. F. F. Karney, Algorithms for geodesics (2013).
TEST(Geodesy, AgreesWithKarneysTestSet) {
  const LonLat a{-139.44815, 35.60777};
  const LonLat b{-69.95921, -11.17491};
  EXPECT_NEAR(Distance_m(a, b), 8935244.5604818305, 1e-6);
  EXPECT_NEAR(RadToDeg(Bearing_rad(a, b)), 111.098748429560326, 1e-11);
  const LonLat c{106.05087, 55.52454};
  const LonLat d{197.18234, 77.03196};
  EXPECT_NEAR(Distance_m(c, d), 4105086.1713924406, 1e-6);
  EXPECT_NEAR(RadToDeg(Bearing_rad(c, d)), 22.020059880982801, 1e-11);
}

TEST(Geodesy, AgreesWithVincentyOnRandomPairs) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> lat(-80, 80);
  std::uniform_real_distribution<double> lon(-60, 60);
  for (int i = 0; i < 500; ++i) {
    const LonLat a{lon(random), lat(random)};
    const LonLat b{lon(random), lat(random)};
    EXPECT_NEAR(Distance_m(a, b), VincentyDistance_m(a, b), 1e-3);
  }
}

TEST(Geodesy, TheEquatorIsACircleAndTheMeridianAQuarterIsKnown) {
  EXPECT_NEAR(Distance_m({-97, 0}, {-96, 0}), kA * kPi / 180, 1e-7);
  EXPECT_NEAR(Distance_m({-97, 0}, {-97, 90}), 10001965.729, 1e-3);
}

TEST(Geodesy, BearingsAreClockwiseFromNorth) {
  const LonLat here{-97, 22};
  EXPECT_EQ(Bearing_rad(here, {-97, 23}), 0.0);
  EXPECT_NEAR(Bearing_rad({-97, 0}, {-96, 0}), kPi / 2, 1e-12);
  EXPECT_NEAR(Bearing_rad(here, {-97, 21}), kPi, 1e-12);
  EXPECT_NEAR(Bearing_rad({-97, 0}, {-98, 0}), 1.5 * kPi, 1e-12);
}

TEST(Geodesy, BearingsStayBelowATurn) {
  const double bearing = Bearing_rad({0, 0}, {-1e-300, 80});
  EXPECT_GE(bearing, 0.0);
  EXPECT_LT(bearing, 2 * kPi);
  EXPECT_FALSE(std::signbit(bearing));
}

TEST(Geodesy, DestinationLeadsWhereDistanceAndBearingSay) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> lat(-80, 80);
  std::uniform_real_distribution<double> lon(-180, 180);
  std::uniform_real_distribution<double> bearing(0, 2 * kPi);
  std::uniform_real_distribution<double> distance(1, 5e6);
  for (int i = 0; i < 500; ++i) {
    const LonLat from{lon(random), lat(random)};
    const double way_m = distance(random);
    const double course = bearing(random);
    const LonLat to = Destination(from, course, way_m);
    EXPECT_NEAR(Distance_m(from, to), way_m, 1e-6);
    EXPECT_NEAR(std::remainder(Bearing_rad(from, to) - course, 2 * kPi), 0.0,
                1e-6);
    EXPECT_GE(to.lon_deg, -180.0);
    EXPECT_LT(to.lon_deg, 180.0);
  }
}

TEST(Geodesy, DestinationOnTheAntimeridianIsWest180) {
  const LonLat to = Destination({179, 0}, kPi / 2, kA * kPi / 180);
  EXPECT_NEAR(std::abs(to.lon_deg), 180.0, 1e-9);
  EXPECT_LT(to.lon_deg, 180.0);
}

TEST(Geodesy, LocalScaleIsTheLimitOfShortGeodesics) {
  for (const double lat : {-75.0, -22.0, 0.0, 22.0, 45.0, 89.0}) {
    const DegreesPerMetre scale = LocalScale(lat);
    const double h = 1e-4;
    const double east_m = Distance_m({10 - h, lat}, {10 + h, lat});
    const double north_m = Distance_m({10, lat - h}, {10, lat + h});
    EXPECT_NEAR(east_m * scale.lon_deg / (2 * h), 1.0, 1e-8) << lat;
    EXPECT_NEAR(north_m * scale.lat_deg / (2 * h), 1.0, 1e-8) << lat;
  }
}

TEST(Geodesy, NanInNanOut) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(Distance_m({nan, 0}, {0, 0})));
  EXPECT_TRUE(std::isnan(Bearing_rad({0, nan}, {0, 0})));
  EXPECT_TRUE(std::isnan(LocalScale(nan).lat_deg));
}

}  // namespace
}  // namespace kg_base
