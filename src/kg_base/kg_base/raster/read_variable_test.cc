// Reading one variable of a file by its name.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "kg_base/common/temporary_folder.h"
#include "kg_base/raster/field_child.h"
#include "kg_base/raster/read_field_file.h"
#include "kg_base/raster/testing/field_test_file.h"
#include "kg_base/raster/testing/test_raster_file.h"

namespace kg_base {
namespace {

const Grid kGrid({-98, -97.9, -97.7}, {21, 21.1});
const float kNan = std::nanf("");

class ReadVariableTest : public testing::Test {
 protected:
  void Write(const TestRasterFile& file) const {
    TestRasterFileWriter(path_, file);
  }

  TemporaryFolder folder_;
  const std::string path_ = folder_ / "file.nc";
};

TEST_F(ReadVariableTest, TakesValuesAsTheyAreWhateverTheirUnit) {
  const Raster values{-1e9f, 0, 2.5f, kNan, 7e20f, 1};
  Write({kGrid,
         {6},
         {{"depth_of_interest", "sea_floor_depth", "fathom", {values}}}});
  const FieldFile file = ReadVariable(path_, "depth_of_interest");
  EXPECT_TRUE(file.grid == kGrid);
  ASSERT_EQ(file.series.size(), 1u);
  EXPECT_EQ(file.series[0].quantity, FieldQuantity::kAny);
  EXPECT_EQ(file.series[0].variable, "depth_of_interest");
  const Raster& read = file.series[0].at_time.at(0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) {
      EXPECT_TRUE(std::isnan(read[i])) << i;
    } else {
      EXPECT_EQ(read[i], values[i]) << i;
    }
  }
}

TEST_F(ReadVariableTest, NeedsNoTimeAndNoDataInEveryStep) {
  const Raster some(6, 1.0f), none(6, kNan);
  Write({kGrid, {}, {{"mask", "", "", {some}, false}}});
  FieldFile file = ReadVariable(path_, "mask");
  ASSERT_EQ(file.time_s.size(), 1u);
  EXPECT_TRUE(std::isnan(file.time_s[0]));
  EXPECT_EQ(file.series[0].at_time.size(), 1u);
  Write({kGrid, {0, 6}, {{"mask", "", "", {none, some}}}});
  file = ReadVariable(path_, "mask");
  EXPECT_EQ(file.time_s[1] - file.time_s[0], 21600.0);
  EXPECT_EQ(file.series[0].at_time[1], some);
}

// Same result as ReadFieldFile: packing, fill and row order share the code that
// field_file_test.cc tests in every form.
TEST_F(ReadVariableTest, UnpacksAndTurnsAsOtherReadersDo) {
  TestFile spec;
  spec.order = "tzxy";
  spec.lat = {21.25, 21.1, 21};
  const TempFile written(spec);
  const FieldFile all = ReadFieldFile(written.path(), BothVelocities());
  const FieldFile one = ReadVariable(written.path(), "water_u");
  EXPECT_TRUE(one.grid == all.grid);
  EXPECT_EQ(one.time_s, all.time_s);
  EXPECT_EQ(one.sha256, all.sha256);
  for (std::size_t t = 0; t < all.time_s.size(); ++t) {
    const Raster& wanted = all.series[0].at_time[t];
    const Raster& got = one.series[0].at_time[t];
    ASSERT_EQ(got.size(), wanted.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
      EXPECT_TRUE(got[i] == wanted[i] ||
                  (std::isnan(got[i]) && std::isnan(wanted[i])));
    }
  }
}

TEST_F(ReadVariableTest, AChildProcessReadsTheSame) {
  const Raster values{0, 1, 0, 1, kNan, 1};
  Write({kGrid, {}, {{"mask", "", "", {values}, false}}});
  const FieldFile here = ReadVariable(path_, "mask");
  const FieldFile there = ReadVariableSafely(path_, "mask");
  EXPECT_TRUE(there.grid == here.grid);
  EXPECT_EQ(there.sha256, here.sha256);
  EXPECT_EQ(there.series[0].at_time[0][3], 1.0f);
  EXPECT_TRUE(std::isnan(there.series[0].at_time[0][4]));
  EXPECT_TRUE(std::isnan(there.time_s.at(0)));
}

TEST_F(ReadVariableTest, RefusesANameThatIsNotThereAndSaysWhichAre) {
  Write({kGrid, {0}, {{"reef", "", "", {Raster(6, 1.0f)}}}});
  for (const std::string name : {"coral", "", "a\nb"}) {
    for (const auto& said :
         {InputErrorOf([&] { ReadVariable(path_, name); }),
          InputErrorOf([&] { ReadVariableSafely(path_, name); })}) {
      EXPECT_NE(said.find("no variable \""), std::string::npos) << said;
      EXPECT_NE(said.find("expected one of reef"), std::string::npos) << said;
      EXPECT_EQ(said.find('\n'), std::string::npos) << said;
    }
  }
  EXPECT_NE(InputErrorOf([&] {
              ReadVariable(path_, "lat");
            }).find("expected a latitude and a longitude"),
            std::string::npos);
}

}  // namespace
}  // namespace kg_base
