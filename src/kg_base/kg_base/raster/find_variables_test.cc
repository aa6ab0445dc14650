#include "kg_base/raster/find_variables.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kg_base/raster/testing/made_file.h"

namespace kg_base {
namespace {

using testing::HasSubstr;

const std::vector<std::string> kDimensions{"time", "lat", "lon"};
const std::vector<double> kStill(15, 0.1);

void PutField(MadeFile& file, const std::string& name, AttributeTexts texts) {
  texts.emplace("units", "m s-1");
  file.Put(name, kDimensions, kStill, texts);
}

void WriteAxes(MadeFile& file) {
  file.Times({0});
  file.Box();
}

TEST(FindVariables, TellsOfTheTideThatItLeavesOut) {
  MadeFile file;
  WriteAxes(file);
  for (const std::string axis : {"x", "y"}) {
    const std::string letter = axis == "x" ? "u" : "v";
    PutField(file, letter + "total",
             {{"standard_name", "surface_sea_water_" + axis + "_velocity"}});
    PutField(file, letter + "o",
             {{"standard_name", axis == "x" ? "eastward_sea_water_velocity"
                                            : "northward_sea_water_velocity"}});
    PutField(
        file, letter + "tide",
        {{"standard_name", "sea_water_" + axis + "_velocity_due_to_tides"}});
  }
  const FieldFile read = file.Read();
  EXPECT_EQ(read.series[0].variable, "uo");
  EXPECT_THAT(WarningsOf(read), HasSubstr("uo: chosen among several"));
  EXPECT_THAT(WarningsOf(read), HasSubstr("utotal"));
  EXPECT_THAT(WarningsOf(read), HasSubstr("vtide"));
}

TEST(FindVariables, TakesNoOtherQuantityByItsName) {
  for (const char* long_name :
       {"U component of wind", "10 metre wind", "Stokes drift", "ice velocity",
        "surface wind stress", "standard deviation of the current"}) {
    MadeFile file;
    WriteAxes(file);
    PutField(file, "u", {{"long_name", long_name}});
    PutField(file, "v", {{"long_name", long_name}});
    const std::string refusal = file.Refusal();
    EXPECT_THAT(refusal, HasSubstr("no variable for eastward velocity"));
    EXPECT_THAT(refusal, HasSubstr("u (long_name " + std::string(long_name)));
  }
  for (const char* long_name :
       {"", "eastward current", "u from the NOAA service", "window mean"}) {
    MadeFile file;
    WriteAxes(file);
    PutField(file, "u", {{"long_name", long_name}});
    PutField(file, "v", {{"long_name", long_name}});
    EXPECT_EQ(file.Refusal(), "read") << long_name;
  }
}

TEST(FindVariables, NamesWhatIsThere) {
  MadeFile file;
  WriteAxes(file);
  PutField(file, "u", {{"standard_name", "sea_water_x_velocity"}});
  PutField(file, "v", {{"standard_name", "sea_water_y_velocity"}});
  EXPECT_THAT(file.Refusal(),
              HasSubstr("u (standard_name sea_water_x_velocity)"));
}

TEST(FindVariables, ReadsFieldsInAGroup) {
  for (const bool has_axes_in_root : {false, true}) {
    MadeFile file;
    if (has_axes_in_root) WriteAxes(file);
    file.InGroup("layer_1");
    if (!has_axes_in_root) WriteAxes(file);
    file.Currents(kDimensions, kStill);
    const FieldFile read = file.Read();
    EXPECT_EQ(read.series[0].variable, "layer_1/water_u");
    EXPECT_FLOAT_EQ(read.series[1].at_time[0][14], 0.1f);
  }
}

TEST(FindVariables, ReadsOneFieldOfAGroupByItsPath) {
  MadeFile file;
  WriteAxes(file);
  file.InGroup("layer_1");
  file.Put("reef", {"lat", "lon"}, kStill);
  EXPECT_EQ(file.ReadNamed("layer_1/reef").series[0].variable, "layer_1/reef");
}

TEST(FindVariables, RefusesTwoGroupsThatHaveTheSameFields) {
  for (const bool is_named : {false, true}) {
    MadeFile file;
    WriteAxes(file);
    for (const char* group : {"surface", "bottom"}) {
      file.InGroup(group);
      if (is_named) {
        PutField(file, "u", {});
        PutField(file, "v", {});
      } else {
        file.Currents(kDimensions, kStill);
      }
    }
    const std::string refusal = file.Refusal();
    EXPECT_THAT(refusal, HasSubstr("surface/"));
    EXPECT_THAT(refusal, HasSubstr("bottom/"));
  }
}

TEST(FindVariables, IsNotDisturbedByGroupsWithDimensionsOfTheirOwn) {
  MadeFile file;
  file.Times({0});
  file.InGroup("quality");
  file.Dimension("flag", 4);
  file.Put("flags", {"flag"}, {1, 2, 3, 4});
  file.InRoot();
  file.Box();
  file.Currents(kDimensions, kStill);
  EXPECT_EQ(file.Refusal(), "read");
}

}  // namespace
}  // namespace kg_base
