#include "tristim/color/munsell.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>

#include "tests/color/srgb_munsell.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/munsell_value.h"

namespace tristim {
namespace {

struct Cell {
  double hue, value, chroma, x, y;
  int real;
};

constexpr Cell kCells[] = {
#include "luts/munsell_renotation.csv"
};

bool has_value(const Xyy& xyy) { return !std::isnan(xyy.x) && !std::isnan(xyy.luminance); }
bool has_value(const Munsell& m) { return !std::isnan(m.value) && !std::isnan(m.chroma); }

double hue_distance(double a, double b) { return std::fabs(std::remainder(a - b, 100)); }

double xy_distance(const Xyy& a, const Xyy& b) { return std::hypot(a.x - b.x, a.y - b.y); }

// Between two published implementations, either counts.
TEST(MunsellToXyy, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/munsell_to_xyy.csv")) {
    SCOPED_TRACE(row.text("notation"));
    const Xyy xyy = munsell_to_xyy({row.number("H"), row.number("V"), row.number("C")});
    const double tolerance = row.text("kind") == "node" ? 1e-15 : row.number("tol_xy");
    const double first =
        std::max(std::fabs(xyy.x - row.number("x")), std::fabs(xyy.y - row.number("y")));
    const double second =
        std::max(std::fabs(xyy.x - row.number("x2")), std::fabs(xyy.y - row.number("y2")));
    EXPECT_LE(std::min(first, second), tolerance);
    EXPECT_NEAR(100 * xyy.luminance, row.number("Y"), 1e-8);  // eight decimals are given
  }
}

TEST(XyyToMunsell, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/xyy_to_munsell.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Munsell m = xyy_to_munsell({row.number("x"), row.number("y"), row.number("Y") / 100});
    EXPECT_LE(std::min(hue_distance(m.hue, row.number("H")), hue_distance(m.hue, row.number("H2"))),
              row.number("tol_H"));
    EXPECT_NEAR(m.value, row.number("V"), row.number("tol_V"));
    EXPECT_LE(
        std::min(std::fabs(m.chroma - row.number("C")), std::fabs(m.chroma - row.number("C2"))),
        row.number("tol_C"));
  }
}

// By the program that [Centore12] describes, as colour-science 0.4.6 has it.
TEST(MunsellToXyy, InterpolatesAsCentore) {
  const struct {
    Munsell munsell;
    double x, y, tolerance;
  } rows[] = {
      {{41.85, 8.79, 10.83}, 0.28910888567496523, 0.4460322660522436, 5e-16},
      {{86.97, 6.45, 12.65}, 0.30361572350189486, 0.21980287664960568, 5e-16},
      {{32.1, 8, 17.9}, 0.4400632, 0.5522428, 1e-7},
      {{14.2, 8.1, 5.3}, 0.3873694, 0.3575165, 1e-7},
  };
  for (const auto& row : rows) {
    const Xyy xyy = munsell_to_xyy(row.munsell);
    EXPECT_NEAR(xyy.x, row.x, row.tolerance);
    EXPECT_NEAR(xyy.y, row.y, row.tolerance);
  }
}

TEST(MunsellToXyy, HasEveryCellExactly) {
  int real = 0;
  for (const Cell& cell : kCells) {
    const Xyy xyy = munsell_to_xyy({cell.hue, cell.value, cell.chroma});
    ASSERT_EQ(xyy.x, cell.x) << cell.hue << " " << cell.value << "/" << cell.chroma;
    ASSERT_EQ(xyy.y, cell.y);
    ASSERT_EQ(xyy.luminance, luminance_from_munsell_value(cell.value));
    real += cell.real;
  }
  EXPECT_EQ(real, 2734);
}

TEST(XyyToMunsell, FindsEveryRealCell) {
  for (const Cell& cell : kCells) {
    if (cell.real == 0) continue;
    SCOPED_TRACE(std::to_string(cell.hue) + " " + std::to_string(cell.value));
    const Munsell m = xyy_to_munsell({cell.x, cell.y, luminance_from_munsell_value(cell.value)});
    ASSERT_NEAR(m.hue, cell.hue, 1e-9);
    ASSERT_NEAR(m.value, cell.value, 1e-13);
    ASSERT_NEAR(m.chroma, cell.chroma, 1e-9);
  }
}

// Colours that surfaces can have, anywhere in the table.
TEST(XyyToMunsell, OfRandomRealColorsComesBack) {
  std::mt19937 random(17);
  std::uniform_real_distribution<double> unit(0, 1);
  int found = 0;
  for (int i = 0; i < 100000; ++i) {
    const Munsell m{100 * unit(random), 10 * unit(random), 40 * unit(random) * unit(random)};
    const Xyy xyy = munsell_to_xyy(m);
    if (!has_value(xyy)) continue;
    const Munsell back = xyy_to_munsell(xyy);
    if (!has_value(back)) {
      ASSERT_NE(munsell_refusal(xyy).find("MacAdam"), std::string::npos);
      continue;
    }
    ++found;
    // Largest error measured, over a million: 7e-16.
    ASSERT_LT(xy_distance(munsell_to_xyy(back), xyy), 1e-12);
    ASSERT_NEAR(back.value, m.value, 1e-13);
  }
  EXPECT_GT(found, 40000);
}

