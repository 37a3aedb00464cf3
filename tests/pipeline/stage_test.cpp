#include "tristim/pipeline/stage.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "lib/pipeline/stage_rows.h"
#include "tristim/color/oklab.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

using Pixel = std::array<float, 3>;

constexpr float kInfinity = std::numeric_limits<float>::infinity();

Pixel applied(const Stage& stage, Pixel pixel, StageCounts* counts = nullptr) {
  StageCounts ignored;
  apply(stage, {{pixel.data(), 1, 1, 3, 3}, 0}, counts != nullptr ? *counts : ignored);
  return pixel;
}

// A device of other primaries than sRGB, so that the matrix in the stage counts.
GamutMap desaturate_for(const Primaries& device) {
  return {kDesaturate, rgb_from_rgb({}, device, Adaptation::kBradford)};
}

TEST(Exposure, MultipliesByAPowerOfTwo) {
  EXPECT_EQ(applied(Exposure{1}, {0.25F, -1, 3}), (Pixel{0.5F, -2, 6}));
  EXPECT_EQ(applied(Exposure{-2}, {4, 1, 0}), (Pixel{1, 0.25F, 0}));
  EXPECT_EQ(applied(Exposure{0}, {0.1F, 0.2F, 0.3F}), (Pixel{0.1F, 0.2F, 0.3F}));
}

TEST(Exposure, ReachesEveryPixelOfABandWithGaps) {
  std::vector<float> samples(2 * 10, 1);
  StageCounts counts;
  apply(Exposure{1}, {{samples.data(), 2, 2, 3, 10}, 5}, counts);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(samples[i], i % 10 < 6 ? 2 : 1) << i;
}

// [Reinhard02 eq 4] by hand.
TEST(Reinhard, FollowsTheFormula) {
  EXPECT_EQ(reinhard_luminance(1.0F, 0.0F), 0.5F);
  EXPECT_EQ(reinhard_luminance(3.0F, 0.0F), 0.75F);
  EXPECT_FLOAT_EQ(reinhard_luminance(1.0F, 2.0F), 0.625F);  // 1 (1 + 1/4)/2
  EXPECT_FLOAT_EQ(reinhard_luminance(8.0F, 8.0F), 1);       // the white becomes 1
  EXPECT_FLOAT_EQ(reinhard_luminance(0.18F, 4.0F), 0.18F * (1 + 0.18F / 16) / 1.18F);
  EXPECT_DOUBLE_EQ(reinhard_luminance(0.18, 4.0), 0.18 * (1 + 0.18 / 16) / 1.18);
}

TEST(ToneMap, KeepsTheChromaticity) {
  const ToneMap stage{.white = 4, .luminance = {0.2126, 0.7152, 0.0722}};
  const Pixel in{4, 2, 1};
  const Pixel out = applied(stage, in);
  const float luminance = 0.2126F * 4 + 0.7152F * 2 + 0.0722F;
  const float gain = reinhard_luminance(luminance, 4) / luminance;
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(out[c], gain * in[c], 1e-6);
  EXPECT_EQ(applied(stage, {0, 0, 0}), (Pixel{0, 0, 0}));
  EXPECT_EQ(applied(stage, {-1, -1, 0}), (Pixel{-1, -1, 0}));  // no luminance to map
}

TEST(ToneMap, RisesAndStaysBelowItsWhite) {
  for (const ToneOperator& tone : kToneOperators) {
    float before = 0;
    for (float luminance = 1e-4F; luminance < 1e4F; luminance *= 1.1F) {
      const float mapped = tone.luminance(luminance, 0);
      EXPECT_GT(mapped, before) << tone.name;
      EXPECT_LT(mapped, 1) << tone.name;
      before = mapped;
    }
  }
}

TEST(ConvertPrimaries, IsTheMatrix) {
  Eigen::Matrix3d m;
  m << 0.5, 0.25, 0, 0, 1, 0, 1, 0, -1;
  EXPECT_EQ(applied(ConvertPrimaries{.matrix = m}, {1, 2, 3}), (Pixel{1, 2, -2}));
  EXPECT_EQ(applied(ConvertPrimaries{}, {0.1F, 7, -3}), (Pixel{0.1F, 7, -3}));
}

TEST(GamutMap, ClipsEachChannelAndCounts) {
  StageCounts counts;
  EXPECT_EQ(applied(GamutMap{}, {-0.5F, 0.5F, 2}, &counts), (Pixel{0, 0.5F, 1}));
  EXPECT_EQ(counts, (StageCounts{.out_of_gamut = 1, .clipped = 1}));
  applied(GamutMap{}, {0, 0.5F, 1}, &counts);
  applied(GamutMap{}, {-1, -1, 0.5F}, &counts);
  EXPECT_EQ(counts, (StageCounts{.out_of_gamut = 2, .clipped = 1}));
}

RC_GTEST_PROP(GamutMap, LeavesColoursInsideAloneToTheBit, ()) {
  const auto part = [] { return static_cast<float>(*rc::gen::inRange(0, 10001)) / 10000.0F; };
  const Pixel in{part(), part(), part()};
  for (const GamutMethod& method : kGamutMethods) {
    if (!method.keeps_inside) continue;
    StageCounts counts;
    const Pixel out = applied(GamutMap{method}, in, &counts);
    RC_ASSERT(out == in || !method.keeps_inside);
    RC_ASSERT(counts == StageCounts{});
  }
}

