#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <stdexcept>

#include "kg_base/raster/read_field_file.h"
#include "kg_base/raster/testing/field_test_file.h"

namespace kg_base {
namespace {

constexpr double kEpoch2000_s = 946684800.0;

FieldFile Read(const TestFile& spec) {
  const TempFile file(spec);
  return ReadFieldFile(file.path(), BothVelocities());
}

std::string Refusal(const TestFile& spec) {
  return InputErrorOf([&] { Read(spec); });
}

void ExpectRefused(const TestFile& spec, const std::string& because) {
  const std::string error = Refusal(spec);
  EXPECT_NE(error.find(because), std::string::npos) << error;
  EXPECT_NE(error.find("file.nc: "), std::string::npos) << error;
  EXPECT_EQ(error.find('\n'), std::string::npos) << error;
}

// The canonical contents are independent of the form of the file.
void ExpectCanonical(const FieldFile& file, std::size_t times = 3) {
  const std::vector<double> lon{-98, -97.9, -97.8, -97.7};
  const std::vector<double> lat{21, 21.1, 21.25};
  ASSERT_TRUE(Grid(lon, lat).AlmostEquals(file.grid, 1e-6));
  ASSERT_EQ(file.time_s.size(), times);
  ASSERT_EQ(file.series.size(), 2u);
  for (std::size_t t = 0; t < times; ++t) {
    const double hours = 10.0 + 5.0 * t;
    EXPECT_EQ(file.time_s[t], kEpoch2000_s + hours * 3600.0);
    for (std::size_t i = 0; i < file.grid.size(); ++i) {
      const double expected = TestSpeed(lon[i % 4], lat[i / 4], hours, 0.0);
      const float east = file.series[0].at_time[t][i];
      const float north = file.series[1].at_time[t][i];
      if (i == 0) {
        EXPECT_TRUE(std::isnan(east) && std::isnan(north));
      } else {
        EXPECT_NEAR(east, expected, 1e-6) << t << " " << i;
        EXPECT_NEAR(north, -expected, 1e-6) << t << " " << i;
      }
    }
  }
}

TEST(ReadFieldFile, ReadsEveryFormatPackingAndFill) {
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA, NC_NETCDF4}) {
    for (const bool packed : {true, false}) {
      for (const Fill fill :
           {Fill::kAttribute, Fill::kFloatAttribute, Fill::kMissingValue,
            Fill::kDefault, Fill::kNan}) {
        if (packed && fill == Fill::kNan) continue;
        TestFile spec;
        spec.format = format;
        spec.packed = packed;
        spec.fill = fill;
        SCOPED_TRACE(testing::Message() << format << packed << int(fill));
        ExpectCanonical(Read(spec));
      }
    }
  }
}

TEST(ReadFieldFile, ReadsDimensionsInAnyOrder) {
  std::string order = "txyz";
  int orders = 0;
  do {
    TestFile spec;
    spec.order = order;
    SCOPED_TRACE(order);
    ExpectCanonical(Read(spec));
    ++orders;
  } while (std::next_permutation(order.begin(), order.end()));
  EXPECT_EQ(orders, 24);
}

TEST(ReadFieldFile, ReadsWithoutDepthAndWithoutTimeDimension) {
  TestFile spec;
  spec.order = "tyx";
  ExpectCanonical(Read(spec));
  spec.order = "yx";
  spec.time = {10};
  ExpectCanonical(Read(spec), 1);
}

TEST(ReadFieldFile, TakesTheShallowestLevelWherever) {
  TestFile spec;
  spec.depth = {20, 0, 10};
  ExpectCanonical(Read(spec));
}

TEST(ReadFieldFile, TurnsAxesIntoCanonicalOrder) {
  TestFile spec;
  std::reverse(spec.lat.begin(), spec.lat.end());
  ExpectCanonical(Read(spec));
  std::reverse(spec.lon.begin(), spec.lon.end());
  ExpectCanonical(Read(spec));
  for (double& lon : spec.lon) lon += 360;
  ExpectCanonical(Read(spec));
}

TEST(ReadFieldFile, ReadsRecordsOfAnUnlimitedTime) {
  TestFile spec;
  spec.records = true;
  ExpectCanonical(Read(spec));
  spec.format = NC_NETCDF4;
  ExpectCanonical(Read(spec));
}

TEST(ReadFieldFile, GoesByAttributesFirstAndNamesSecond) {
  TestFile spec;
  spec.east_name = "ugo";
  ExpectCanonical(Read(spec));
  spec.east_name = "U";
  spec.east_standard = "";
  ExpectCanonical(Read(spec));
  spec.coordinate_attributes = false;
  spec.lon_name = "Longitude";
  spec.lat_name = "Latitude";
  ExpectCanonical(Read(spec));
  spec.east_name = "u";
  spec.east_standard = "eastward_wind";
  ExpectRefused(spec, "expected both of sea water or both of wind");
}

