#include "tristim/palette/mixing.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace tristim {
namespace {

// All mixtures of black, red, green and yellow in eighths of light.
Histogram square() {
  constexpr std::uint8_t kEighths[9] = {0, 99, 137, 165, 188, 207, 225, 240, 255};
  Histogram histogram;
  for (const std::uint8_t r : kEighths) {
    for (const std::uint8_t g : kEighths) histogram.add({r, g, 0}, 10);
  }
  return histogram;
}

// Four colours in the midst of the square can mix little of it; moved apart they mix most.
TEST(RefineForMixing, MovesColoursApart) {
  const std::vector<Color8> inner{{90, 90, 0}, {200, 90, 0}, {90, 200, 0}, {200, 200, 0}};
  const std::vector<Color8> outer = refine_for_mixing(square(), inner);
  ASSERT_EQ(outer.size(), inner.size());
  EXPECT_LT(outer[0].r, 60);
  EXPECT_LT(outer[0].g, 60);
  EXPECT_GT(outer[1].r, 210);
  EXPECT_GT(outer[2].g, 210);
  EXPECT_GT(std::min(outer[3].r, outer[3].g), 210);
  for (const Color8& c : outer) EXPECT_EQ(c.b, 0);
}

TEST(RefineForMixing, KeepsTheFirstAndAllAlpha) {
  const std::vector<Color8> palette{{90, 90, 0}, {200, 90, 0, 128}, {90, 200, 0}, {200, 200, 0}};
  const std::vector<Color8> refined = refine_for_mixing(square(), palette, 2);
  EXPECT_EQ(refined[0], palette[0]);
  EXPECT_EQ(refined[1], palette[1]);
  EXPECT_NE(refined[2], palette[2]);
  EXPECT_EQ(refine_for_mixing(square(), palette, 4), palette);
  EXPECT_EQ(refine_for_mixing(square(), palette)[1].a, 128);
}

TEST(RefineForMixing, LeavesPalettesThatHoldEverything) {
  Histogram histogram;
  histogram.add({10, 20, 30}, 5);
  histogram.add({200, 20, 30}, 1);
  const std::vector<Color8> palette{{0, 0, 0}, {10, 20, 30}, {200, 20, 30}};
  EXPECT_EQ(refine_for_mixing(histogram, palette), palette);
  EXPECT_EQ(refine_for_mixing({}, palette), palette);
}

TEST(RefineForMixing, LeavesLargePalettes) {
  std::vector<Color8> palette;
  for (int i = 0; i < 257; ++i) {
    palette.push_back({static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(i >> 8), 7});
  }
  EXPECT_EQ(refine_for_mixing(square(), palette), palette);
}

TEST(RefineForMixing, TakesOneColour) {
  const std::vector<Color8> one = refine_for_mixing(square(), {{10, 10, 0}});
  EXPECT_EQ(one.size(), 1U);
  EXPECT_GT(one[0].r, 100);  // towards the mean
}

}  // namespace
}  // namespace tristim
