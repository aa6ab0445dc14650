#include "kg_base/raster/field_values.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kg_base/raster/testing/made_file.h"
#include "kg_base/raster/time_steps.h"

namespace kg_base {
namespace {

using testing::HasSubstr;

// A raster called reef, half of it `fill`, with further attributes.
void WriteMask(MadeFile& file, double fill, const AttributeTexts& texts,
               const netCDF::NcType& type = netCDF::ncDouble) {
  file.Box();
  std::vector<double> values(15, 1.0);
  for (int i = 0; i < 7; ++i) values[i] = fill;
  file.Put("reef", {"lat", "lon"}, values, texts, type);
}

std::size_t CountMissing(const Raster& raster) {
  std::size_t count = 0;
  for (const float value : raster) count += std::isnan(value);
  return count;
}

TEST(FillValues, ReadsFillsThatAreText) {
  for (const char* text :
       {"-9999", "-9999.0", "-9.999e3", "0 -9999", "-9999.f"}) {
    MadeFile file;
    WriteMask(file, -9999, {{"missing_value", text}});
    const FieldFile read = file.ReadNamed("reef");
    EXPECT_EQ(CountMissing(read.series[0].at_time[0]), 7u) << text;
    EXPECT_EQ(read.series[0].report.cells_without_data, 7u);
  }
  MadeFile file;
  WriteMask(file, -9999, {{"missing_value", "land"}});
  EXPECT_THAT(InputErrorOf([&] { file.ReadNamed("reef"); }),
              HasSubstr("missing_value: \"land\" is no number"));
}

TEST(FillValues, ReadsFillsOfAnotherPrecision) {
  const auto missing = [](double fill, const netCDF::NcType& type,
                          const netCDF::NcType& attribute_type,
                          double attribute) {
    MadeFile file;
    file.Box();
    std::vector<double> values(15, 1.0);
    values[3] = fill;
    const netCDF::NcVar mask =
        file.Put("reef", {"lat", "lon"}, values, {}, type);
    mask.putAtt("missing_value", attribute_type, attribute);
    return CountMissing(file.ReadNamed("reef").series[0].at_time[0]);
  };
  const double single = static_cast<float>(-9999.9);
  EXPECT_EQ(missing(single, netCDF::ncDouble, netCDF::ncDouble, -9999.9), 1u);
  EXPECT_EQ(missing(-9999.9, netCDF::ncDouble, netCDF::ncFloat, -9999.9), 1u);
  EXPECT_EQ(missing(1e20, netCDF::ncFloat, netCDF::ncDouble, 1e20), 1u);
  EXPECT_EQ(missing(1e20f, netCDF::ncDouble, netCDF::ncDouble, 1e20), 1u);
  EXPECT_EQ(missing(9.96921e36, netCDF::ncDouble, netCDF::ncDouble,
                    9.969209968386869e36),
            1u);
  // Integers are exact, and near values are values.
  EXPECT_EQ(missing(2147483646, netCDF::ncInt, netCDF::ncInt, 2147483647), 0u);
  EXPECT_EQ(missing(-9999.8, netCDF::ncDouble, netCDF::ncDouble, -9999.9), 0u);
}

TEST(FillValues, RefusesFillsThatTheFileDoesNotDeclare) {
  for (const double fill : {-9999.0, -999.0, 1e20, 9999.0, -32768.0}) {
    MadeFile file;
    WriteMask(file, fill, {});
    EXPECT_THAT(InputErrorOf([&] { file.ReadNamed("reef"); }),
                HasSubstr("is far beyond all others (at most 1)"));
  }
  MadeFile currents;
  currents.Times({0});
  currents.Box();
  std::vector<double> values(15, -9999.0);
  values[0] = 0.1;
  currents.Currents({"time", "lat", "lon"}, values);
  EXPECT_THAT(currents.Refusal(), HasSubstr("-9999 in 14 of them"));
}

TEST(ReadSeries, TellsOfValuesThatAreTakenAsNoData) {
  MadeFile file;
  file.Times({0});
  file.Box();
  std::vector<double> values(15, 0.1);
  values[4] = 11.0;
  file.Currents({"time", "lat", "lon"}, values);
  const FieldFile read = file.Read();
  EXPECT_THAT(WarningsOf(read), HasSubstr("1 values are impossible"));
  EXPECT_THAT(WarningsOf(read), HasSubstr("11 in 1 of them"));
  EXPECT_EQ(read.series[0].report.impossible_values, 1u);
  EXPECT_THAT(WarningsOf(read), HasSubstr("a fill must be declared"));
}

TEST(ReadSeries, SaysWhereTheFirstImpossibleValueIs) {
  MadeFile file;
  file.Times({0, 6});
  file.Box();
  std::vector<double> values(30, 0.1);
  values[15 + 5 + 3] = -9999;
  file.Currents({"time", "lat", "lon"}, values);
  EXPECT_THAT(
      WarningsOf(file.Read()),
      HasSubstr("the first at -97.7 E, 21.1 N at 2020-11-01T06:00:00Z"));
}

// A spike of a current is reported; a cell of ground that burns is none.
TEST(ReadSeries, ReportsOutliersOfQuantitiesThatHaveNoSpikes) {
  const auto read = [](const char* standard_name, FieldQuantity quantity) {
    MadeFile file;
    file.Times({0});
    file.Lat({21, 21.1, 21.2, 21.3, 21.4});
    file.Lon();
    std::vector<double> values;
    for (int i = 0; i < 25; ++i) values.push_back(0.01 * (i % 7));
    values[12] = 4.0;
    file.Put(
        "x", {"time", "lat", "lon"}, values,
        {{"standard_name", standard_name},
         {"units", quantity == FieldQuantity::kTemperature ? "degC" : "m/s"}});
    return file.Read({quantity});
  };
  const FieldFile current =
      read("eastward_sea_water_velocity", FieldQuantity::kEastwardVelocity);
  EXPECT_EQ(current.series[0].report.outliers, 1u);
  EXPECT_THAT(WarningsOf(current), HasSubstr("4 at -97.8 E, 21.2 N"));
  EXPECT_EQ(current.series[0].at_time[0][12], 4.0f);
  const FieldFile fire =
      read("surface_temperature", FieldQuantity::kTemperature);
  EXPECT_EQ(fire.series[0].report.outliers, 0u);
  EXPECT_EQ(WarningsOf(fire), "");
}

TEST(ReadSeries, ReportsMissingTimesAndTheStep) {
  MadeFile file;
  file.Times({0, 6, 12, 30, 36});
  file.Box();
  file.Currents({"time", "lat", "lon"},
                MadeFile::Repeated({0.1, 0.2, 0.3, 0.4, 0.5}));
  const FieldFile read = file.Read();
  EXPECT_EQ(read.series[0].report.times,
            "5 times, 2020-11-01T00:00:00Z to 2020-11-02T12:00:00Z, every 6 h");
  EXPECT_THAT(WarningsOf(read),
              HasSubstr("2 times are missing, the first between "
                        "2020-11-01T12:00:00Z and 2020-11-02T06:00:00Z"));
}

TEST(ReadSeries, ReadsUnsignedShortsOfAClassicFile) {
  MadeFile file;
  file.Times({0});
  file.Box();
  for (const char* direction : {"east", "north"}) {
    // 40050 as a signed short; the fill 65535 likewise.
    std::vector<double> packed(15, 40050.0 - 65536.0);
    packed[2] = -1;
    const netCDF::NcVar field = file.Put(
        direction, {"time", "lat", "lon"}, packed,
        {{"units", "m s-1"},
         {"standard_name", direction + std::string("ward_sea_water_velocity")},
         {"_Unsigned", "true"}},
        netCDF::ncShort);
    field.putAtt("scale_factor", netCDF::ncDouble, 0.001);
    field.putAtt("add_offset", netCDF::ncDouble, -40.0);
    field.putAtt("missing_value", netCDF::ncShort, -1);
  }
  const Raster raster = file.Read().series[0].at_time[0];
  EXPECT_NEAR(raster[0], 0.05, 1e-6);
  EXPECT_TRUE(std::isnan(raster[2]));
}

TEST(ReadSeries, ReadsUnitsInLatin1) {
  MadeFile file;
  file.Times({0});
  file.Box();
  file.Put("sst", {"time", "lat", "lon"}, MadeFile::Repeated({20}),
           {{"units",
             "\xb0"
             "C"},
            {"standard_name", "sea_surface_temperature"}});
  const FieldFile read = file.Read({FieldQuantity::kTemperature});
  EXPECT_EQ(read.series[0].at_time[0][0], 20.0f);
  EXPECT_THAT(read.series[0].report.unit, HasSubstr("\xc2\xb0"
                                                    "C"));
}

TEST(ReadSeries, ConvertsUnitsAndTellsWhatItAssumed) {
  const auto read = [](const AttributeTexts& units) {
    MadeFile file;
    file.Times({0});
    file.Box();
    AttributeTexts texts = units;
    texts["standard_name"] = "eastward_sea_water_velocity";
    file.Put("u", {"time", "lat", "lon"}, MadeFile::Repeated({1.8}), texts);
    return file.Read({FieldQuantity::kEastwardVelocity});
  };
  const FieldFile hours = read({{"units", "km/h"}});
  EXPECT_NEAR(hours.series[0].at_time[0][0], 0.5, 1e-6);
  EXPECT_EQ(hours.series[0].report.unit, "km/h, converted to m/s");
  EXPECT_EQ(WarningsOf(hours), "");
  const FieldFile none = read({});
  EXPECT_FLOAT_EQ(none.series[0].at_time[0][0], 1.8f);
  EXPECT_THAT(WarningsOf(none), HasSubstr("has no unit: taken as m/s"));
}

TEST(ReadSeries, KeepsTimesWithoutDataAndTellsOfThem) {
  for (const std::size_t empty : {0, 1, 2}) {
    MadeFile file;
    file.Times();
    file.Box();
    std::vector<double> speeds{0.1, 0.2, 0.3};
    speeds[empty] = NAN;
    file.Currents({"time", "lat", "lon"}, MadeFile::Repeated(speeds));
    const FieldFile read = file.Read();
    EXPECT_EQ(CountMissing(read.series[0].at_time[empty]), 15u);
    EXPECT_THAT(
        WarningsOf(read),
        HasSubstr("no value in any cell at 1 of 3 times, the first is " +
                  TimeText(read.time_s[empty])));
  }
}

// Chunks along time are read in blocks; the result is that of single steps.
TEST(ReadSeries, ReadsTheSameFromChunksOfAnyShape) {
  const std::vector<double> hours{0, 1, 2, 3, 4, 5, 6};
  std::vector<double> values;
  for (int i = 0; i < 7 * 15; ++i) values.push_back(0.001 * i);
  for (const std::vector<std::size_t>& chunks :
       std::vector<std::vector<std::size_t>>{
           {1, 3, 5}, {3, 2, 2}, {7, 1, 1}, {5, 3, 5}}) {
    MadeFile file;
    file.Times(hours);
    file.Box();
    file.ChunkedCurrents({"time", "lat", "lon"}, values, chunks);
    const FieldFile read = file.Read();
    ASSERT_EQ(read.series[0].at_time.size(), 7u);
    for (int i = 0; i < 7 * 15; ++i) {
      ASSERT_FLOAT_EQ(read.series[0].at_time[i / 15][i % 15], 0.001f * i);
    }
  }
}

}  // namespace
}  // namespace kg_base
