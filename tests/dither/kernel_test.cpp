#include "tristim/dither/kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tristim/core/find.h"

namespace tristim {
namespace {

TEST(DiffusionKernels, ShareOutAllOfTheErrorButForAtkinson) {
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    SCOPED_TRACE(kernel.name);
    EXPECT_EQ(passed_on(kernel), kernel.name == "atkinson" ? 0.75 : 1);
  }
}

TEST(DiffusionKernels, SendNothingBackwards) {
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    SCOPED_TRACE(kernel.name);
    for (std::size_t column = 0; column <= 3; ++column) EXPECT_EQ(kernel.weight[0][column], 0);
  }
}

TEST(DiffusionKernels, HaveNamesOfTheirOwn) {
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    EXPECT_EQ(find_by_name(kDiffusionKernels, kernel.name), &kernel);
    EXPECT_FALSE(kernel.source.empty());
  }
}

TEST(ToneWeights, SumToOneAtEveryTone) {
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    if (kernel.tones == nullptr) continue;
    SCOPED_TRACE(kernel.name);
    const auto tones = kernel.tones();
    ASSERT_EQ(tones.size(), std::size_t{kTones});
    for (const ToneWeights& w : tones) {
      EXPECT_NEAR(w.next + w.below_last + w.below, 1, 2e-7);
      EXPECT_GE(std::min({w.next, w.below_last, w.below, w.raise}), 0);
    }
  }
}

// The same weights for a tone and its negative.
TEST(ToneWeights, AreTakenByTheNearestOf256Levels) {
  EXPECT_EQ(tone_index(0), 0U);
  EXPECT_EQ(tone_index(1), 0U);
  EXPECT_EQ(tone_index(-3), 0U);
  EXPECT_EQ(tone_index(3), 0U);
  EXPECT_EQ(tone_index(127 / 255.0F), 127U);
  EXPECT_EQ(tone_index(128 / 255.0F), 127U);
  EXPECT_EQ(tone_index(10.4F / 255), 10U);
  EXPECT_EQ(tone_index(1 - 10.4F / 255), 10U);
}

void expect_weights(const ToneWeights& got, double next, double below_last, double below) {
  const double all = next + below_last + below;
  EXPECT_NEAR(got.next, next / all, 1e-6);
  EXPECT_NEAR(got.below_last, below_last / all, 1e-6);
  EXPECT_NEAR(got.below, below / all, 1e-6);
}

TEST(Ostromoukhov, HasThePublishedWeights) {  // [Ostromoukhov01], the table of the program
  const auto tones = ostromoukhov_tones();
  expect_weights(tones[0], 13, 0, 5);
  expect_weights(tones[11], 501, 224, 211);
  expect_weights(tones[64], 1, 1, 0);
  expect_weights(tones[72], 5, 7, 1);
  expect_weights(tones[95], 5, 3, 2);
  expect_weights(tones[127], 4, 1, 1);
}

// [ZhouFang03] table 1, and the interpolated table of the authors' program between its levels.
TEST(ZhouFang, HasThePublishedWeights) {
  const auto tones = zhou_fang_tones();
  expect_weights(tones[0], 13, 0, 5);
  expect_weights(tones[7], 579711, 113951, 306337);
  expect_weights(tones[42], 444960, 331142, 223897);
  expect_weights(tones[68], 374445, 485317, 140236);
  expect_weights(tones[90], 349913, 355038, 295047);
  expect_weights(tones[127], 35269, 36066, 28664);
}

TEST(ZhouFang, RaisesTheThresholdByTone) {
  const auto tones = zhou_fang_tones();
  const auto percent = [&](std::size_t level) {
    return static_cast<double>(tones[level].raise) * 255 / 127 * 100;
  };
  EXPECT_NEAR(percent(0), 0, 1e-4);
  EXPECT_NEAR(percent(44), 34, 1e-4);
  EXPECT_NEAR(percent(64), 50, 1e-4);
  EXPECT_NEAR(percent(72), 75, 1);  // the program cuts to whole per cent
  EXPECT_NEAR(percent(90), 58, 1);
  EXPECT_NEAR(percent(127), 100, 1e-4);
}

}  // namespace
}  // namespace tristim
