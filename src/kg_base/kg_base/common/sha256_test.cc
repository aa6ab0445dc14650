#include "kg_base/common/sha256.h"

#include <cmath>
#include <cstdio>
#include <fstream>
#include <set>
#include <vector>

#include "gtest/gtest.h"
#include "kg_base/common/input_error.h"

namespace kg_base {
namespace {

// FIPS 180-4 examples.
constexpr char kAbc[] =
    "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
constexpr char kMillionA[] =
    "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0";

TEST(Sha256, AgreesWithThePublishedExamples) {
  EXPECT_EQ(Sha256Hex("abc"), kAbc);
  EXPECT_EQ(Sha256Hex(std::string(1000000, 'a')), kMillionA);
  EXPECT_EQ(Sha256Hex(""),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
}

TEST(Sha256, HashesFilesOfAnyLength) {
  const std::string path = testing::TempDir() + "/sha256_test.bin";
  std::ofstream(path, std::ios::binary) << std::string(1000000, 'a');
  EXPECT_EQ(Sha256HexOfFile(path), kMillionA);
  std::ofstream(path, std::ios::binary | std::ios::trunc);
  EXPECT_EQ(Sha256HexOfFile(path), Sha256Hex(""));
  std::remove(path.c_str());
  EXPECT_THROW(Sha256HexOfFile(path), InputError);
  EXPECT_THROW(Sha256HexOfFile(testing::TempDir()), InputError);
}

template <typename... Values>
std::string HashOf(const Values&... values) {
  Hasher hasher;
  (hasher.Add(values), ...);
  return hasher.Hex();
}

TEST(Hasher, TellsSequencesApart) {
  using Floats = std::vector<float>;
  const std::set<std::string> digests = {
      HashOf(),
      HashOf(""),
      HashOf("", ""),
      HashOf("abc"),
      HashOf("ab", "c"),
      HashOf("a", "bc"),
      HashOf(0.0),
      HashOf(-0.0),
      HashOf(1.0),
      HashOf(1.0, 2.0),
      HashOf(2.0, 1.0),
      HashOf(std::string_view("\0\0\0\0\0\0\0\0", 8)),
      HashOf(Floats{}),
      HashOf(Floats{1, 2}),
      HashOf(Floats{1}, Floats{2}),
      HashOf(Floats{NAN}),
      HashOf(Floats(3000, 1.0f)),
      HashOf(Floats(3001, 1.0f)),
  };
  EXPECT_EQ(digests.size(), 18u);
}

TEST(Hasher, EveryNanIsTheSame) {
  EXPECT_EQ(HashOf(std::nan("1")), HashOf(-std::nan("2")));
  EXPECT_EQ(HashOf(std::vector<float>{std::nanf("1")}),
            HashOf(std::vector<float>{-std::nanf("2")}));
}

TEST(Hasher, MayBeAskedOnTheWay) {
  Hasher hasher;
  hasher.Add("a");
  EXPECT_EQ(hasher.Hex(), HashOf("a"));
  hasher.Add(1.0);
  EXPECT_EQ(hasher.Hex(), HashOf("a", 1.0));
}

}  // namespace
}  // namespace kg_base
