#include "kg_base/raster/shared_raster.h"

#include <gtest/gtest.h>

namespace kg_base {
namespace {

TEST(SharedRaster, CopiesShareUntilOneIsWrittenTo) {
  SharedRaster a = Raster{1, 2, 3};
  SharedRaster b = a;
  EXPECT_EQ(a.data(), b.data());
  b[1] = 7;
  EXPECT_NE(a.data(), b.data());
  EXPECT_EQ(a.values(), (Raster{1, 2, 3}));
  EXPECT_EQ(b.values(), (Raster{1, 7, 3}));
}

TEST(SharedRaster, AnUnsharedOneIsWrittenInPlace) {
  SharedRaster a = Raster{1, 2};
  const float* before = a.data();
  for (float& value : a) value = 5;
  EXPECT_EQ(a.data(), before);
  EXPECT_EQ(a.values(), (Raster{5, 5}));
  { const SharedRaster passing = a; }
  a[0] = 6;
  EXPECT_EQ(a.data(), before);
}

TEST(SharedRaster, WhatSomebodyElseHoldsIsNeverWrittenTo) {
  const auto held = std::make_shared<const Raster>(Raster{1, 2});
  SharedRaster a(held);
  EXPECT_EQ(a.data(), held->data());
  a[0] = 9;
  EXPECT_EQ((*held)[0], 1);
  EXPECT_EQ(a[0], 9);
}

TEST(SharedRaster, HoldsAPartOfSomethingLargerForAsLongAsItIsNeeded) {
  struct File {
    std::vector<Raster> steps{{1, 2}, {3, 4}};
  };
  auto file = std::make_shared<const File>();
  const std::weak_ptr<const File> watch = file;
  SharedRaster step(std::shared_ptr<const Raster>(file, &file->steps[1]));
  file.reset();
  EXPECT_FALSE(watch.expired());
  EXPECT_EQ(step[1], 4);
  step = Raster{0};
  EXPECT_TRUE(watch.expired());
}

}  // namespace
}  // namespace kg_base