// A file of wind components.
TestFile WindFile() {
  TestFile spec;
  spec.east_name = "u10";
  spec.east_standard = "eastward_wind";
  spec.north_standard = "northward_wind";
  return spec;
}

TEST(ReadFieldFile, ReadsTheWindByItsStandardNames) {
  const FieldFile file = Read(WindFile());
  ExpectCanonical(file);
  EXPECT_TRUE(IsWindName(file.series[0].standard_name));
  EXPECT_EQ(file.series[0].variable, "u10");
  EXPECT_EQ(file.series[0].standard_name, "eastward_wind");
  EXPECT_FALSE(IsWindName(Read(TestFile()).series[0].standard_name));
}

TEST(ReadFieldFile, AcceptsHigherSpeedsOfWindThanOfWater) {
  TestFile spec = WindFile();
  spec.packed = false;
  spec.all_value = 35.0;
  EXPECT_EQ(Read(spec).series[0].at_time[0][5], 35.0f);
  spec.all_value = 150.0;
  ExpectRefused(spec, "variable u10: most values are impossible");
}

TEST(ReadFieldFile, RefusesHalfOfTheSeaAndHalfOfTheWind) {
  TestFile spec = WindFile();
  spec.north_standard = "northward_sea_water_velocity";
  ExpectRefused(spec,
                "variables u10 (eastward_wind) and water_v "
                "(northward_sea_water_velocity): expected both of sea water "
                "or both of wind");
}

TEST(ReadFieldFile, ReadsTheTemperatureOfAirAndOfBurningGround) {
  TestFile spec;
  spec.packed = false;
  spec.east_name = "anything";
  spec.speed_units = "K";
  const auto read = [&](const char* standard_name, double kelvin) {
    spec.east_standard = standard_name;
    spec.all_value = kelvin;
    const TempFile file(spec);
    return InputErrorOf([&] {
      const FieldFile read =
          ReadFieldFile(file.path(), {FieldQuantity::kTemperature});
      EXPECT_NEAR(read.series[0].at_time[0][5], kelvin - 273.15, 1e-3);
    });
  };
  EXPECT_EQ(read("surface_temperature", 900.0), "read");
  EXPECT_EQ(read("air_temperature", 230.0), "read");
  for (const char* not_so_hot :
       {"air_temperature", "sea_surface_temperature"}) {
    EXPECT_NE(read(not_so_hot, 900.0).find("most values are impossible"),
              std::string::npos);
  }
}

TEST(ReadFieldFile, SaysWhatIsMissingAndWhatItTried) {
  TestFile spec;
  spec.north = false;
  ExpectRefused(spec, "no variable for northward velocity");
  const std::string error = Refusal(spec);
  EXPECT_NE(error.find("northward_sea_water_velocity"), std::string::npos);
  EXPECT_NE(error.find("water_v, v, vo"), std::string::npos);
  EXPECT_EQ(error.find("eastward velocity"), std::string::npos);
}

TEST(ReadFieldFile, ConvertsUnitsAndAssumesSiWhereNoneIsNamed) {
  TestFile spec;
  spec.speed_units = "";
  ExpectCanonical(Read(spec));
  spec.speed_units = "cm s-1";
  spec.speed_factor = 100.0;
  spec.packed = false;
  ExpectCanonical(Read(spec));
  for (const std::string unit : {"nonsense", "m", "s-1", "degC", "m/s/"}) {
    spec.speed_units = unit;
    ExpectRefused(spec, "unit \"" + unit + "\" is not understood");
  }
}

TEST(ReadFieldFile, UnderstandsTheUsualTimeUnits) {
  TestFile spec;
  spec.time = {600, 900, 1200};
  for (const char* units :
       {"minutes since 2000-1-1", "min since 2000-01-01Z"}) {
    spec.time_units = units;
    const FieldFile file = Read(spec);
    EXPECT_EQ(file.time_s[0], kEpoch2000_s + 36000.0) << units;
  }
}

TEST(ReadFieldFile, KeepsTheNoiseOfRealTimes) {
  TestFile spec;
  spec.time = {10.0012, 15, 19.9991};
  const FieldFile file = Read(spec);
  EXPECT_NEAR(file.time_s[0], kEpoch2000_s + 10.0012 * 3600, 1e-6);
  EXPECT_NEAR(file.time_s[2], kEpoch2000_s + 19.9991 * 3600, 1e-6);
}

