#include "tristim/device/levels.h"

#include <gtest/gtest.h>
#include <quadmath.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "tests/color/accuracy_curves.h"
#include "tests/error_text.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using reference::Quad;

const LevelSpacing* spacing(std::string_view name) { return find_by_name(level_spacings(), name); }

// A number as its decimal text says, in 113 bits.
Quad decimal(double x) { return strtoflt128(shortest(x).c_str(), nullptr); }

// The spacings once more in 113 bits, straight from their publications.
Quad lightness(Quad y) {
  return y > Quad(216) / 24389 ? 116 * powq(y, Quad(1) / 3) - 16 : y * 24389 / 27;
}
Quad luminance(Quad lstar) {
  const Quad root = (lstar + 16) / 116;
  return lstar > 8 ? root * root * root : lstar * 27 / 24389;
}
Quad srgb_light(Quad e) {
  return e <= 0.04045 ? e / (Quad(1292) / 100)
                      : powq((e + Quad(55) / 1000) / (Quad(1055) / 1000), Quad(24) / 10);
}
Quad srgb_code(Quad x) {
  return x <= 0.0031308 ? x * 1292 / 100
                        : Quad(1055) / 1000 * powq(x, Quad(10) / 24) - Quad(55) / 1000;
}

Quad between(Quad low, Quad high, const LevelTable& table, int j) {
  return low + (high - low) * j / table.n;
}

Quad exact_level(const LevelTable& table, int j) {
  const std::string_view name = spacing_of(table).name;
  const Quad i0 = table.from_zero ? Quad(0) : decimal(table.i0);
  if (name == "ratio") return powq(i0, Quad(table.n - j) / table.n);
  if (name == "lstar") return luminance(between(lightness(i0), 100, table, j));
  if (name == "srgb") return srgb_light(between(srgb_code(i0), 1, table, j));
  if (name == "pq") {
    const reference::Pq<Quad> pq;
    const Quad peak = decimal(table.peak_cd_m2) / 10000;
    const Quad code = between(pq.encode(i0 * peak).value, pq.encode(peak).value, table, j);
    return pq.decode(code).value / peak;
  }
  const Quad gamma = name == "bt1886" ? Quad(24) / 10 : decimal(table.gamma);
  return powq(between(i0 > 0 ? powq(i0, 1 / gamma) : Quad(0), 1, table, j), gamma);
}

std::vector<LevelTable> tables() {
  std::vector<LevelTable> all;
  for (const LevelSpacing& spacing : level_spacings()) {
    if (spacing.name == "measured") continue;
    for (const int n : {1, 2, 7, 255, 4095}) {
      for (const double i0 : {1e-6, 0.001, 0.02, 0.9}) all.push_back({n, i0, 2.2, &spacing});
    }
    all.push_back({255, 0.005, 1.8, &spacing, 100});
    if (spacing.name != "ratio") all.push_back({100, 0.5, 2.4, &spacing, 1000, true});
  }
  return all;
}

std::string trace(const LevelTable& table) {
  return std::string(spacing_of(table).name) + " n=" + std::to_string(table.n) +
         " i0=" + std::to_string(table.i0);
}

// r = 2 by hand: each level is twice the one before.
TEST(IntensityLevels, HaveEqualRatios) {
  EXPECT_EQ(intensity_levels({.n = 3, .i0 = 0.125}), (std::vector<double>{0.125, 0.25, 0.5, 1}));
}

TEST(IntensityLevels, AscendFromTheLowestToOne) {
  for (const LevelTable& table : tables()) {
    SCOPED_TRACE(trace(table));
    const std::vector<double> levels = intensity_levels(table);
    ASSERT_EQ(levels.size(), static_cast<std::size_t>(table.n) + 1);
    EXPECT_EQ(levels.front(), table.from_zero ? 0 : table.i0);
    EXPECT_EQ(levels.back(), 1);
    EXPECT_TRUE(std::is_sorted(levels.begin(), levels.end()));
  }
}

TEST(IntensityLevels, AreTheFormulaInExtendedPrecisionRoundedOnce) {
  for (const LevelTable& table : tables()) {
    SCOPED_TRACE(trace(table));
    const std::vector<double> levels = intensity_levels(table);
    for (int j = 0; j <= table.n; ++j) {
      const Quad exact = exact_level(table, j);
      const Quad error = fabsq(levels[static_cast<std::size_t>(j)] - exact);
      ASSERT_LE(error, 1.2e-16 * exact) << j;  // half an ulp: 2^-53 = 1.11e-16
    }
  }
}

