#include "kg_base/raster/coordinate_axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "kg_base/raster/testing/made_file.h"

namespace kg_base {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> Range(double from, double step, int count) {
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(from + step * i);
  return values;
}

std::vector<double> Joined(std::vector<double> a,
                           const std::vector<double>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Currents whose value is a hundredth of the column of the file.
void Write(MadeFile& file, const std::vector<double>& lon,
           const std::vector<double>& lat = {21, 21.1, 21.2}) {
  file.Times({0});
  file.Lat(lat);
  file.Lon(lon);
  std::vector<double> values;
  for (std::size_t row = 0; row < lat.size(); ++row) {
    for (std::size_t col = 0; col < lon.size(); ++col) {
      values.push_back(0.01 * col);
    }
  }
  file.Currents({"time", "lat", "lon"}, values);
}

FieldFile ReadColumns(const std::vector<double>& lon) {
  MadeFile file;
  Write(file, lon);
  return file.Read();
}

// The column of the file that is read at a longitude; -1: no data.
int ColumnAt(const FieldFile& file, double lon) {
  const auto cell = file.grid.CellAt({lon, 21.1});
  if (!cell) return -2;
  const float value = file.series[0].at_time[0][file.grid.Index(*cell)];
  return std::isnan(value) ? -1 : static_cast<int>(std::lround(100 * value));
}

TEST(LongitudeAxis, FillsTheHoleBetweenTilesWithCellsWithoutData) {
  for (const double hole : {2.0, 1.05, 2.8, 10.0}) {
    const std::vector<double> lon =
        Joined(Range(-97.5, 0.5, 6), Range(-95 + hole, 0.5, 6));
    const FieldFile file = ReadColumns(lon);
    EXPECT_EQ(ColumnAt(file, -95), 5) << hole;
    EXPECT_EQ(ColumnAt(file, -95 + hole / 2), -1) << hole;
    EXPECT_EQ(ColumnAt(file, -95 + hole), 6) << hole;
    EXPECT_THAT(WarningsOf(file), HasSubstr("lon has a hole from -95"));
    EXPECT_GT(file.series[0].report.cells_without_data, 0u);
  }
}

TEST(LongitudeAxis, ReadsARegionWhoseLastColumnIsAt180) {
  for (const double turn : {0.0, -360.0}) {
    // In single precision 180 may lie beyond itself.
    for (const double rounding : {0.0, 2e-5}) {
      std::vector<double> lon = Range(175 + turn, 0.5, 10);
      lon.push_back(180 + turn + rounding);
      const FieldFile file = ReadColumns(lon);
      EXPECT_EQ(file.grid.lon_deg().front(), 175);
      EXPECT_EQ(file.grid.lon_deg().back(), 180);
      EXPECT_EQ(ColumnAt(file, 180), 10);
      EXPECT_EQ(ColumnAt(file, 175), 0);
    }
  }
}

TEST(LongitudeAxis, ReadsARegionThatBeginsAt180) {
  const FieldFile file = ReadColumns(Range(180, 0.5, 10));
  EXPECT_EQ(file.grid.lon_deg().front(), -180);
  EXPECT_EQ(ColumnAt(file, -175.5), 9);
}

TEST(LongitudeAxis, RefusesARegionOnBothSidesOf180WithTheRemedy) {
  for (const std::vector<double>& lon :
       {Range(175, 0.5, 21), Joined(Range(175, 0.5, 10), Range(-180, 0.5, 10)),
        Range(-185, 0.5, 21)}) {
    MadeFile file;
    Write(file, lon);
    EXPECT_THAT(file.Refusal(), HasSubstr("crosses the antimeridian"));
    MadeFile again;
    Write(again, lon);
    EXPECT_THAT(again.Refusal(), HasSubstr("cdo sellonlatbox,175,180,-90,90"));
  }
}

TEST(LongitudeAxis, FillsARegionAcrossThePacificThatWasSorted) {
  const FieldFile file =
      ReadColumns(Joined(Range(-179.5, 1, 50), Range(130.5, 1, 50)));
  EXPECT_EQ(file.grid.cols(), 360);
  EXPECT_EQ(ColumnAt(file, 0), -1);
  EXPECT_EQ(ColumnAt(file, -179.5), 0);
  EXPECT_EQ(ColumnAt(file, 130.5), 50);
}

TEST(LatitudeAxis, FillsHolesUpwardsAndDownwards) {
  std::vector<double> lat = Joined(Range(20, 0.5, 4), Range(25, 0.5, 4));
  for (int turn = 0; turn < 2; ++turn) {
    MadeFile file;
    Write(file, {1, 2, 3, 4}, lat);
    const FieldFile read = file.Read();
    EXPECT_EQ(read.grid.rows(), 14);
    EXPECT_TRUE(std::isnan(read.series[0].at_time[0][5 * 4]));
    EXPECT_FALSE(std::isnan(read.series[0].at_time[0][3 * 4]));
    std::reverse(lat.begin(), lat.end());
  }
}

TEST(LongitudeAxis, LeavesStretchedAndFewColumnsAlone) {
  std::vector<double> stretched{0};
  double step = 0.1;
  for (int i = 0; i < 20; ++i) {
    stretched.push_back(stretched.back() + step);
    step *= 1.3;
  }
  for (const std::vector<double>& lon :
       {stretched, std::vector<double>{0, 1, 9},
        std::vector<double>{0, 1, 1.3, 2.3, 3.3}}) {
    const FieldFile file = ReadColumns(lon);
    EXPECT_EQ(file.grid.lon_deg().size(), lon.size());
    EXPECT_EQ(WarningsOf(file), "");
  }
}

TEST(LongitudeAxis, DropsColumnsThatAreThereTwice) {
  for (const int columns : {37, 38, 40}) {
    const FieldFile file = ReadColumns(Range(0, 10, columns));
    EXPECT_EQ(file.grid.cols(), 36);
    EXPECT_EQ(ColumnAt(file, 0), 0);
    EXPECT_EQ(ColumnAt(file, -10), 35);
    EXPECT_THAT(WarningsOf(file), HasSubstr("repeated columns"));
  }
  EXPECT_EQ(ReadColumns(Range(-180, 10, 37)).grid.cols(), 36);
}

TEST(LongitudeAxis, ReadsColumnsThatPassTheEndOfTheirRange) {
  // From 0 to 180, then from -170.
  const FieldFile global =
      ReadColumns(Joined(Range(0, 10, 18), Range(-180, 10, 18)));
  EXPECT_EQ(global.grid.cols(), 36);
  EXPECT_EQ(ColumnAt(global, -170), 19);
  const FieldFile greenwich = ReadColumns(Joined({358, 359}, {0, 1, 2}));
  EXPECT_EQ(greenwich.grid.cols(), 5);
  EXPECT_EQ(ColumnAt(greenwich, -1), 1);
  EXPECT_EQ(ColumnAt(greenwich, 0), 2);
}

TEST(ReadFieldAxes, RefusesRotatedAndProjectedGrids) {
  struct Case {
    AttributeTexts lat;
    AttributeTexts lon;
  };
  const std::vector<Case> cases = {
      {{{"standard_name", "grid_latitude"}, {"units", "degrees_north"}},
       {{"standard_name", "grid_longitude"}, {"units", "degrees_east"}}},
      {{{"standard_name", "grid_latitude"}, {"units", "degrees"}},
       {{"standard_name", "grid_longitude"}, {"units", "degrees"}}},
      {{{"long_name", "latitude in rotated pole grid"},
        {"units", "degrees_north"}},
       {{"long_name", "longitude in rotated pole grid"},
        {"units", "degrees_east"}}},
      {{{"standard_name", "projection_y_coordinate"}, {"units", "m"}},
       {{"standard_name", "projection_x_coordinate"}, {"units", "m"}}},
  };
  for (const Case& c : cases) {
    MadeFile file;
    file.Times({0});
    file.Axis("rlat", {1, 2, 3}, c.lat);
    file.Axis("rlon", {1, 2, 3, 4, 5}, c.lon);
    file.Currents({"time", "rlat", "rlon"}, MadeFile::Repeated({0.1}));
    EXPECT_THAT(file.Refusal(), HasSubstr("rotated or projected grid (rlat"));
  }
}

TEST(ReadFieldAxes, PrefersDegreesToAnIndexOfTheDimensionsName) {
  for (const AttributeTexts& index :
       {AttributeTexts{{"long_name", "column"}}, AttributeTexts{{"units", "1"}},
        AttributeTexts{}}) {
    for (const AttributeTexts& degrees :
         {AttributeTexts{{"units", "degrees_east"}},
          AttributeTexts{{"standard_name", "longitude"}}}) {
      MadeFile file;
      file.Times({0});
      file.Lat();
      file.Axis("lon", {0, 1, 2, 3, 4}, index, netCDF::ncInt);
      file.Put("longitude", {"lon"}, {-98, -97.9, -97.8, -97.7, -97.6},
               degrees);
      file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1}));
      EXPECT_EQ(file.Read().grid.lon_deg().front(), -98);
    }
  }
}

