#include "tristim/device/level_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/error_text.h"
#include "tristim/color/lab.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

TEST(SharedRuns, AreEqualNeighbours) {
  const int values[] = {3, 3, 4, 5, 5, 5, 6};
  EXPECT_EQ(shared_runs(values), (std::vector<SharedRun>{{0, 1, 3}, {3, 5, 5}}));
  EXPECT_EQ(distinct_values(values), 4);
  EXPECT_TRUE(shared_runs({}).empty());
}

// Levels 1/4, 1/2, 1 of a linear device with codes 0..8: codes nearest to them in ratio turn at
// sqrt(1/8) = .354 and .707, between 2 and 3 and between 5 and 6.
TEST(LevelReport, CountsWhatCodesMakeOfLevels) {
  const LevelTable table{.n = 2, .i0 = 0.25};
  const std::vector<int> codes = level_codes(table, LinearResponse{}, 8);
  EXPECT_EQ(codes, (std::vector<int>{2, 4, 8}));
  const LevelReport report = level_report(table, LinearResponse{}, codes, 8);
  EXPECT_EQ(report.dynamic_range, 4);
  EXPECT_EQ(report.ratio, 2);
  EXPECT_EQ(report.distinct, 3);
  EXPECT_TRUE(report.shared_codes.empty());
  EXPECT_EQ(report.dead_zones, (std::vector<SharedRun>{{0, 2, 0}, {3, 5, 1}, {6, 8, 2}}));
  EXPECT_EQ(report.largest_step_at, 2);
  EXPECT_DOUBLE_EQ(report.largest_lstar_step, 100 - lstar_from_luminance(0.5));
  EXPECT_DOUBLE_EQ(report.largest_shown_lstar_step, 100 - lstar_from_luminance(0.5));
}

TEST(LevelReport, NamesLevelsThatShareACode) {
  const LevelTable table{
      .n = 255, .spacing = find_by_name(level_spacings(), "lstar"), .from_zero = true};
  const std::vector<int> codes = level_codes(table, LinearResponse{}, 255);
  const LevelReport report = level_report(table, LinearResponse{}, codes, 255);
  EXPECT_TRUE(std::isinf(report.dynamic_range));
  // Y = L*/903.3 of L* = 100 j/255 stays below .5/255 up to j = 4.
  ASSERT_FALSE(report.shared_codes.empty());
  EXPECT_EQ(report.shared_codes[0], (SharedRun{0, 4, 0}));
  EXPECT_LT(report.distinct, 256);
}

TEST(LevelReport, NeedsACodeForEachLevel) {
  const int codes[] = {0, 1};
  EXPECT_EQ(error_text([&] { level_report({.n = 2}, LinearResponse{}, codes, 8); }),
            "invalid: codes: there is not one for each level");
}

}  // namespace
}  // namespace tristim