TEST(GamutMap, LeavesNothingOutside) {
  const float odd[] = {-kInfinity, -1e30F,  -5,    -1e-9F, 0,         0.5F,
                       1,          1.0001F, 70000, 1e30F,  kInfinity, std::nanf("")};
  for (const GamutMethod& method : kGamutMethods) {
    for (const float r : odd) {
      for (const float g : odd) {
        for (const float b : odd) {
          for (const float c : applied(GamutMap{method}, {r, g, b})) {
            ASSERT_TRUE(c >= 0 && c <= 1) << method.name << " " << r << " " << g << " " << b;
          }
        }
      }
    }
  }
}

struct Oklch {
  double l, c, h_deg;
};

Oklch oklch(const Eigen::Vector3d& srgb) {
  const Oklab lab = linear_srgb_to_oklab({srgb.x(), srgb.y(), srgb.z()});
  return {lab.l, std::hypot(lab.a, lab.b), std::atan2(lab.b, lab.a) * 180 / std::numbers::pi};
}

// The bounds that gamut mapping must keep: hue within 1 degree, lightness within .02.
TEST(Desaturate, KeepsHueAndLightness) {
  std::mt19937 random(1);
  const Primaries devices[] = {{}, find_by_name(primaries_list(), "p22-nec-c400")->primaries};
  for (const Primaries& device : devices) {
    const GamutMap stage = desaturate_for(device);
    for (int i = 0; i < 20000; ++i) {
      const double scale = std::exp2(std::uniform_real_distribution(-12.0, 0.0)(random));
      Eigen::Vector3d wanted;
      for (int c = 0; c < 3; ++c)
        wanted[c] = scale * std::uniform_real_distribution(-0.6, 1.2)(random);
      const Oklch before = oklch(stage.srgb_from_device * wanted);
      if (before.l < 0 || before.l > 1) continue;  // no such lightness inside
      const Pixel out =
          applied(stage, {static_cast<float>(wanted[0]), static_cast<float>(wanted[1]),
                          static_cast<float>(wanted[2])});
      const Oklch after = oklch(stage.srgb_from_device * Eigen::Vector3d(out[0], out[1], out[2]));
      SCOPED_TRACE(testing::Message() << wanted.transpose());
      ASSERT_NEAR(after.l, before.l, 0.02);
      if (after.c < 0.005) continue;  // hardly a hue
      ASSERT_LE(std::fabs(std::remainder(after.h_deg - before.h_deg, 360)), 1);
    }
  }
}

TEST(Desaturate, OverbrightBecomesWhiteAndBelowBlackBlack) {
  const GamutMap stage{kDesaturate};
  for (const float c : applied(stage, {5, 5, 5})) EXPECT_NEAR(c, 1, 1e-5);
  for (const float c : applied(stage, {-1, -1, -1})) EXPECT_NEAR(c, 0, 1e-5);
}

TEST(Explain, NamesEveryStageWithItsNumbers) {
  const StepReport exposure = explain(Exposure{2});
  EXPECT_EQ(exposure.name, "exposure");
  EXPECT_EQ(exposure.numbers[1], (std::pair<std::string, std::string>{"factor", "4"}));
  EXPECT_EQ(explain(ToneMap{.white = 8}).numbers[0].second, "8");
  EXPECT_EQ(explain(ConvertPrimaries{}).numbers.size(), 6U);
  for (const GamutMethod& method : kGamutMethods) {
    EXPECT_EQ(explain(GamutMap{method}).name, "gamut map " + std::string(method.name));
  }
}

TEST(StageKernels, AreTheDefinitionInEveryInstructionSet) {
  const float odd[] = {-kInfinity, -1e-9F, -0.0F, 0, 1e-40F, 0.5F, 1, 1.0000001F, 65504, kInfinity};
  Eigen::Matrix3f full;
  full << 1.2F, -0.3F, 0.1F, 0.01F, 0.9F, 0.09F, -0.5F, 0.2F, 1.3F;
  const detail::RowMatrix m({full});
  const detail::StageKernels& scalar = detail::scalar_stage_kernels();
  for (const std::size_t pixels : {1U, 4U, 7U, 16U, 33U, 100U}) {
    std::vector<float> row(3 * pixels);
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = odd[i * 7 % std::size(odd)];
    std::vector<float> clipped = row;
    const StageCounts counts = scalar.clip(clipped.data(), pixels);
    std::vector<float> multiplied = clipped;
    scalar.multiply(m, multiplied.data(), pixels);
    for (const detail::StageKernels& simd : detail::simd_stage_kernels()) {
      std::vector<float> actual = row;
      EXPECT_EQ(simd.clip(actual.data(), pixels), counts) << simd.name;
      EXPECT_EQ(actual, clipped) << simd.name;
      simd.multiply(m, actual.data(), pixels);
      EXPECT_EQ(actual, multiplied) << simd.name;
    }
  }
}

TEST(StageKernels, ClipMakesNanZero) {
  std::vector<float> row(3 * 40, std::nanf(""));
  detail::stage_kernels().clip(row.data(), 40);
  EXPECT_EQ(row, std::vector<float>(3 * 40));
}

}  // namespace
}  // namespace tristim
