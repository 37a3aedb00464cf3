#include "tristim/palette/separation.h"

#include <gtest/gtest.h>

namespace tristim {
namespace {

std::vector<Lab> labs(const std::vector<Rgb>& colors) {
  std::vector<Lab> all;
  for (const Rgb& c : colors) all.push_back(lab_of_srgb(c));
  return all;
}

TEST(Separation, FindsTheNearest) {
  const auto nearest = nearest_others(labs({{0, 0, 0}, {1, 1, 1}, {0.01, 0.01, 0.01}}));
  ASSERT_EQ(nearest.size(), 3u);
  EXPECT_EQ(nearest[0].second, 2u);
  EXPECT_EQ(nearest[1].second, 2u);
  EXPECT_EQ(nearest[2].second, 0u);
  EXPECT_EQ(nearest[0].difference, nearest[2].difference);
  EXPECT_TRUE(nearest_others(labs({{0, 0, 0}})).empty());
}

TEST(Separation, ListsClosePairsNearestFirst) {
  const auto pairs = close_pairs(labs({{0.5, 0, 0}, {0.51, 0, 0}, {0.5, 0, 0}, {0, 0, 1}}), 5);
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].first, 0u);
  EXPECT_EQ(pairs[0].second, 2u);
  EXPECT_EQ(pairs[0].difference, 0);
}

TEST(Separation, FindsConfusions) {
  // red and green that protanopes do not tell apart, blue and white that everybody does
  const auto all =
      confusions(std::vector<Rgb>{{0.6, 0.05, 0}, {0.05, 0.12, 0}, {0, 0, 1}, {1, 1, 1}});
  ASSERT_FALSE(all.empty());
  EXPECT_EQ(all[0].deficiency->name, "protanopia");
  EXPECT_EQ(all[0].pair.first, 0u);
  EXPECT_EQ(all[0].pair.second, 1u);
  EXPECT_GE(all[0].pair.difference, kClearDifference);
  EXPECT_LT(all[0].difference, kConfusedDifference);
  for (const Confusion& one : all) EXPECT_LT(one.pair.second, 2u);
}

TEST(Separation, MeasuresCoverage) {
  std::vector<Rgb> corners;
  for (int i = 0; i < 8; ++i)
    corners.push_back({i & 1 ? 1.0 : 0, i & 2 ? 1.0 : 0, i & 4 ? 1.0 : 0});
  const PaletteCoverage cube = palette_coverage(corners);
  EXPECT_EQ(cube.mixed, 1);
  EXPECT_GT(cube.mean, 5);
  EXPECT_GE(cube.farthest, cube.mean);
  const PaletteCoverage grey = palette_coverage(std::vector<Rgb>{{0, 0, 0}, {1, 1, 1}});
  EXPECT_EQ(grey.mixed, 16.0 / 4096);  // the greys
  // of many colours the outermost count
  for (int i = 0; i < 200; ++i) corners.push_back({i / 200.0, 0.5, 0.5});
  EXPECT_EQ(palette_coverage(corners).mixed, 1);
}

}  // namespace
}  // namespace tristim
