#include "kg_base/raster/unit_conversion.h"

#include <gtest/gtest.h>

namespace kg_base {
namespace {

void ExpectScale(const std::string& from, const std::string& to, double scale,
                 double offset = 0.0) {
  const std::optional<UnitScale> found = ConvertUnit(from, to);
  ASSERT_TRUE(found) << from;
  EXPECT_NEAR(found->scale, scale, 1e-12 * scale) << from;
  EXPECT_NEAR(found->offset, offset, 1e-9) << from;
}

TEST(ConvertUnit, ReadsSpeedsInAnySpelling) {
  for (const char* unit :
       {"m/s", "m s-1", "m s**-1", "m s^-1", "m.s-1", "ms-1", "meter/sec",
        "meters/second", "meter second-1", "m/sec", "meter s-1",
        "meters per second", "metre second-1", "0.001 km/s"}) {
    ExpectScale(unit, "m s-1", 1.0);
  }
  ExpectScale("cm/s", "m s-1", 0.01);
  ExpectScale("centimeter per second", "m s-1", 0.01);
  ExpectScale("km/h", "m s-1", 1.0 / 3.6);
  ExpectScale("knots", "m s-1", 1852.0 / 3600.0);
  ExpectScale("kt", "m s-1", 1852.0 / 3600.0);
}

TEST(ConvertUnit, ReadsTemperaturesWithTheirOffset) {
  for (const char* unit :
       {"degC", "degree_C", "degrees_C", "degree_Celsius", "degrees_Celsius",
        "degree Celsius", "degrees Celsius", "Celsius", "celsius", "degrees C",
        "deg C", "C", "deg_C"}) {
    ExpectScale(unit, "degC", 1.0);
  }
  for (const char* unit : {"K", "kelvin", "Kelvin", "degrees_K", "degK"}) {
    ExpectScale(unit, "degC", 1.0, -273.15);
  }
  ExpectScale("degF", "degC", 5.0 / 9.0, -160.0 / 9.0);
}

TEST(ConvertUnit, ReadsLengthsPressuresAndTimes) {
  ExpectScale("feet", "m", 0.3048);
  ExpectScale("metres", "m", 1.0);
  ExpectScale("millibars", "Pa", 100.0);
  ExpectScale("hPa", "Pa", 100.0);
  ExpectScale("microseconds", "s", 1e-6);
  ExpectScale("hrs", "s", 3600.0);
}

TEST(ConvertUnit, RefusesOtherQuantitiesAndNonsense) {
  for (const char* unit : {"", "furlong", "s", "m", "1", "degC", "nonsense",
                           "m s-2", "m/s/", "count"}) {
    EXPECT_FALSE(ConvertUnit(unit, "m s-1")) << unit;
  }
  EXPECT_FALSE(ConvertUnit("lg(re 1 mW)", "W"));
  EXPECT_FALSE(ConvertUnit(std::string(1000, 'm'), "m"));
}

}  // namespace
}  // namespace kg_base
