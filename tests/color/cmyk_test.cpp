#include "tristim/color/cmyk.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

void expect_near(Cmyk a, Cmyk b, double tolerance) {
  EXPECT_NEAR(a.c, b.c, tolerance);
  EXPECT_NEAR(a.m, b.m, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.k, b.k, tolerance);
}

TEST(Cmyk, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/cmy_cmyk.csv")) {
    SCOPED_TRACE(row.text("id"));
    const std::string op = row.text("op");
    const Cmy in{row.number("i0"), row.number("i1"), row.number("i2")};
    const auto cell = [&](const char* name) {
      return row.text(name).empty() ? 0 : row.number(name);
    };
    const Cmyk out{cell("o0"), cell("o1"), cell("o2"), cell("o3")};
    if (op == "rgb_to_cmy") {
      const Cmy cmy = rgb_to_cmy({in.c, in.m, in.y});
      expect_near({cmy.c, cmy.m, cmy.y, 0}, out, 2e-16);
    } else if (op == "cmy_to_cmyk_subtract") {
      expect_near(cmy_to_cmyk_subtract(in), out, 2e-16);
    } else if (op == "cmy_to_cmyk_normalised") {
      expect_near(cmy_to_cmyk_normalised(in), out, 2e-16);
    } else {
      ASSERT_EQ(op, "cmyk_normalised_to_cmy");
      const Cmy cmy = cmyk_normalised_to_cmy({in.c, in.m, in.y, row.number("i3")});
      expect_near({cmy.c, cmy.m, cmy.y, 0}, out, 2e-16);
    }
  }
}

TEST(Cmyk, ReplacesAsMuchAsAskedForAndComesBack) {
  const Cmy cmy{0.75, 0.5, 0.25};
  EXPECT_EQ(cmy_to_cmyk_subtract(cmy), (Cmyk{0.5, 0.25, 0, 0.25}));
  EXPECT_EQ(cmy_to_cmyk_subtract(cmy, {.replacement = 0.5}), (Cmyk{0.625, 0.375, 0.125, 0.125}));
  EXPECT_EQ(cmy_to_cmyk_subtract(cmy, {.replacement = 0}), (Cmyk{0.75, 0.5, 0.25, 0}));
  expect_near(cmy_to_cmyk_normalised(cmy), {0.5 / 0.75, 0.25 / 0.75, 0, 0.25}, 1e-16);
  for (const double replacement : {0.0, 0.3, 1.0}) {
    const Cmy sum = cmyk_subtract_to_cmy(cmy_to_cmyk_subtract(cmy, {replacement}));
    expect_near({sum.c, sum.m, sum.y, 0}, {cmy.c, cmy.m, cmy.y, 0}, 1e-16);
    const Cmy cover = cmyk_normalised_to_cmy(cmy_to_cmyk_normalised(cmy, {replacement}));
    expect_near({cover.c, cover.m, cover.y, 0}, {cmy.c, cmy.m, cmy.y, 0}, 2e-16);
  }
}

TEST(Cmyk, BlackNeedsNoOtherInk) {
  EXPECT_EQ(cmy_to_cmyk_normalised({1, 1, 1}), (Cmyk{0, 0, 0, 1}));
  EXPECT_EQ(cmyk_normalised_to_cmy({0.3, 0.4, 0.5, 1}), (Cmy{1, 1, 1}));
}

TEST(Cmyk, KeepsToTheInkLimit) {
  const Cmyk dark = cmy_to_cmyk_subtract({1, 0.9, 0.8}, {.replacement = 0.25, .limit = 2});
  EXPECT_NEAR(dark.c + dark.m + dark.y + dark.k, 2, 1e-15);
  EXPECT_EQ(dark.k, 0.2);
  EXPECT_NEAR(dark.c / dark.m, 0.8 / 0.7, 1e-14);
  EXPECT_EQ(cmy_to_cmyk_subtract({1, 1, 1}, {.limit = 0.5}), (Cmyk{0, 0, 0, 0.5}));
  EXPECT_EQ(cmy_to_cmyk_subtract({0.5, 0, 0}, {.limit = 2}), (Cmyk{0.5, 0, 0, 0}));
}

TEST(Cmyk, NanMakesNan) {
  const double nan = std::nan("");
  const auto has_nan = [](Cmyk c) { return std::isnan(c.c + c.m + c.y + c.k); };
  for (const Cmy cmy : {Cmy{nan, 1, 1}, Cmy{1, nan, 1}, Cmy{1, 1, nan}}) {
    EXPECT_TRUE(has_nan(cmy_to_cmyk_normalised(cmy)));
    EXPECT_TRUE(has_nan(cmy_to_cmyk_subtract(cmy, {.limit = 1})));
  }
}

}  // namespace
}  // namespace tristim