TEST(ReadFieldFile, RefusesTimesThatAreMissing) {
  TestFile spec;
  spec.time = {10, NAN, 30};
  ExpectRefused(spec, "variable time: value 1 is missing");
}

TEST(ReadFieldFile, RefusesTimesItDoesNotUnderstand) {
  TestFile spec;
  spec.calendar = "noleap";
  ExpectRefused(spec, "calendar \"noleap\"");
  spec.calendar = "";
  spec.time_units = "months since 2000-01-01";
  ExpectRefused(spec, "time unit \"months since 2000-01-01\"");
  spec.time_units = "hours";
  ExpectRefused(spec, "time unit \"hours\"");
}

TEST(ReadFieldFile, RefusesAxesThatDoNotRunOneWay) {
  TestFile spec;
  spec.lat = {21, 21.2, 21.1};
  ExpectRefused(spec, "variable lat: expected values that only ascend");
  spec.lat = {21, 21, 21.1};
  ExpectRefused(spec, "variable lat: expected values that only ascend");
  spec.lat = {21, NAN, 21.1};
  ExpectRefused(spec, "variable lat: value 1 is missing");
  spec.lat = {89, 90, 91};
  ExpectRefused(spec, "variable lat: expected degrees from -90 to 90");
  spec.lat = {21};
  ExpectRefused(spec, "variable lat: expected at least two values");
}

TEST(ReadFieldFile, RefusesCurvilinearGrids) {
  TestFile spec;
  spec.curvilinear = true;
  ExpectRefused(spec, "lies on a curvilinear grid (lat2 has two dimensions)");
}

TEST(ReadFieldFile, RefusesTheAntimeridianButTurnsGlobalGrids) {
  TestFile spec;
  spec.lon = {179, 180, 181, 182};
  ExpectRefused(spec, "the grid crosses the antimeridian");
  spec.lon = {0, 90, 180, 270, 400};
  ExpectRefused(spec, "span less than a turn");
  spec.lon = {0, 90, 180, 270};
  const FieldFile file = Read(spec);
  EXPECT_EQ(file.grid.lon_deg(), (std::vector<double>{-180, -90, 0, 90}));
  EXPECT_NEAR(file.series[0].at_time[0][file.grid.Index({1, 1})],
              TestSpeed(-90, 21.1, 10, 0), 1e-5);
}

TEST(ReadFieldFile, RefusesAllLand) {
  TestFile spec;
  spec.all_land = true;
  ExpectRefused(spec, "variable water_u: no value in any cell");
}

TEST(ReadFieldFile, MasksAbsurdValuesAndRefusesAbsurdVariables) {
  TestFile spec;
  spec.odd_value = -10.5;
  const FieldFile file = Read(spec);
  EXPECT_TRUE(std::isnan(file.series[0].at_time[0][11]));
  EXPECT_FALSE(std::isnan(file.series[0].at_time[1][11]));
  spec.all_value = 11;
  ExpectRefused(spec, "variable water_u: most values are impossible");
}

TEST(ReadFieldFile, TakesValidRangeForNoMask) {
  TestFile spec;
  spec.east_numbers = {{"valid_min", -1e-6}, {"valid_max", 1e-6}};
  ExpectCanonical(Read(spec));
}

TEST(ReadFieldFile, RefusesPackingThatMakesNoSense) {
  TestFile spec;
  for (const double scale : {0.0, double(NAN), double(INFINITY)}) {
    spec.east_numbers = {{"scale_factor", scale}};
    ExpectRefused(spec, "variable water_u: attribute scale_factor");
  }
}

TEST(ReadFieldFile, ReadsTemperatureInKelvinAndCelsius) {
  TestFile spec;
  spec.packed = false;
  spec.all_value = 293.15;
  spec.east_name = "anything";
  spec.east_standard = "sea_surface_temperature";
  spec.speed_units = "K";
  const TempFile kelvin(spec);
  const FieldFile file =
      ReadFieldFile(kelvin.path(), {FieldQuantity::kTemperature});
  EXPECT_NEAR(file.series[0].at_time[0][5], 20.0, 1e-4);
  EXPECT_EQ(file.series[0].variable, "anything");
  spec.speed_units = "degC";
  const TempFile lie(spec);
  const std::string error = InputErrorOf(
      [&] { ReadFieldFile(lie.path(), {FieldQuantity::kTemperature}); });
  EXPECT_NE(error.find("variable anything: most values are impossible"),
            std::string::npos);
}

