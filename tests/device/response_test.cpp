#include "tristim/device/response.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace tristim {
namespace {

constexpr double kCodeMax = 255;

const TableResponse kMeasured{{0, 10, 100, 200, 255}, {0.5, 1, 20, 70, 100}};

std::vector<std::pair<const char*, Response>> responses() {
  return {{"srgb", SrgbResponse{}},
          {"linear", LinearResponse{}},
          {"gamma 1.8", GammaResponse{.gamma = 1.8}},
          {"gamma 2.4, i0", GammaResponse{.gamma = 2.4, .i0 = 0.02}},
          {"gamma 2.2, k", GammaResponse{.gamma = 2.2, .k = std::pow(kCodeMax, -2.2)}},
          {"bt1886", Bt1886Response{}},
          {"bt1886, black", Bt1886Response{0.01}},
          {"gog", GogResponse{.gamma = 2.1, .offset = 0.05, .black = 0.001}},
          {"table", kMeasured}};
}

TEST(Response, RisesFromBlackToOne) {
  for (const auto& [name, response] : responses()) {
    SCOPED_TRACE(name);
    double before = -1;
    for (double code = 0; code <= kCodeMax; code += 0.25) {
      const double light = light_of_code(response, code, kCodeMax);
      ASSERT_GT(light, before);
      before = light;
    }
    EXPECT_NEAR(before, 1, 1e-14);
    EXPECT_GE(light_of_code(response, 0, kCodeMax), 0);
  }
}

TEST(Response, CodesComeBackFromTheirLight) {
  for (const auto& [name, response] : responses()) {
    SCOPED_TRACE(name);
    for (double code = 0; code <= kCodeMax; code += 0.25) {
      const double light = light_of_code(response, code, kCodeMax);
      // i0 and the lift of BT.1886 cancel near black, where the curves are flattest: at code 1/4
      // light above i0 = .02 is 6e-8 of the white, known to 3e-18.
      ASSERT_NEAR(code_of_light(response, light, kCodeMax), code, 1e-10) << code;
    }
  }
}

TEST(Response, HoldsTheEndsOutside) {
  for (const auto& [name, response] : responses()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(code_of_light(response, -1, kCodeMax), 0);
    EXPECT_EQ(code_of_light(response, 2, kCodeMax), kCodeMax);
    EXPECT_EQ(light_of_code(response, 300, kCodeMax), 1);
    EXPECT_GE(light_of_code(response, -10, kCodeMax), 0);
  }
}

TEST(GammaResponse, IsTheDocumentsFormula) {
  EXPECT_DOUBLE_EQ(light_of_code(GammaResponse{.gamma = 2}, 51, 255), 0.04);
  EXPECT_DOUBLE_EQ(light_of_code(GammaResponse{.gamma = 2, .i0 = 0.1}, 51, 255), 0.1 + 0.9 * 0.04);
  EXPECT_DOUBLE_EQ(light_of_code(GammaResponse{.gamma = 2, .k = 1e-5}, 100, 255), 0.1);
  EXPECT_EQ(light_of_code(GammaResponse{.gamma = 2, .i0 = 0.1}, 0, 255), 0.1);
  EXPECT_EQ(code_of_light(GammaResponse{.gamma = 2, .i0 = 0.1}, 0.05, 255), 0);
}

TEST(SrgbResponse, HasTheCurvesMiddle) {
  // [IEC61966] 128/255 in 50 digits.
  EXPECT_NEAR(light_of_code(SrgbResponse{}, 128, 255), 0.21586050011389915, 1e-16);
}

// Berns' formula by hand: ((1 - .2) 127.5/255 + .2)^2 = .36, of which .1 is black.
TEST(GogResponse, IsGainOffsetGamma) {
  const GogResponse lifted{.gamma = 2, .offset = 0.2, .black = 0.1};
  EXPECT_DOUBLE_EQ(light_of_code(lifted, 127.5, 255), 0.1 + 0.9 * 0.36);
  EXPECT_DOUBLE_EQ(light_of_code(lifted, 0, 255), 0.1 + 0.9 * 0.04);
  // Below the offset nothing lights: codes up to Vmax/5 are as dark as 0.
  const GogResponse dead{.gamma = 2, .offset = -0.25};
  EXPECT_EQ(light_of_code(dead, 51, 255), 0);
  EXPECT_GT(light_of_code(dead, 52, 255), 0);
  EXPECT_EQ(code_of_light(dead, 0, 255), 0);
  EXPECT_NEAR(code_of_light(dead, 0.25, 255), 255 * 0.6, 1e-12);
}

TEST(GogResponse, WithGamma24IsBt1886) {
  const GogResponse gog{.gamma = 2.4, .offset = std::pow(0.01, 1 / 2.4)};
  for (double code = 0; code <= kCodeMax; code += 5) {
    EXPECT_NEAR(light_of_code(gog, code, kCodeMax),
                light_of_code(Bt1886Response{0.01}, code, kCodeMax), 1e-15);
  }
}

TEST(TableResponse, CountsItsOwnCodes) {
  const TableResponse eight{{0, 128, 255}, {0, 20, 100}, 255};
  EXPECT_DOUBLE_EQ(light_of_code(eight, 63, 63), 1);
  EXPECT_DOUBLE_EQ(light_of_code(eight, 128.0 / 255 * 63, 63), 0.2);
  EXPECT_DOUBLE_EQ(code_of_light(eight, 0.2, 63), 128.0 / 255 * 63);
}

TEST(TableResponse, JoinsItsPointsByAMonotoneSpline) {
  EXPECT_EQ(light_of_code(kMeasured, 0, kCodeMax), 0.005);
  EXPECT_EQ(light_of_code(kMeasured, 200, kCodeMax), 0.7);
  const double between = light_of_code(kMeasured, 150, kCodeMax);
  EXPECT_DOUBLE_EQ(code_of_light(kMeasured, between, kCodeMax), 150);
}

TEST(TableResponse, HoldsItsEndsWhereItDoesNotSpanTheCodes) {
  const TableResponse inner{{16, 235}, {1, 50}};
  EXPECT_EQ(light_of_code(inner, 0, kCodeMax), 0.02);
  EXPECT_EQ(light_of_code(inner, 255, kCodeMax), 1);
}

TEST(Describe, GivesTheFormulaWithItsNumbers) {
  EXPECT_EQ(describe(SrgbResponse{}),
            "sRGB: E = 12.92 L up to .0031308, else 1.055 L^(1/2.4) - .055");
  EXPECT_EQ(describe(LinearResponse{}), "linear: I = V / Vmax");
  EXPECT_EQ(describe(GammaResponse{.gamma = 2.3, .i0 = 0.02}),
            "gamma: I = i0 + (1 - i0) K V^gamma, gamma = 2.3, i0 = 0.02, K = Vmax^-gamma");
  EXPECT_EQ(describe(GammaResponse{.k = 1e-5}),
            "gamma: I = i0 + (1 - i0) K V^gamma, gamma = 2.2, i0 = 0, K = 1e-05");
  EXPECT_EQ(describe(Bt1886Response{0.001}), "BT.1886: I = a max(V + b, 0)^2.4, black = 0.001");
  EXPECT_EQ(describe(kMeasured), "measured table of 5 codes, a monotone spline between");
}

}  // namespace
}  // namespace tristim
