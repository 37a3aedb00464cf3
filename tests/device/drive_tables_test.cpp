#include "tristim/device/drive_tables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "tests/error_text.h"
#include "tristim/core/find.h"
#include "tristim/device/level_report.h"

namespace tristim {
namespace {

using Codes = std::vector<int>;

// A dimming table: equal steps of L* from no light on.
LevelTable dimming(int n) {
  return {.n = n, .spacing = find_by_name(level_spacings(), "lstar"), .from_zero = true};
}

TEST(LookUpTables, AreTheDocumentsTwoArrangements) {
  const Codes codes{2, 3, 5};
  const LookUpTables value = look_up_tables(codes, Store::kValue, 5);
  EXPECT_EQ(value.frame_buffer, codes);
  EXPECT_EQ(value.color_table, (Codes{0, 1, 2, 3, 4, 5}));
  const LookUpTables index = look_up_tables(codes, Store::kIndex, 5);
  EXPECT_EQ(index.frame_buffer, (Codes{0, 1, 2}));
  EXPECT_EQ(index.color_table, codes);
  // Whatever the arrangement, level j ends as V_j.
  for (std::size_t j = 0; j < codes.size(); ++j) {
    for (const LookUpTables& t : {value, index}) {
      EXPECT_EQ(t.color_table[static_cast<std::size_t>(t.frame_buffer[j])], codes[j]);
    }
  }
}

TEST(DeadReckoned, RisesAtEachLevelAndKeepsTheEnds) {
  for (const int code_max : {255, 256, 1023, 4095}) {
    for (const int n : {15, 63, 255}) {
      const Codes nearest = level_codes(dimming(n), LinearResponse{}, code_max);
      const Codes rising = dead_reckoned(nearest, code_max);
      EXPECT_EQ(rising.front(), 0);
      EXPECT_EQ(rising.back(), code_max);
      EXPECT_TRUE(shared_runs(rising).empty());
      EXPECT_TRUE(std::is_sorted(rising.begin(), rising.end()));
    }
  }
}

TEST(DeadReckoned, ChangesOnlyWhatMustChange) {
  EXPECT_EQ(dead_reckoned(Codes{0, 0, 0, 1, 4, 9}, 9), (Codes{0, 1, 2, 3, 4, 9}));
  EXPECT_EQ(dead_reckoned(Codes{0, 5, 9, 9, 9}, 9), (Codes{0, 5, 7, 8, 9}));
  EXPECT_EQ(dead_reckoned(Codes{3, 4, 9}, 9), (Codes{3, 4, 9}));
}

TEST(DeadReckoned, StaysNearestWhereTheHardwareHasTooFewCodes) {
  const Codes codes{0, 0, 1, 2, 3};
  EXPECT_EQ(dead_reckoned(codes, 3), codes);
}

// n = 3 of linear light on 1 bit: 0, 1/3, 2/3, 1 over 4 frames. A third is nearest to 1/4.
TEST(TemporalCodes, SpreadTheUpperCodeOverTheFrames) {
  const LevelTable table{
      .n = 3, .gamma = 1, .spacing = find_by_name(level_spacings(), "gamma"), .from_zero = true};
  const std::vector<FrameCodes> levels = temporal_codes(table, LinearResponse{}, 1, 2);
  EXPECT_EQ(levels,
            (std::vector<FrameCodes>{{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 1, 0}, {1, 1, 1, 1}}));
}

TEST(TemporalCodes, ComeAsNearAsTheFramesAllow) {
  for (const Response& response :
       {Response(LinearResponse{}), Response(GammaResponse{.gamma = 2.2}),
        Response(SrgbResponse{})}) {
    for (const int bits : {1, 2, 4}) {
      const LevelTable table = dimming(63);
      const std::vector<double> wanted = intensity_levels(table);
      const std::vector<FrameCodes> levels = temporal_codes(table, response, 255, bits);
      for (std::size_t j = 0; j < levels.size(); ++j) {
        const auto [low, high] = std::minmax_element(levels[j].begin(), levels[j].end());
        ASSERT_LE(*high - *low, 1);
        const int above = std::min(*low + 1, 255);
        const double step =
            light_of_code(response, above, 255) - light_of_code(response, *low, 255);
        ASSERT_LE(std::fabs(mean_light(levels[j], response, 255) - wanted[j]),
                  step / (2 << bits) + 1e-15);
      }
    }
  }
}

TEST(TemporalCodes, OfPwmAreTheCodeWithMoreBits) {
  const LevelTable table = dimming(255);
  const std::vector<FrameCodes> levels = temporal_codes(table, LinearResponse{}, 255, 3);
  const std::vector<double> wanted = intensity_levels(table);
  for (std::size_t j = 0; j < levels.size(); ++j) {
    int sum = 0;
    for (const int code : levels[j]) sum += code;
    EXPECT_EQ(sum, static_cast<int>(std::floor(wanted[j] * 255 * 8 + 0.5))) << j;
  }
}

TEST(TemporalCodes, RefuseOtherBits) {
  EXPECT_EQ(error_text([] { temporal_codes({}, LinearResponse{}, 255, 9); }),
            "invalid: temporal bits: 9 is not in 0..8");
}

// [BT1886 annex 1] for Lw = 100, Lb = .1: by bc, 100^(1/2.4) = 6.81292069, .1^(1/2.4) = .38311868.
TEST(Bt1886Constants, AreTheAnnexs) {
  const Bt1886Constants constants = bt1886_constants(100, 0.1);
  EXPECT_NEAR(constants.b, 0.38311868 / (6.81292069 - 0.38311868), 1e-8);
  EXPECT_NEAR(constants.a, std::pow(6.81292069 - 0.38311868, 2.4), 1e-6);
  // Signal 0 shows the black, 1 the white.
  EXPECT_NEAR(constants.a * std::pow(constants.b, 2.4), 0.1, 1e-14);
  EXPECT_NEAR(constants.a * std::pow(1 + constants.b, 2.4), 100, 1e-12);
  EXPECT_EQ(bt1886_constants(80, 0).b, 0);
  EXPECT_EQ(error_text([] { bt1886_constants(1, 1); }), "invalid: Lb: 1 is not from 0 up to Lw, 1");
  EXPECT_EQ(error_text([] { bt1886_constants(1, std::nan("")); }),
            "invalid: Lb: nan is not from 0 up to Lw, 1");
}

}  // namespace
}  // namespace tristim
