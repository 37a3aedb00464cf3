#include "tristim/color/transfer.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"

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
  EXPECT_EQ(srgb_decode(0.5), 0.21404114048223245);
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
    EXPECT_NEAR(bt1886_encode(black, black), 0, 1e-16);
    for (double v = 0.01; v < 1.2; v += 0.01) {
      // The lift is taken off again: the error is of the whole, which grows with it.
      EXPECT_NEAR(bt1886_encode(bt1886_decode(v, black), black), v, 1e-14);
    }
  }
  EXPECT_EQ(bt1886_decode(-5, 0.01), 0);
  EXPECT_TRUE(std::isnan(bt1886_decode(std::nan(""), 0.01)));
}

TEST(Bt1886, IsTheAnnexInCandelas) {
  // 50-digit arithmetic.
  EXPECT_NEAR(bt1886_decode(0.5, 100, 0.1), 21.604911167389364, 4e-15);
  EXPECT_EQ(bt1886_encode(0, 100, 0), 0);
  EXPECT_LT(bt1886_encode(0.05, 100, 0.1), 0);  // darker than black has a code below 0
  EXPECT_TRUE(std::isinf(bt1886_decode(std::numeric_limits<double>::infinity(), 100, 0.1)));
}

// 50-digit arithmetic with the constants of the publications as decimals.
TEST(TransferFunctions, HaveTheirValues) {
  struct Golden {
    std::string_view name;
    double linear, encoded;
  };
  constexpr Golden kGolden[] = {
      {"bt709", 0.5, 0.7055150899221212},      {"bt2020", 0.5, 0.70543555305561756},
      {"smpte240m", 0.5, 0.7021656255217813},  {"romm", 0.5, 0.68039500008718845},
      {"adobe", 0.5, 0.72965838176780151},     {"lstar", 0.5, 0.76069261014155565},
      {"pq", 0.5, 0.92654670408263051},        {"pq", 0.01, 0.50807842151739491},
      {"pq", 1e-07, 0.0063023770545713349},    {"hlg", 0.5, 0.87164347087417715},
      {"acescc", 0.5, 0.49771689497716892},    {"acescct", 0.5, 0.49771689497716892},
      {"acescc", 1e-05, -0.33510802126513478},
  };
  for (const Golden& row : kGolden) {
    SCOPED_TRACE(row.name);
    const TransferFunction* curve = find_by_name(kTransferFunctions, row.name);
    ASSERT_NE(curve, nullptr);
    EXPECT_NEAR(curve->encode(row.linear), row.encoded, 1.2e-16 * std::fabs(row.encoded));
    // The code is a rounded one: its half ulp comes back as the slope makes it.
    EXPECT_NEAR(curve->decode(row.encoded), row.linear, 4e-15 * std::fabs(row.linear));
  }
}

TEST(TransferFunctions, KeepEverySixteenBitCode) {
  for (const TransferFunction& curve : kTransferFunctions) {
    SCOPED_TRACE(curve.name);
    int lost = 0;
    for (int code = 0; code <= 65535; ++code) {
      const double back = curve.encode(curve.decode(code / 65535.0));
      if (std::floor(65535 * back + 0.5) == code) continue;
      ++lost;
      // As printed these two leave gaps between their lines and their powers.
      EXPECT_TRUE((curve.name == "bt709" && code >= 5309 && code <= 5324) ||
                  (curve.name == "smpte240m" && code >= 5977 && code <= 5983))
          << code;
    }
    EXPECT_EQ(lost, curve.name == "bt709" ? 16 : curve.name == "smpte240m" ? 7 : 0);
  }
}

TEST(TransferFunctions, RiseAndComeBack) {
  for (const TransferFunction& curve : kTransferFunctions) {
    SCOPED_TRACE(curve.name);
    double below = curve.encode(0);
    for (double x = 1e-6; x < 100; x *= 1.01) {
      const double e = curve.encode(x);
      EXPECT_GT(e, below);
      below = e;
      // Half an ulp of the code, as much as the slope magnifies it: PQ's most, and those of ACES
      // whose codes do not start at 0.
      if (curve.name == "bt709" || curve.name == "smpte240m") continue;  // gaps
      const double floor = curve.name.starts_with("aces") ? 1e-17 : 0;
      EXPECT_NEAR(curve.decode(e), x, 1e-14 * x + floor) << x;
    }
  }
}

TEST(TransferFunctions, PassNanAndInfinity) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const TransferFunction& curve : kTransferFunctions) {
    SCOPED_TRACE(curve.name);
    EXPECT_TRUE(std::isnan(curve.encode(std::nan(""))));
    EXPECT_TRUE(std::isnan(curve.decode(std::nan(""))));
    EXPECT_EQ(curve.decode(kInfinity), kInfinity);
    EXPECT_EQ(curve.encode(kInfinity), curve.name == "pq" ? 1.9920600818564904 : kInfinity);
    for (const double x : {1e300, -1e300, 1e-310, -1e-310, 1.7e308, -kInfinity}) {
      EXPECT_FALSE(std::isnan(curve.encode(x))) << x;
      EXPECT_FALSE(std::isnan(curve.decode(x))) << x;
    }
  }
}

