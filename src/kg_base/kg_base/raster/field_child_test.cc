// Reading in a child process: for any defect of the file the parent gets one
// error line, in time, and leaks no process and no descriptor.

#include "kg_base/raster/field_child.h"

#include <dirent.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <cerrno>
#include <cmath>
#include <random>

#include "kg_base/raster/field_protocol.h"
#include "kg_base/raster/read_field_file.h"
#include "kg_base/raster/testing/field_test_file.h"

namespace kg_base {
namespace {

constexpr double kDeadline_s = 5.0;

int OpenDescriptors() {
  int count = 0;
  DIR* folder = opendir("/proc/self/fd");
  while (readdir(folder) != nullptr) ++count;
  closedir(folder);
  return count;
}

bool HasChildren() {
  int status = 0;
  return !(waitpid(-1, &status, WNOHANG) == -1 && errno == ECHILD);
}

bool SameRaster(const Raster& a, const Raster& b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (a[i] != b[i] && !(std::isnan(a[i]) && std::isnan(b[i]))) return false;
  }
  return a.size() == b.size();
}

void ExpectSame(const FieldFile& a, const FieldFile& b) {
  EXPECT_EQ(a.path, b.path);
  EXPECT_EQ(a.sha256, b.sha256);
  EXPECT_EQ(a.grid, b.grid);
  EXPECT_EQ(a.time_s, b.time_s);
  ASSERT_EQ(a.series.size(), b.series.size());
  for (std::size_t s = 0; s < a.series.size(); ++s) {
    EXPECT_EQ(a.series[s].quantity, b.series[s].quantity);
    EXPECT_EQ(a.series[s].variable, b.series[s].variable);
    ASSERT_EQ(a.series[s].at_time.size(), b.series[s].at_time.size());
    for (std::size_t t = 0; t < a.series[s].at_time.size(); ++t) {
      EXPECT_TRUE(SameRaster(a.series[s].at_time[t], b.series[s].at_time[t]));
    }
  }
}

// A misbehaving program for KG_READ_FIELD_FILE; the destructor resets the
// variable.
class Impostor {
 public:
  explicit Impostor(const std::string& script) {
    file_.Write("#!/bin/sh\n" + script + "\n");
    chmod(file_.path().c_str(), 0700);
    setenv("KG_READ_FIELD_FILE", file_.path().c_str(), 1);
  }
  ~Impostor() { unsetenv("KG_READ_FIELD_FILE"); }