TEST(ReadFieldAxes, TellsOfAxesThatAreKnownByNameOnly) {
  MadeFile file;
  file.Times({0});
  file.Axis("lat", {21, 22, 23});
  file.Axis("lon", {0, 1, 2, 3, 4});
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1}));
  EXPECT_THAT(WarningsOf(file.Read()),
              HasSubstr("lon has neither standard_name nor units"));
}

TEST(ReadFieldAxes, ReadsCoordinatesOfTwoDimensionsOfARegularGrid) {
  for (const bool is_curved : {false, true}) {
    MadeFile file;
    file.Times({0});
    file.Dimension("y", 3);
    file.Dimension("x", 5);
    std::vector<double> lat, lon;
    for (int row = 0; row < 3; ++row) {
      for (int col = 0; col < 5; ++col) {
        lat.push_back(23 - row + (is_curved ? 0.1 * col : 0.0));
        lon.push_back(-98 + col);
      }
    }
    file.Put("nav_lat", {"y", "x"}, lat, {{"units", "degrees_north"}});
    file.Put("nav_lon", {"y", "x"}, lon, {{"units", "degrees_east"}});
    file.Currents({"time", "y", "x"}, Joined(Joined(std::vector<double>(5, 3),
                                                    std::vector<double>(5, 2)),
                                             std::vector<double>(5, 1)));
    if (is_curved) {
      EXPECT_THAT(file.Refusal(), HasSubstr("curvilinear grid (nav_lat"));
      continue;
    }
    const FieldFile read = file.Read();
    EXPECT_THAT(read.grid.lat_deg(), ElementsAre(21, 22, 23));
    EXPECT_THAT(read.grid.lon_deg(), ElementsAre(-98, -97, -96, -95, -94));
    EXPECT_EQ(read.series[0].at_time[0][0], 1.0f);
  }
}