TEST(ReadFieldFile, RefusesWhatIsNoNetcdfFile) {
  const TempFile file;
  const auto refusal = [&] {
    return InputErrorOf([&] { ReadFieldFile(file.path(), BothVelocities()); });
  };
  EXPECT_NE(refusal().find("expected a file that exists"), std::string::npos);
  file.Write("");
  EXPECT_NE(refusal().find("expected a NetCDF file"), std::string::npos);
  file.Write("lat,lon,u,v\n");
  EXPECT_NE(refusal().find("expected a NetCDF file"), std::string::npos);
  file.Write("CDF\1");
  EXPECT_NE(refusal().find("ends within its header"), std::string::npos);
  EXPECT_NE(InputErrorOf([] {
              ReadFieldFile("/tmp", BothVelocities());
            }).find("expected a file"),
            std::string::npos);
  EXPECT_THROW(ReadFieldFile(file.path(), {}), std::logic_error);
}

// Fraction of cells without data.
double LandShare(const Raster& raster) {
  const auto land = std::count_if(raster.begin(), raster.end(),
                                  [](float v) { return std::isnan(v); });
  return static_cast<double>(land) / static_cast<double>(raster.size());
}

TEST(ReadFieldFileReal, ReadsTheHindcastOff2020) {
  const std::string path =
      SharedData("gom_2020/currents_hycom_gomu_2020-11-01-15_5h.nc4");
  if (path.empty()) GTEST_SKIP() << "the shared data are not there";
  const FieldFile file = ReadFieldFile(path, BothVelocities());
  EXPECT_EQ(file.grid.rows(), 51);
  EXPECT_EQ(file.grid.cols(), 51);
  EXPECT_EQ(file.time_s.size(), 68u);
  EXPECT_NEAR(file.time_s[0], 1604232000.0, 10.0);  // 2020-11-01T12:00Z.
  EXPECT_NEAR(LandShare(file.series[0].at_time[0]), 0.19, 0.01);
  EXPECT_EQ(file.sha256.size(), 64u);
}

TEST(ReadFieldFileReal, ReadsTheBorrowedTemperatureOnTheSameGrid) {
  const std::string path =
      SharedData("gom_2020/sst_borrowed_2020-11-01-15_daily.nc");
  const std::string currents =
      SharedData("gom_2020/currents_hycom_gomu_2020-11-01-15_5h.nc4");
  if (path.empty()) GTEST_SKIP() << "the shared data are not there";
  const FieldFile file = ReadFieldFile(path, {FieldQuantity::kTemperature});
  EXPECT_EQ(file.time_s.size(), 15u);
  EXPECT_EQ(file.series[0].variable, "water_temp");
  EXPECT_TRUE(
      file.grid.AlmostEquals(ReadFieldFile(currents, BothVelocities()).grid));
}

TEST(ReadFieldFileReal, KeepsWaterThatAWrongValidRangeDenies) {
  const std::string path = SharedData("gom_2014/hycom_goml_tuv_2014-08-30.nc");
  if (path.empty()) GTEST_SKIP() << "the shared data are not there";
  const FieldFile file = ReadFieldFile(
      path, {FieldQuantity::kTemperature, FieldQuantity::kEastwardVelocity,
             FieldQuantity::kNorthwardVelocity});
  EXPECT_EQ(file.time_s, std::vector<double>{1409356800.0});
  EXPECT_EQ(file.grid.rows(), 56);
  const Raster& warm = file.series[0].at_time[0];
  EXPECT_EQ(LandShare(warm), 0.0);
  const auto above = std::count_if(warm.begin(), warm.end(),
                                   [](float t) { return t > 28.80272865f; });
  EXPECT_GT(above, 0);  // Outside the attribute's valid range.
  const std::vector<double>& lat = file.grid.lat_deg();
  EXPECT_GT(lat[1] - lat[0], lat[55] - lat[54]);
}

TEST(ReadFieldFileReal, NamesWhatTheUOnlyFileLacks) {
  const std::string path =
      SharedData("readers/hycom_native_names_u_only_2001.nc");
  if (path.empty()) GTEST_SKIP() << "the shared data are not there";
  const std::string error =
      InputErrorOf([&] { ReadFieldFile(path, BothVelocities()); });
  EXPECT_NE(error.find("no variable for northward velocity"),
            std::string::npos);
  EXPECT_EQ(error.find("eastward velocity"), std::string::npos);
  const FieldFile file =
      ReadFieldFile(path, {FieldQuantity::kEastwardVelocity});
  EXPECT_EQ(file.time_s, std::vector<double>{978350400.0});  // 2001-01-01T12Z.
  EXPECT_EQ(file.grid.rows(), 285);
}

}  // namespace
}  // namespace kg_base