TEST(TransferFunctions, AreOddOrSayWhatTheyAre) {
  for (const TransferFunction& curve : kTransferFunctions) {
    SCOPED_TRACE(curve.name);
    for (const double x : {1e-5, 0.01, 0.3, 1.0, 7.0}) {
      if (curve.domain.ends_with("odd") || curve.name == "linear") {
        EXPECT_EQ(curve.encode(-x), -curve.encode(x));
        EXPECT_EQ(curve.decode(-x), -curve.decode(x));
      } else if (curve.name == "lstar") {
        EXPECT_NEAR(curve.encode(-x), -x * 24389 / 2700, 4e-16 * x * 10);
      } else if (curve.name != "acescct") {
        EXPECT_EQ(curve.encode(-x), curve.encode(0));
      }
    }
  }
  EXPECT_LT(acescc_decode(-0.4), 0);
  EXPECT_NEAR(acescc_decode(acescc_encode(0)), 0, 1e-19);
  EXPECT_NEAR(acescct_decode(acescct_encode(-0.01)), -0.01, 1e-17);
}

TEST(Bt709, TakesThePowerAtTheJoint) {
  EXPECT_NE(bt709_encode(0.018), 4.5 * 0.018);
  EXPECT_EQ(bt709_encode(std::nextafter(0.018, 0)), 4.5 * std::nextafter(0.018, 0));
}

TEST(Bt2020, IsContinuousAtItsJoint) {
  const double beta = 0.018053968510807807;
  EXPECT_NEAR(bt2020_encode(std::nextafter(beta, 0)), bt2020_encode(std::nextafter(beta, 1)),
              3e-17);
  EXPECT_NEAR(bt2020_encode(1), 1, 0);
}

TEST(Pq, HasItsFloorAndItsPole) {
  EXPECT_EQ(pq_encode(-3), pq_encode(0));
  EXPECT_NEAR(pq_encode(0), 7.3095590257839665e-7, 1e-21);  // c1^m2
  EXPECT_EQ(pq_decode(7.3e-7), 0);
  EXPECT_EQ(pq_decode(-1), 0);
  EXPECT_EQ(pq_decode(1.9921), std::numeric_limits<double>::infinity());
  EXPECT_GT(pq_decode(1.99), 1e9);
  EXPECT_EQ(pq_decode(1), 1);
}

TEST(HlgOotf, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/hlg_ootf.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Rgb scene{row.number("i0"), row.number("i1"), row.number("i2")};
    const Rgb light = hlg_ootf(scene, row.number("Lw"));
    EXPECT_NEAR(light.r, row.number("o0"), 1e-15 * row.number("Lw"));
    EXPECT_NEAR(light.g, row.number("o1"), 1e-15 * row.number("Lw"));
    EXPECT_NEAR(light.b, row.number("o2"), 1e-15 * row.number("Lw"));
  }
}

TEST(HlgOotf, ComesBackAndKeepsBlack) {
  for (const double white : {300.0, 400.0, 1000.0, 4000.0}) {
    EXPECT_EQ(hlg_ootf({0, 0, 0}, white), (Rgb{0, 0, 0}));
    EXPECT_EQ(hlg_inverse_ootf({0, 0, 0}, white), (Rgb{0, 0, 0}));
    EXPECT_NEAR(hlg_ootf({1, 1, 1}, white).g, white, 1e-12);
    for (const Rgb& c : {Rgb{0.2, 0.7, 0.1}, Rgb{2, -0.1, 0.3}, Rgb{-0.4, -0.2, 0.1}}) {
      const Rgb back = hlg_inverse_ootf(hlg_ootf(c, white), white);
      EXPECT_NEAR(back.r, c.r, 1e-15);
      EXPECT_NEAR(back.g, c.g, 1e-15);
      EXPECT_NEAR(back.b, c.b, 1e-15);
    }
  }
  EXPECT_TRUE(std::isnan(hlg_ootf({std::nan(""), 0.2, 0.2}, 1000).r));
}

TEST(TransferFunctions, AgreeWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/transfer.csv")) {
    const std::string& name = row.text("function");
    SCOPED_TRACE(name);
    const double x = row.number("x");
    const double expected = row.number("y");
    const TransferFunction* curve =
        find_by_name(kTransferFunctions, name.substr(0, name.find('_')));
    if (name == "bt1886_eotf_Lw100_Lb0.1") {
      EXPECT_NEAR(bt1886_decode(x, 100, 0.1), expected, 1e-13 * expected);  // the file's tolerance
    } else if (name == "gamma1.8_decode") {
      EXPECT_NEAR(gamma_decode(x, 1.8), expected, 4e-16 + 4e-15 * std::fabs(expected));
    } else {
      ASSERT_NE(curve, nullptr);
      const double y = name.ends_with("_encode") ? curve->encode(x) : curve->decode(x);
      EXPECT_NEAR(y, expected, 4e-16 + 4e-15 * std::fabs(expected));
    }
  }
}

}  // namespace
}  // namespace tristim
