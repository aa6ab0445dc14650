#include "kg_base/raster/vertical_axis.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kg_base/raster/testing/made_file.h"

namespace kg_base {
namespace {

using testing::HasSubstr;

struct AxisCase {
  std::string name;
  AttributeTexts texts;
  std::vector<double> levels;
  double surface;  // The level that is to be read.
};

// The value of every cell is its level divided by 1000 of the greatest one.
void Write(MadeFile& file, const AxisCase& axis, const std::string& medium) {
  file.Times({0});
  file.Axis(axis.name, axis.levels, axis.texts);
  file.Box();
  std::vector<double> index;
  for (std::size_t i = 0; i < axis.levels.size(); ++i) index.push_back(i);
  for (const char* direction : {"eastward", "northward"}) {
    file.Put(direction, {"time", axis.name, "lat", "lon"},
             MadeFile::Repeated(index),
             {{"units", "m s-1"}, {"standard_name", direction + medium}});
  }
}

void ExpectSurface(const AxisCase& axis, const std::string& medium) {
  MadeFile file;
  Write(file, axis, medium);
  const FieldFile read = file.Read();
  const auto index = static_cast<std::size_t>(read.series[0].at_time[0][7]);
  EXPECT_EQ(axis.levels.at(index), axis.surface)
      << axis.name << testing::PrintToString(axis.texts);
  EXPECT_THAT(read.series[0].report.level, HasSubstr(axis.name + " = "));
}

TEST(FindSurface, ReadsTheSurfaceOfTheSea) {
  const std::vector<AxisCase> cases = {
      {"depth", {}, {40, 0.5, 20}, 0.5},
      {"depth", {{"units", "m"}, {"positive", "down"}}, {5, 20, 40}, 5},
      {"z", {{"standard_name", "depth"}, {"units", "m"}}, {40, 20, 0}, 0},
      {"z", {{"units", "m"}, {"positive", "up"}}, {-40, -20, -1}, -1},
      {"lev", {{"long_name", "depth of the layer"}}, {40, 20, 0}, 0},
      {"k", {{"standard_name", "ocean_sigma_coordinate"}}, {-1, -0.5, 0}, 0},
      {"s_rho",
       {{"standard_name", "ocean_s_coordinate_g2"}, {"positive", "up"}},
       {-0.9, -0.5, -0.1},
       -0.1},
      {"p",
       {{"standard_name", "sea_water_pressure"}, {"units", "dbar"}},
       {0, 10, 20},
       0},
      {"p", {{"units", "dbar"}}, {30, 10, 20}, 10},
      {"depth",
       {{"standard_name", "height_above_sea_floor"}, {"positive", "up"}},
       {1, 20, 40},
       40},
      {"z", {{"long_name", "height above the bed"}, {"units", "m"}}, {1, 9}, 9},
  };
  for (const AxisCase& axis : cases) ExpectSurface(axis, "_sea_water_velocity");
}

TEST(FindSurface, ReadsTheAirAtTheGround) {
  const std::vector<AxisCase> cases = {
      {"level",
       {{"standard_name", "air_pressure"}, {"units", "millibars"}},
       {200, 850, 1000},
       1000},
      {"isobaric", {{"units", "Pa"}}, {100000, 85000}, 100000},
      {"plev", {{"units", "hPa"}, {"positive", "down"}}, {1000, 500}, 1000},
      {"height", {{"standard_name", "height"}, {"units", "m"}}, {80, 10}, 10},
      {"z", {{"units", "m"}, {"positive", "up"}}, {2, 10, 80}, 2},
      {"sigma",
       {{"standard_name", "atmosphere_sigma_coordinate"}},
       {0.1, 0.995},
       0.995},
  };
  for (const AxisCase& axis : cases) ExpectSurface(axis, "_wind");
}

TEST(FindSurface, RefusesAxesThatDoNotTellWhereTheSurfaceIs) {
  const std::vector<AxisCase> cases = {
      {"level", {}, {1, 2, 3}, 0},
      {"z", {{"units", "m"}, {"positive", "up"}}, {1, 20, 40}, 0},
      {"lev", {{"axis", "Z"}}, {1, 2, 3}, 0},
      {"k", {{"standard_name", "model_level_number"}}, {1, 2, 3}, 0},
  };
  for (const AxisCase& axis : cases) {
    MadeFile file;
    Write(file, axis, "_sea_water_velocity");
    EXPECT_THAT(file.Refusal(),
                HasSubstr("variable " + axis.name + ": which of its 3 levels"));
  }
}

TEST(FindSurface, RefusesLevelsWithoutValues) {
  MadeFile file;
  file.Times({0});
  file.Dimension("depth", 2);
  file.Box();
  file.Currents({"time", "depth", "lat", "lon"}, MadeFile::Repeated({1, 2}));
  EXPECT_THAT(file.Refusal(), HasSubstr("dimension depth has 2 levels"));
}

TEST(FindSurface, TellsOfLevelsThatAreAllFarFromTheSurface) {
  for (const AxisCase& axis : std::vector<AxisCase>{
           {"depth", {{"units", "m"}}, {200, 100}, 100},
           {"depth", {{"units", "m"}}, {100}, 100},
           {"depth", {{"units", "km"}}, {0.1, 0.2}, 0.1},
           {"p", {{"units", "dbar"}}, {100, 500}, 100},
           {"z", {{"standard_name", "height_above_sea_floor"}}, {5}, 5}}) {
    MadeFile file;
    Write(file, axis, "_sea_water_velocity");
    EXPECT_THAT(WarningsOf(file.Read()),
                HasSubstr("nearest to the surface is " + axis.name));
  }
  MadeFile shallow;
  Write(shallow, {"depth", {{"units", "m"}}, {0.5, 100}, 0.5},
        "_sea_water_velocity");
  EXPECT_EQ(WarningsOf(shallow.Read()), "");
}

TEST(FindSurface, TellsOfADeepLevelThatIsAScalar) {
  MadeFile file;
  file.Times({0});
  file.Box();
  file.Put("depth", {}, {100}, {{"units", "m"}, {"positive", "down"}});
  file.Currents({"time", "lat", "lon"}, MadeFile::Repeated({0.1}),
                {{"coordinates", "depth"}});
  EXPECT_THAT(WarningsOf(file.Read()), HasSubstr("depth = 100 m"));
}

}  // namespace
}  // namespace kg_base
