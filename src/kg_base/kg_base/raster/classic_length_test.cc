#include "kg_base/raster/classic_length.h"

#include <gtest/gtest.h>

#include <random>

#include "kg_base/raster/testing/field_test_file.h"

namespace kg_base {
namespace {

std::vector<TestFile> ClassicFiles() {
  std::vector<TestFile> specs;
  for (const int format : {0, NC_64BIT_OFFSET, NC_64BIT_DATA}) {
    for (const bool records : {false, true}) {
      for (const bool packed : {false, true}) {
        TestFile spec;
        spec.format = format;
        spec.records = records;
        spec.packed = packed;
        specs.push_back(spec);
      }
    }
  }
  return specs;
}

TEST(ClassicLength, IsTheLengthOfWholeFilesButForPadding) {
  for (const TestFile& spec : ClassicFiles()) {
    const std::string bytes = TempFile(spec).Bytes();
    const auto length = ClassicLength(bytes);
    ASSERT_TRUE(length);
    EXPECT_LE(*length, bytes.size());
    EXPECT_GT(*length + 4, bytes.size());
  }
}

TEST(ClassicLength, EveryPercentOfTruncationIsRefused) {
  int refused = 0;
  for (const TestFile& spec : ClassicFiles()) {
    const TempFile file(spec);
    const std::string bytes = file.Bytes();
    for (int percent = 0; percent < 100; ++percent) {
      file.Write(bytes.substr(0, bytes.size() * percent / 100));
      const std::string error =
          InputErrorOf([&] { ReadFieldFile(file.path(), BothVelocities()); });
      EXPECT_NE(error.find(file.path() + ": "), std::string::npos)
          << percent << " % of " << bytes.size() << ": " << error;
      refused += error != "read";
    }
    file.Write(bytes);
    EXPECT_EQ(
        InputErrorOf([&] { ReadFieldFile(file.path(), BothVelocities()); }),
        "read");
  }
  EXPECT_EQ(refused, 1200);
}

TEST(ClassicLength, EveryPercentOfTheReal2014FileIsRefused) {
  const std::string real = SharedData("gom_2014/hycom_goml_tuv_2014-08-30.nc");
  if (real.empty()) GTEST_SKIP() << "the shared data are not there";
  std::stringstream bytes;
  bytes << std::ifstream(real, std::ios::binary).rdbuf();
  EXPECT_EQ(*ClassicLength(bytes.str()), bytes.str().size());
  const TempFile file;
  for (int percent = 0; percent < 100; ++percent) {
    file.Write(bytes.str().substr(0, bytes.str().size() * percent / 100));
    EXPECT_NE(
        InputErrorOf([&] { ReadFieldFile(file.path(), BothVelocities()); }),
        "read")
        << percent;
  }
}

TEST(ClassicLength, DamagedHeadersGiveALengthOrAnErrorAndNothingElse) {
  std::mt19937 random(11);
  for (const TestFile& spec : ClassicFiles()) {
    const std::string whole = TempFile(spec).Bytes();
    for (int i = 0; i < 500; ++i) {
      std::string bytes = whole;
      for (int k = 0; k < 3; ++k) bytes[4 + random() % 400] = random() % 256;
      const std::string error = InputErrorOf([&] { ClassicLength(bytes); });
      EXPECT_TRUE(error == "read" || error.find("header") != std::string::npos)
          << error;
    }
  }
}

TEST(ClassicLength, KnowsWhatIsNoClassicFile) {
  EXPECT_FALSE(ClassicLength(""));
  EXPECT_FALSE(ClassicLength("CDF"));
  EXPECT_FALSE(ClassicLength(std::string("CDF\3\0\0\0\0", 8)));
  EXPECT_FALSE(ClassicLength("\x89HDF\r\n\x1a\n"));
}

TEST(ClassicLength, RefusesAFileThatDoesNotSayHowManyRecordsItHas) {
  TestFile spec;
  spec.records = true;
  const TempFile file(spec);
  std::string bytes = file.Bytes();
  bytes.replace(4, 4, "\xff\xff\xff\xff");
  EXPECT_NE(
      InputErrorOf([&] { ClassicLength(bytes); }).find("how many records"),
      std::string::npos);
}

}  // namespace
}  // namespace kg_base
