#include "tristim/color/transfer.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"

namespace tristim {
namespace {

TEST(Srgb, EverySixteenBitCodeComesBack) {
  for (int code = 0; code <= 65535; ++code) {
    ASSERT_EQ(std::floor(65535 * srgb_encode(srgb_decode(code / 65535.0)) + 0.5), code);
  }
}

// [IEC61966]: the printed constants leave a step of 3e-8 at the joint.
TEST(Srgb, TakesTheStraightLineUpToAndWithTheJunction) {
  EXPECT_EQ(srgb_encode(0.0031308), 12.92 * 0.0031308);
  EXPECT_EQ(srgb_decode(0.04045), 0.04045 / 12.92);
  const double above = std::nextafter(0.0031308, 1);
  EXPECT_NE(srgb_encode(above), 12.92 * above);
  EXPECT_NEAR(srgb_encode(above), 12.92 * above, 3e-8);
  const double code_above = std::nextafter(0.04045, 1);
  EXPECT_NE(srgb_decode(code_above), code_above / 12.92);
  EXPECT_NEAR(srgb_decode(code_above), code_above / 12.92, 3e-8);
}

TEST(Srgb, HasThePublishedValues) {
  EXPECT_EQ(srgb_encode(0), 0);
  EXPECT_NEAR(srgb_encode(1), 1, 2e-16);
  EXPECT_NEAR(srgb_decode(1), 1, 2e-16);
  // 50-digit arithmetic.
  EXPECT_NEAR(srgb_encode(0.5), 0.73535698305244951, 2e-16);
  EXPECT_NEAR(srgb_decode(0.5), 0.21404114048223255, 1e-16);
}

TEST(Srgb, GoesOnBeyondOneAndIsOddBelowZero) {
  EXPECT_NEAR(srgb_encode(4), 1.055 * std::pow(4, 1 / 2.4) - 0.055, 4e-16);
  for (const double x : {0.001, 0.2, 1.0, 3.0}) {
    EXPECT_EQ(srgb_encode(-x), -srgb_encode(x));
    EXPECT_EQ(srgb_decode(-x), -srgb_decode(x));
  }
  EXPECT_TRUE(std::isinf(srgb_encode(std::numeric_limits<double>::infinity())));
  EXPECT_TRUE(std::isnan(srgb_encode(std::nan(""))));
  EXPECT_TRUE(std::isnan(srgb_decode(std::nan(""))));
}

RC_GTEST_PROP(Gamma, ComesBack, ()) {
  const double x = *rc::gen::inRange(-40000, 40001) / 2e4;
  const double gamma = *rc::gen::inRange(20, 400) / 100.0;
  // 1/gamma carries half an ulp, which ln x, below 10 here, magnifies.
  RC_ASSERT(std::fabs(gamma_decode(gamma_encode(x, gamma), gamma) - x) <= 4e-15 * std::fabs(x));
  RC_ASSERT(gamma_encode(-x, gamma) == -gamma_encode(x, gamma));
}

TEST(Gamma, IsThePlainPower) {
  EXPECT_EQ(gamma_decode(0.5, 2), 0.25);
  EXPECT_EQ(gamma_encode(0.25, 2), 0.5);
  EXPECT_EQ(gamma_decode(-0.5, 2), -0.25);
  EXPECT_TRUE(std::isnan(gamma_decode(std::nan(""), 2.2)));
}

TEST(Bt1886, SpansBlackToWhite) {
  for (const double black : {0.0, 0.0001, 0.01, 0.5}) {
    SCOPED_TRACE(black);
    EXPECT_NEAR(bt1886_decode(0, black), black, 1e-15);
    EXPECT_NEAR(bt1886_decode(1, black), 1, 1e-14);
    EXPECT_EQ(bt1886_encode(black, black), 0);
    EXPECT_EQ(bt1886_encode(black / 2, black), 0);
    for (double v = 0.01; v < 1.2; v += 0.01) {
      // The lift is taken off again: the error is of the whole, which grows with it.
      EXPECT_NEAR(bt1886_encode(bt1886_decode(v, black), black), v, 1e-14);
    }
  }
  EXPECT_EQ(bt1886_decode(-5, 0.01), 0);
  EXPECT_TRUE(std::isnan(bt1886_decode(std::nan(""), 0.01)));
}

TEST(TransferFunctions, AgreeWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  int compared = 0;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/transfer.csv")) {
    const std::string& name = row.text("function");
    const double x = row.number("x");
    const double expected = row.number("y");
    double y = 0;
    double tolerance = 4e-16 + 4e-15 * std::fabs(expected);  // the file's
    if (name == "srgb_encode") {
      y = srgb_encode(x);
    } else if (name == "srgb_decode") {
      y = srgb_decode(x);
    } else if (name == "gamma1.8_decode") {
      y = gamma_decode(x, 1.8);
    } else if (name == "bt1886_eotf_Lw100_Lb0.1") {
      y = 100 * bt1886_decode(x, 0.1 / 100);
      tolerance = 1e-13 * expected;
    } else {
      continue;
    }
    SCOPED_TRACE(name);
    EXPECT_NEAR(y, expected, tolerance);
    ++compared;
  }
  EXPECT_GT(compared, 0);
}

}  // namespace
}  // namespace tristim