TEST(ReadFieldAxes, UnpacksPackedAndUnsignedAxes) {
  MadeFile file;
  file.Times({0});
  file.Lat();
  file.Dimension("lon", 5);
  const netCDF::NcVar lon = file.Put(
      "lon", {"lon"}, {32766, 32767, -32768, -32767, -32766},
      {{"units", "degrees_east"}, {"_Unsigned", "true"}}, netCDF::ncShort);
  lon.putAtt("scale_factor", netCDF::ncDouble, 0.001);
  lon.putAtt("add_offset", netCDF::ncDouble, -100.0);
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1}));
  const FieldFile read = file.Read();
  EXPECT_NEAR(read.grid.lon_deg().front(), -67.234, 1e-9);
  EXPECT_NEAR(read.grid.lon_deg().back(), -67.230, 1e-9);
}

TEST(ReadFieldAxes, SeesOneGridInAxesOfTwoPrecisions) {
  for (const double shift : {0.0, 0.05}) {
    MadeFile file;
    file.Times({0});
    file.Box();
    file.Axis("lon_u",
              {-98 + shift, -97.9 + shift, -97.8 + shift, -97.7 + shift,
               -97.6 + shift},
              {{"units", "degrees_east"}}, netCDF::ncFloat);
    file.Put("u", {"time", "lat", "lon_u"}, MadeFile::Repeated({0.1}),
             {{"units", "m/s"}});
    file.Put("v", {"time", "lat", "lon"}, MadeFile::Repeated({0.1}),
             {{"units", "m/s"}});
    const std::string refusal = file.Refusal();
    if (shift == 0.0) {
      EXPECT_EQ(refusal, "read");
    } else {
      EXPECT_THAT(refusal, HasSubstr("expected the grid and the times"));
    }
  }
}

}  // namespace
}  // namespace kg_base