TEST(IntensityLevels, FollowAMeasuredResponse) {
  const LevelTable table{.n = 4,
                         .i0 = 0.1,
                         .spacing = spacing("measured"),
                         .measured = TableResponse{{0, 100, 200}, {10, 30, 100}}};
  const std::vector<double> levels = intensity_levels(table);
  EXPECT_EQ(levels[0], 0.1);
  EXPECT_EQ(levels[2], 0.3);  // the middle of the codes
  EXPECT_EQ(levels[4], 1);
  for (int j = 0; j <= 4; ++j) {
    EXPECT_EQ(nearest_level(levels[static_cast<std::size_t>(j)], table), j);
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
  // Ratio 4: between 1/4 and 1 the middle is 1/2, and belongs to the upper level.
  const LevelTable table{.n = 2, .i0 = 1.0 / 16};
  EXPECT_EQ(nearest_level(0.5, table), 2);
  EXPECT_EQ(nearest_level(std::nextafter(0.5, 0), table), 1);
  EXPECT_EQ(nearest_level(0.125, table), 1);
  EXPECT_EQ(nearest_level(0.1249, table), 0);
  // As decimals too: .01 is half way between .001 and .1 in ratio.
  EXPECT_EQ(nearest_level(0.01, {.n = 1, .i0 = 0.0001}), 1);
  EXPECT_EQ(nearest_level(0.001, {.n = 2, .i0 = 0.0001}), 1);
  EXPECT_EQ(nearest_level(0.55, {.n = 1, .i0 = 0.1, .gamma = 1, .spacing = spacing("gamma")}), 1);
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

TEST(LevelPosition, IsAWholeNumberAtEachLevel) {
  for (const LevelTable& table : tables()) {
    SCOPED_TRACE(trace(table));
    const std::vector<double> levels = intensity_levels(table);
    for (int j = 1; j <= table.n; j += 1 + table.n / 64) {
      // A level rounded to 2^-53, over a step of 1/n of at least I0 (1 - I0).
      ASSERT_NEAR(level_position(levels[static_cast<std::size_t>(j)], table), j, 1e-8);
    }
  }
  EXPECT_EQ(level_position(0.5, {.n = 2, .i0 = 1.0 / 16}), 1.5);
  EXPECT_EQ(level_position(4, {.n = 2, .i0 = 1.0 / 16}), 3);
  EXPECT_EQ(level_position(0, {}), 0);
  EXPECT_TRUE(std::isnan(level_position(std::nan(""), {})));
}

TEST(Levels, AgreeWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  const auto folder = *shared / "spec/colour-examples";
  for (const ExampleRow& row : example_rows(folder / "intensity_levels.csv")) {
    SCOPED_TRACE(row.text("id"));
    const LevelTable table{.n = std::stoi(row.text("n")), .i0 = row.number("I0")};
    const auto j = static_cast<std::size_t>(std::stoi(row.text("j")));
    // The file's tolerance.
    EXPECT_NEAR(intensity_levels(table)[j], row.number("I_j"), 1e-15 * row.number("I_j"));
    const GammaResponse response{.gamma = row.number("gamma")};
    EXPECT_EQ(level_codes(table, response, std::stoi(row.text("Vmax")))[j],
              std::stoi(row.text("V_j")));
  }
  for (const ExampleRow& row : example_rows(folder / "intensity_nearest.csv")) {
    SCOPED_TRACE(row.text("id"));
    const LevelTable table{.n = std::stoi(row.text("n")), .i0 = row.number("I0")};
    EXPECT_EQ(nearest_level(row.number("I"), table), std::stoi(row.text("j")));
  }
}

// Vmax I0^(1/gamma) is a half exactly: .25^(1/2) 255 = 127.5, .09^(1/2) 255 = 76.5,
// .008^(1/3) 12.5.
TEST(LevelCodes, RoundExactHalvesUp) {
  struct Half {
    double i0, gamma;
    int code_max, code;
  };
  for (const Half& half : {Half{0.25, 2, 255, 128}, Half{0.09, 2, 255, 77}, Half{0.01, 2, 255, 26},
                           Half{0.49, 2, 255, 179}, Half{0.81, 2, 255, 230},
                           Half{0.001, 3, 1005, 101}, Half{0.5, 1, 1, 1}, Half{0.1, 1, 65535, 6554},
                           Half{0.3, 1, 65535, 19661}, Half{0.7, 1, 65535, 45875}}) {
    SCOPED_TRACE(shortest(half.i0) + " " + std::to_string(half.code_max));
    const GammaResponse response{.gamma = half.gamma};
    EXPECT_EQ(level_codes({.n = 1, .i0 = half.i0}, response, half.code_max)[0], half.code);
    EXPECT_EQ(nearest_code(response, half.i0, half.code_max), half.code);
  }
}

// V_1 of I0 = .01, n = 2 is Vmax .1^(1/2), irrational: one over and one under a half by 1e-5.
TEST(LevelCodes, RoundAllElseToTheNearest) {
  for (const int code_max : {255, 1023, 4095, 65535}) {
    for (const double gamma : {1.0, 1.8, 2.2, 2.5}) {
      for (const LevelTable& table : tables()) {
        if (table.n > 255) continue;
        SCOPED_TRACE(trace(table) + " " + std::to_string(code_max) + " " + shortest(gamma));
        const std::vector<int> codes = level_codes(table, GammaResponse{gamma}, code_max);
        for (int j = 0; j <= table.n; ++j) {
          const Quad level = exact_level(table, j);
          const Quad v = level > 0 ? code_max * powq(level, 1 / decimal(gamma)) : Quad(0);
          // 1e-20: of V = .5 exactly the 113-bit value may lie below it.
          ASSERT_EQ(codes[static_cast<std::size_t>(j)],
                    static_cast<int>(floorq(v + Quad(0.5) + Quad(1e-20))));
        }
      }
    }
  }
}

TEST(LevelCodes, TakeAGivenKAndStayInTheCodes) {
  // I = K V^2 with K = 1/100^2: full light is V = 100.
  const LevelTable table{.n = 1, .i0 = 0.25};
  EXPECT_EQ(level_codes(table, GammaResponse{.gamma = 2, .k = 1e-4}, 255),
            (std::vector<int>{50, 100}));
  EXPECT_EQ(level_codes(table, GammaResponse{.gamma = 2, .k = 1e-6}, 255),
            (std::vector<int>{255, 255}));
}

TEST(LevelCodes, InvertAMeasuredResponse) {
  const TableResponse measured{{0, 64, 128, 255}, {1, 10, 40, 100}};
  const std::vector<int> codes =
      level_codes({.n = 2, .i0 = 0.1, .spacing = spacing("gamma")}, measured, 255);
  EXPECT_EQ(codes.front(), 64);
  EXPECT_EQ(codes.back(), 255);
}

RC_GTEST_PROP(LevelCodes, AreTheNearestToTheInverse, ()) {
  const double gamma = *rc::gen::inRange(100, 300) / 100.0;
  const int code_max = *rc::gen::element(15, 255, 1023, 65535);
  const int code = *rc::gen::inRange(0, code_max + 1);
  const double light = std::pow(double(code) / code_max, gamma);
  RC_ASSERT(nearest_code(GammaResponse{gamma}, light, code_max) == code);
}

TEST(LevelTable, RefusesWhatIsNoTable) {
  const auto refusal = [](const LevelTable& table) {
    return error_text([&] { intensity_levels(table); });
  };
  EXPECT_EQ(refusal({.n = 0}), "invalid: n: 0 is not in 1..65535");
  EXPECT_EQ(refusal({.n = 65536}), "invalid: n: 65536 is not in 1..65535");
  EXPECT_EQ(refusal({.i0 = 0}), "invalid: i0: 0 is not between 0 and 1");
  EXPECT_EQ(refusal({.gamma = -1}), "invalid: gamma: -1 is not above 0");
  EXPECT_EQ(refusal({.peak_cd_m2 = 0}), "invalid: peak: 0 is not above 0");
  EXPECT_EQ(refusal({.from_zero = true}), "invalid: from zero: there is no ratio to 0");
  EXPECT_EQ(refusal({.spacing = spacing("measured")}),
            "invalid: spacing: measured needs a measured response");
  EXPECT_EQ(error_text([] { nearest_level(0.5, {.i0 = 1}); }),
            "invalid: i0: 1 is not between 0 and 1");
  EXPECT_EQ(error_text([] { nearest_level(0.5, {.i0 = std::nan("")}); }),
            "invalid: i0: nan is not between 0 and 1");
  EXPECT_EQ(error_text([] { level_codes({}, GammaResponse{0}, 255); }),
            "invalid: gamma: 0 is not above 0");
  EXPECT_EQ(error_text([] { level_codes({}, GammaResponse{2}, 0); }),
            "invalid: Vmax: 0 is not above 0");
  EXPECT_EQ(error_text([] {
              level_codes({}, TableResponse{{0, 1}, {2, 1}}, 255);
            }),
            "invalid: table: luminance falls from 2 at code 0 to 1 at code 1");
}

}  // namespace
}  // namespace tristim
