#include "tristim/render/mach_bands.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tristim {
namespace {

std::vector<float> bands_of_row(const std::vector<float>& row) {
  Image intensity(static_cast<int>(row.size()), 1, 1);
  Image bands(static_cast<int>(row.size()), 1, 1);
  std::copy(row.begin(), row.end(), intensity.view().row(0).begin());
  mach_bands(intensity.view(), bands.view());
  const auto out = bands.view().row(0);
  return {out.begin(), out.end()};
}

TEST(MachBands, AreWhereTheSlopeJumps) {
  EXPECT_EQ(bands_of_row({0, 0, 0, 1, 2, 2, 2}), (std::vector<float>{0, 0, -1, 0, 1, 0, 0}));
  EXPECT_EQ(bands_of_row({0, 0, 1, 1}), (std::vector<float>{0, -1, 1, 0}));  // both sides of a step
  EXPECT_EQ(bands_of_row({5}), (std::vector<float>{0}));
}

TEST(MachBands, OfTwoDirectionsAndEachChannel) {
  Image intensity(5, 5, 2);
  Image bands(5, 5, 2);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      intensity.view().pixel(x, y)[0] = static_cast<float>(3 * x - 2 * y);  // linear: none
      intensity.view().pixel(x, y)[1] = x == 2 && y == 2 ? 1.0F : 0.0F;
    }
  }
  mach_bands(intensity.view(), bands.view());
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(bands.view().pixel(x, y)[0], 0);
      const int steps = std::abs(x - 2) + std::abs(y - 2);
      EXPECT_EQ(bands.view().pixel(x, y)[1], steps == 0 ? 4 : steps == 1 ? -1 : 0);
    }
  }
}

}  // namespace
}  // namespace tristim
