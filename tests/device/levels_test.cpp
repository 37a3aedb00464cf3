#include "tristim/device/levels.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tests/error_text.h"
#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

std::vector<LevelTable> tables() {
  std::vector<LevelTable> all;
  for (const LevelSpacing& spacing : level_spacings()) {
    for (const int n : {1, 2, 7, 255, 4095}) {
      for (const double i0 : {0.001, 0.02, 0.9}) all.push_back({n, i0, 2.2, &spacing});
    }
  }
  return all;
}

std::string trace(const LevelTable& table) {
  return std::string(table.spacing->name) + " n=" + std::to_string(table.n) +
         " i0=" + std::to_string(table.i0);
}

// r = 2 by hand: each level is twice the one before.
TEST(IntensityLevels, HaveEqualRatios) {
  const std::vector<double> levels = intensity_levels({.n = 3, .i0 = 0.125});
  ASSERT_EQ(levels.size(), 4U);
  EXPECT_EQ(levels[0], 0.125);
  EXPECT_DOUBLE_EQ(levels[1], 0.25);
  EXPECT_DOUBLE_EQ(levels[2], 0.5);
  EXPECT_EQ(levels[3], 1);
}

TEST(IntensityLevels, AscendFromI0ToOneInEqualStepsOfTheSpacing) {
  for (const LevelTable& table : tables()) {
    SCOPED_TRACE(trace(table));
    const std::vector<double> levels = intensity_levels(table);
    ASSERT_EQ(levels.size(), static_cast<std::size_t>(table.n) + 1);
    EXPECT_EQ(levels.front(), table.i0);
    EXPECT_EQ(levels.back(), 1);
    const auto position = [&](double i) { return table.spacing->position(i, table.gamma); };
    const double step = (position(1) - position(table.i0)) / table.n;
    for (std::size_t j = 1; j < levels.size(); ++j) {
      ASSERT_GT(levels[j], levels[j - 1]);
      // Roundings of a position up to 100 (L*).
      ASSERT_NEAR(position(levels[j]) - position(levels[j - 1]), step, 1e-13);
    }
  }
}

TEST(NearestLevel, OfEveryLevelIsItself) {
  for (const LevelTable& table : tables()) {
    SCOPED_TRACE(trace(table));
    const std::vector<double> levels = intensity_levels(table);
    for (int j = 0; j <= table.n; j += 1 + table.n / 64) {
      ASSERT_EQ(nearest_level(levels[static_cast<std::size_t>(j)], table), j);
    }
  }
}

TEST(NearestLevel, TurnsHalfWayInTheSpacing) {
  // Ratio 4: between 1/4 and 1 the middle is 1/2.
  const LevelTable table{.n = 2, .i0 = 1.0 / 16};
  EXPECT_EQ(nearest_level(0.499, table), 1);
  EXPECT_EQ(nearest_level(0.501, table), 2);
  EXPECT_EQ(nearest_level(0.1249, table), 0);
  EXPECT_EQ(nearest_level(0.1251, table), 1);
}

TEST(NearestLevel, IsClampedAndNothingForNan) {
  const LevelTable table;
  EXPECT_EQ(nearest_level(0, table), 0);
  EXPECT_EQ(nearest_level(-1, table), 0);
  EXPECT_EQ(nearest_level(1e-300, table), 0);
  EXPECT_EQ(nearest_level(1.5, table), 255);
  EXPECT_EQ(nearest_level(std::numeric_limits<double>::infinity(), table), 255);
  EXPECT_FALSE(nearest_level(std::nan(""), table));
}

TEST(Levels, AgreeWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  const auto folder = *shared / "spec/colour-examples";
  for (const ExampleRow& row : example_rows(folder / "intensity_levels.csv")) {
    SCOPED_TRACE(row.text("id"));
    const LevelTable table{.n = std::stoi(row.text("n")), .i0 = row.number("I0")};
    const std::vector<double> levels = intensity_levels(table);
    const auto j = static_cast<std::size_t>(std::stoi(row.text("j")));
    EXPECT_NEAR(levels[j], row.number("I_j"), 1e-15 * row.number("I_j"));  // the file's tolerance
    const std::vector<int> codes =
        level_codes(levels, row.number("gamma"), std::stoi(row.text("Vmax")));
    EXPECT_EQ(codes[j], std::stoi(row.text("V_j")));
  }
  for (const ExampleRow& row : example_rows(folder / "intensity_nearest.csv")) {
    SCOPED_TRACE(row.text("id"));
    const LevelTable table{.n = std::stoi(row.text("n")), .i0 = row.number("I0")};
    EXPECT_EQ(nearest_level(row.number("I"), table), std::stoi(row.text("j")));
  }
}

// V = floor(255 I^(1/2) + 1/2) by hand; 1/4 is the exact half 127.5, which goes up.
TEST(LevelCodes, RoundHalfUp) {
  EXPECT_EQ(level_codes({0, 0.01, 0.25, 1}, 2, 255), (std::vector<int>{0, 26, 128, 255}));
  EXPECT_EQ(level_codes({0, 0.5, 1}, 1, 1), (std::vector<int>{0, 1, 1}));
}

TEST(LevelCodes, TakeAGivenKAndStayInTheCodes) {
  // I = K V^2 with K = 1/100^2: full light is V = 100.
  EXPECT_EQ(level_codes({0.25, 1}, 2, 255, 1e-4), (std::vector<int>{50, 100}));
  EXPECT_EQ(level_codes({1}, 2, 255, 1e-6), std::vector<int>{255});
  EXPECT_EQ(level_codes({2, -1}, 2, 255), (std::vector<int>{255, 0}));
}

RC_GTEST_PROP(LevelCodes, AreTheNearestToTheInverse, ()) {
  const double gamma = *rc::gen::inRange(100, 300) / 100.0;
  const int code_max = *rc::gen::element(15, 255, 1023, 65535);
  const int code = *rc::gen::inRange(0, code_max + 1);
  const double light = std::pow(double(code) / code_max, gamma);
  RC_ASSERT(level_codes({light}, gamma, code_max) == std::vector<int>{code});
}

TEST(LevelTable, RefusesWhatIsNoTable) {
  EXPECT_EQ(error_text([] { intensity_levels({.n = 0}); }), "invalid: n: 0 is not in 1..65535");
  EXPECT_EQ(error_text([] { intensity_levels({.n = 65536}); }),
            "invalid: n: 65536 is not in 1..65535");
  EXPECT_EQ(error_text([] { intensity_levels({.i0 = 0}); }),
            "invalid: i0: 0 is not between 0 and 1");
  EXPECT_EQ(error_text([] { nearest_level(0.5, {.i0 = 1}); }),
            "invalid: i0: 1 is not between 0 and 1");
  EXPECT_EQ(error_text([] { nearest_level(0.5, {.i0 = std::nan("")}); }),
            "invalid: i0: nan is not between 0 and 1");
  EXPECT_EQ(error_text([] { intensity_levels({.gamma = -1}); }),
            "invalid: gamma: -1 is not above 0");
  EXPECT_EQ(error_text([] { level_codes({1}, 0, 255); }), "invalid: gamma: 0 is not above 0");
  EXPECT_EQ(error_text([] { level_codes({1}, 2, 0); }), "invalid: Vmax: 0 is not above 0");
}

}  // namespace
}  // namespace tristim