TEST(XyyToMunsell, HasAValueForAllOfSrgb) {
  for (int red = 0; red < 256; red += 17) {
    for (int green = 0; green < 256; green += 17) {
      for (int blue = 0; blue < 256; blue += 17) {
        const Munsell m = srgb_munsell(red, green, blue);
        ASSERT_TRUE(has_value(m)) << red << " " << green << " " << blue;
        if (red == green && green == blue) ASSERT_EQ(m.chroma, 0) << red;
      }
    }
  }
}

TEST(XyyToMunsell, KeepsTheNeutralAxis) {
  for (int i = 0; i <= 1000; ++i) {
    const double value = i / 100.0;
    const Xyy xyy = munsell_to_xyy({std::nan(""), value, 0});
    ASSERT_EQ(xyy.x, kMunsellWhite.x);
    ASSERT_EQ(xyy.y, kMunsellWhite.y);
    const Munsell m = xyy_to_munsell(xyy);
    ASSERT_TRUE(std::isnan(m.hue));
    ASSERT_EQ(m.chroma, 0);
    ASSERT_NEAR(m.value, value, 1e-13);
  }
  EXPECT_TRUE(same(xyy_to_munsell({std::nan(""), std::nan(""), 0}), {std::nan(""), 0, 0}));
  EXPECT_TRUE(same(xyy_to_munsell({0.31006 + 1e-10, 0.31616, 0.2}),
                   {std::nan(""), munsell_value_from_luminance(0.2), 0}));
}

TEST(MunsellToXyy, ReadsHuesModulo100) {
  const Xyy xyy = munsell_to_xyy({97.3, 5.5, 7});
  for (const double turns : {-200.0, -100.0, 100.0, 300.0}) {
    EXPECT_LT(xy_distance(munsell_to_xyy({97.3 + turns, 5.5, 7}), xyy), 1e-14);
  }
  EXPECT_EQ(munsell_to_xyy({0, 5, 4}), munsell_to_xyy({100, 5, 4}));
}

TEST(MunsellToXyy, HasNoValueOutside) {
  const double nan = std::nan("");
  for (const Munsell m : {Munsell{5, 10.01, 2},
                          {5, -0.1, 2},
                          {17.5, 5, 40},
                          {5, 5, -1},
                          {5, 5, 1e300},
                          {nan, 5, 2},
                          {5, nan, 2},
                          {5, 5, nan},
                          {HUGE_VAL, 5, 2},
                          {5, 5, HUGE_VAL}}) {
    EXPECT_TRUE(std::isnan(munsell_to_xyy(m).x)) << munsell_notation(m);
    EXPECT_TRUE(std::isnan(munsell_to_xyy(m).luminance));
    EXPECT_FALSE(munsell_refusal(m).empty());
  }
  EXPECT_EQ(munsell_refusal(Munsell{17.5, 5, 40}),
            "Munsell chroma 40 is beyond the renotation, which ends at 16 there");
  EXPECT_EQ(munsell_refusal(Munsell{17.5, 11, 4}), "Munsell value 11 is not between 0 and 10");
  EXPECT_EQ(munsell_refusal(Munsell{17.5, 5, 4}), "");
}

TEST(XyyToMunsell, HasNoValueOutside) {
  const double nan = std::nan("");
  for (const Xyy xyy : {Xyy{0.1, 0.8, 0.9},
                        {0.3, 0.3, 1.01},
                        {0.3, 0.3, -0.1},
                        {nan, 0.3, 0.5},
                        {0.3, nan, 0.5},
                        {0.3, 0.3, nan},
                        {HUGE_VAL, 0.3, 0.5},
                        {0.3, 1e300, 0.5},
                        {0.5, 0.4, 0.95},
                        {-1, -1, 0.5},
                        {0.3, 0.3, HUGE_VAL}}) {
    EXPECT_FALSE(has_value(xyy_to_munsell(xyy))) << xyy.x << " " << xyy.y << " " << xyy.luminance;
    EXPECT_FALSE(munsell_refusal(xyy).empty());
  }
  EXPECT_NE(munsell_refusal(Xyy{0.5, 0.4, 0.95}).find("outside the MacAdam limits"),
            std::string::npos);
}

TEST(MunsellLargestChroma, IsThatOfTheTable) {
  EXPECT_EQ(munsell_largest_chroma(17.5, 5), 16);
  EXPECT_EQ(munsell_largest_chroma(17.5, 1), 6);
  EXPECT_TRUE(std::isnan(munsell_largest_chroma(17.5, 11)));
  for (const Cell& cell : kCells) {
    ASSERT_LE(cell.chroma, munsell_largest_chroma(cell.hue, cell.value));
  }
}

}  // namespace
}  // namespace tristim