 private:
  TempFile file_;
};

std::string RefusalOf(const std::string& path, double deadline_s) {
  return InputErrorOf(
      [&] { ReadFieldFileSafely(path, BothVelocities(), deadline_s); });
}

TEST(ReadFieldFileSafely, ReadsWhatTheReaderReads) {
  for (const int format : {0, NC_NETCDF4}) {
    TestFile spec;
    spec.format = format;
    const TempFile file(spec);
    ExpectSame(ReadFieldFileSafely(file.path(), BothVelocities()),
               ReadFieldFile(file.path(), BothVelocities()));
  }
}

TEST(ReadFieldFileSafely, HandsTheReadersLineThrough) {
  TestFile spec;
  spec.north = false;
  const TempFile file(spec);
  EXPECT_EQ(RefusalOf(file.path(), kDeadline_s), InputErrorOf([&] {
              ReadFieldFile(file.path(), BothVelocities());
            }));
  EXPECT_NE(RefusalOf("/nowhere/file.nc", kDeadline_s)
                .find("/nowhere/file.nc: expected a file that exists"),
            std::string::npos);
}

TEST(ReadFieldFileSafely, ReadsTheRealHindcast) {
  const std::string path =
      SharedData("gom_2020/currents_hycom_gomu_2020-11-01-15_5h.nc4");
  if (path.empty()) GTEST_SKIP() << "the shared data are not there";
  ExpectSame(ReadFieldFileSafely(path, BothVelocities()),
             ReadFieldFile(path, BothVelocities()));
}

TEST(ReadFieldFileSafely, EndsAChildThatHangs) {
  const Impostor impostor("exec sleep 1000");
  EXPECT_NE(RefusalOf("any.nc", 0.2).find("any.nc: not read within 0.2"),
            std::string::npos);
  EXPECT_FALSE(HasChildren());
}

TEST(ReadFieldFileSafely, EndsAChildThatHangsHalfWay) {
  const Impostor impostor("printf 'KGFIELD1'; exec sleep 1000");
  EXPECT_NE(RefusalOf("any.nc", 0.2).find("not read within"),
            std::string::npos);
  EXPECT_FALSE(HasChildren());
}

TEST(ReadFieldFileSafely, SaysHowAChildDied) {
  {
    const Impostor impostor("kill -SEGV $$");
    EXPECT_NE(RefusalOf("any.nc", kDeadline_s).find("ended by signal 11"),
              std::string::npos);
  }
  const Impostor impostor("exit 7");
  EXPECT_NE(RefusalOf("any.nc", kDeadline_s).find("ended with status 7"),
            std::string::npos);
  EXPECT_FALSE(HasChildren());
}

TEST(ReadFieldFileSafely, RefusesNonsenseFromItsChild) {
  const Impostor impostor("head -c 100000 /dev/zero");
  EXPECT_NE(RefusalOf("any.nc", kDeadline_s).find("sent invalid data"),
            std::string::npos);
}

TEST(ReadFieldFileSafely, SaysThatItsProgramIsNotThere) {
  setenv("KG_READ_FIELD_FILE", "/nowhere/read_field_file", 1);
  EXPECT_NE(RefusalOf("any.nc", kDeadline_s).find("cannot be run"),
            std::string::npos);
  unsetenv("KG_READ_FIELD_FILE");
}

TEST(ReadFieldFileSafely, KeepsNoProcessAndNoDescriptor) {
  const TempFile file{TestFile()};
  RefusalOf(file.path(), kDeadline_s);
  const int before = OpenDescriptors();
  for (int i = 0; i < 20; ++i) {
    EXPECT_EQ(RefusalOf(file.path(), kDeadline_s), "read");
    EXPECT_NE(RefusalOf("/nowhere", kDeadline_s), "read");
    EXPECT_NE(RefusalOf(file.path(), 0.0), "read");
  }
  EXPECT_EQ(OpenDescriptors(), before);
  EXPECT_FALSE(HasChildren());
}

std::string Damaged(const std::string& whole, int kind, std::mt19937* random) {
  std::string bytes = whole;
  if (kind % 3 == 0) {
    for (int k = 0; k < 20; ++k) {
      bytes[(*random)() % bytes.size()] ^= 1 << (*random)() % 8;
    }
  } else if (kind % 3 == 1) {
    const std::size_t begin = (*random)() % bytes.size();
    const std::size_t end = std::min(bytes.size(), begin + 512);
    for (std::size_t i = begin; i < end; ++i) bytes[i] = 0;
  } else {
    bytes.resize((*random)() % bytes.size());
  }
  return bytes;
}

// Reliability test 12. A flipped bit in the data may be undetected (the files
// have no checksums): values then differ, but are still valid numbers.
TEST(ReadFieldFileSafely, SurvivesSixtyDamagedNetcdf4Files) {
  TestFile spec;
  spec.format = NC_NETCDF4;
  const std::string whole = TempFile(spec).Bytes();
  const TempFile file;
  std::mt19937 random(12);
  int refused = 0;
  for (int i = 0; i < 60; ++i) {
    file.Write(Damaged(whole, i, &random));
    const std::string error = RefusalOf(file.path(), kDeadline_s);
    refused += error != "read";
    EXPECT_TRUE(error == "read" || error.find(file.path()) == 0) << error;
  }
  EXPECT_GE(refused, 20);  // The truncated ones, at least.
  EXPECT_FALSE(HasChildren());
}

TEST(FieldProtocol, GivesBackWhatItTakes) {
  const TempFile file{TestFile()};
  const FieldFile read = ReadFieldFile(file.path(), BothVelocities());
  std::string bytes;
  WriteFieldFile(read, [&](const void* from, std::size_t count) {
    bytes.append(static_cast<const char*>(from), count);
  });
  std::size_t at = 0;
  const FieldFile back =
      ReadFieldBytes(file.path(), [&](void* to, std::size_t count) {
        ASSERT_LE(at + count, bytes.size());
        bytes.copy(static_cast<char*>(to), count, at);
        at += count;
      });
  EXPECT_EQ(at, bytes.size());
  ExpectSame(back, read);
}

TEST(FieldProtocol, RefusesSizesBeforeItAllocatesForThem) {
  const TempFile file{TestFile()};
  std::string whole;
  WriteFieldFile(ReadFieldFile(file.path(), BothVelocities()),
                 [&](const void* from, std::size_t count) {
                   whole.append(static_cast<const char*>(from), count);
                 });
  // Rows, columns, times, series and text length, each set to 2^32 - 1.
  for (const std::size_t lie : {12, 16, 20, 24, 32}) {
    std::string bytes = whole;
    bytes.replace(lie, 4, "\xff\xff\xff\xff");
    std::size_t at = 0;
    const std::string error = InputErrorOf([&] {
      ReadFieldBytes("x.nc", [&](void* to, std::size_t count) {
        if (at + count > bytes.size()) throw InputError("asked for too much");
        bytes.copy(static_cast<char*>(to), count, at);
        at += count;
      });
    });
    EXPECT_NE(error.find("x.nc: the reading process sent invalid data"),
              std::string::npos)
        << lie << ": " << error;
  }
}

}  // namespace
}  // namespace kg_base
