// The codes of floats in every instruction set. Those around each threshold always; all floats from
// 0 to 1 where the environment's TRISTIM_FULL_SWEEP is set, which takes an hour.
#include <gtest/gtest.h>

#include <bit>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>

#include "lib/dither/ordered_kernels.h"
#include "lib/dither/step_table.h"
#include "tristim/color/transfer.h"
#include "tristim/device/display.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

using Codes = std::vector<std::uint16_t>;

constexpr std::int32_t kOne = std::bit_cast<std::int32_t>(1.0F);
constexpr std::int32_t kNear = 1000;  // floats on either side of a threshold

struct Scale {
  std::string name;
  std::vector<float> threshold;
  Codes code;
};

Scale scale_of(const std::string& name, const Display& display) {
  const LevelScale scale = level_scale(display, 8, BlackPoint::kRelative);
  return {name, scale.threshold, scale.nearest};
}

// No device answers with PQ: the first floats of its 8-bit codes, light 1 at 10000 cd/m2.
Scale pq_scale() {
  Scale scale{"pq", {}, Codes(256)};
  std::iota(scale.code.begin(), scale.code.end(), std::uint16_t{0});
  for (int code = 1; code <= 255; ++code) {
    std::int32_t below = 0;
    for (std::int32_t at = kOne; at - below > 1;) {
      const std::int32_t middle = below + (at - below) / 2;
      const bool reached = 255 * pq_encode(std::bit_cast<float>(middle)) >= code - 0.5;
      (reached ? at : below) = middle;
      if (at - below == 1) scale.threshold.push_back(std::bit_cast<float>(at));
    }
  }
  return scale;
}

std::vector<Scale> curves() {
  const std::pair<const char*, Response> responses[] = {
      {"srgb", SrgbResponse{}},          {"gamma 1.8", GammaResponse{1.8}},
      {"gamma 2.2", GammaResponse{}},    {"gamma 2.4", GammaResponse{2.4}},
      {"gamma 2.6", GammaResponse{2.6}}, {"bt1886", Bt1886Response{0.001}}};
  std::vector<Scale> scales;
  for (const auto& [name, response] : responses) {
    scales.push_back(scale_of(name, {.response = response}));
  }
  scales.push_back(pq_scale());
  return scales;
}

std::vector<Scale> intensity_tables() {
  std::mt19937 random(1);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
  };
  std::vector<Scale> scales;
  for (int i = 0; i < 100; ++i) {
    Display display{.response = GammaResponse{between(1.6, 2.8)}};
    display.levels = LevelTable{.n = static_cast<int>(between(1, 256)), .i0 = between(0.001, 0.1)};
    scales.push_back(scale_of("table " + std::to_string(i), display));
  }
  return scales;
}

// The code of `count` floats from that of `bits` on, in one instruction set.
void check_floats(const Scale& scale, const detail::StepTable& table,
                  const detail::StepKernel& kernel, std::int32_t bits, std::size_t count) {
  std::vector<float> in(count);
  Codes expected(count);
  Codes out(count);
  auto next = std::ranges::upper_bound(scale.threshold, std::bit_cast<float>(bits));
  for (std::size_t i = 0; i < count; ++i) {
    in[i] = std::bit_cast<float>(bits + static_cast<std::int32_t>(i));
    while (next != scale.threshold.end() && in[i] >= *next) ++next;
    expected[i] = scale.code[static_cast<std::size_t>(next - scale.threshold.begin())];
  }
  kernel.row(table, in.data(), count, out.data());
  ASSERT_EQ(out, expected) << kernel.name << " from " << in[0];
}

std::vector<detail::StepKernel> kernels() {
  std::vector<detail::StepKernel> all{detail::scalar_step_kernel()};
  for (const detail::StepKernel& simd : detail::simd_step_kernels()) all.push_back(simd);
  return all;
}

void check_scale(const Scale& scale) {
  SCOPED_TRACE(scale.name);
  const auto table = detail::step_table(scale.threshold, scale.code);
  ASSERT_TRUE(table);
  for (const detail::StepKernel& kernel : kernels()) {
    if (std::getenv("TRISTIM_FULL_SWEEP") != nullptr) {
      constexpr std::int32_t kAtOnce = 1 << 16;
      for (std::int32_t bits = 0; bits < kOne; bits += kAtOnce) {
        check_floats(scale, *table, kernel, bits, kAtOnce);
      }
    }
    for (const float threshold : scale.threshold) {
      const std::int32_t bits = std::bit_cast<std::int32_t>(threshold);
      check_floats(scale, *table, kernel, std::max(bits - kNear, 0), 2 * kNear);
    }
    if (testing::Test::HasFatalFailure()) return;
  }
}

TEST(EveryFloat, HasTheRoundedCodeOfEachCurve) {
  for (const Scale& scale : curves()) check_scale(scale);
}

TEST(EveryFloat, HasTheNearestCodeOfIntensityTables) {
  for (const Scale& scale : intensity_tables()) check_scale(scale);
}

TEST(EveryFloat, OfAMillionByChanceHasItsCode) {
  std::mt19937 random(2);
  std::vector<float> in(1'000'000);
  for (float& x : in) x = std::bit_cast<float>(static_cast<std::int32_t>(random() % (kOne + 1U)));
  for (const Scale& scale : curves()) {
    const auto table = detail::step_table(scale.threshold, scale.code);
    Codes expected(in.size());
    detail::scalar_step_kernel().row(*table, in.data(), in.size(), expected.data());
    for (const detail::StepKernel& kernel : detail::simd_step_kernels()) {
      Codes out(in.size());
      kernel.row(*table, in.data(), in.size(), out.data());
      EXPECT_EQ(out, expected) << scale.name << " " << kernel.name;
    }
  }
}

// Every curve is guessed, so that what was tested is not the look-up alone.
TEST(LevelGuess, IsMadeOfEveryCurve) {
  for (const Scale& scale : curves()) {
    const auto guess = detail::guess_thresholds(scale.threshold);
    ASSERT_TRUE(guess) << scale.name;
    EXPECT_GT(guess->sure, 0.5 - 0.0011) << scale.name;
  }
}

TEST(LevelGuess, IsNotMadeOfWhatLiesOnNoCurve) {
  EXPECT_FALSE(detail::guess_thresholds({}));
  EXPECT_FALSE(detail::guess_thresholds(std::vector{-1.0F, 0.5F, 1.0F}));
  EXPECT_FALSE(detail::guess_thresholds(std::vector{0.1F, 0.11F, 0.5F, 0.51F, 0.52F, 0.53F, 0.9F}));
  EXPECT_FALSE(detail::guess_between(std::vector{0.0F, 1e-30F, 1.0F}));  // over too many octaves
}

// Ordered dither around the light at which a pixel of each rank takes the next level.
void check_ordered(const MixLevels& levels, const char* recipe) {
  constexpr std::int32_t kFloats = 128;
  const ThresholdMatrix matrix = make_matrix(*find_matrix_recipe(recipe));
  const detail::OrderedLevels scale(levels, matrix.ranks);
  std::vector<float> in(kFloats);
  Codes expected(kFloats);
  Codes out(kFloats);
  for (int rank = 0; rank < matrix.ranks; rank += 1 + matrix.ranks / 64) {
    const std::vector<float> least(2 * detail::kMostLanes, static_cast<float>(rank) + 0.5F);
    const detail::OrderedRow row{&scale, least.data(), detail::kMostLanes, 0};
    for (std::size_t i = 1; i < levels.light.size(); ++i) {
      const float low = levels.light[i - 1];
      const float at = low + (levels.light[i] - low) * least[0] / static_cast<float>(matrix.ranks);
      const std::int32_t first = std::max(std::bit_cast<std::int32_t>(at) - kFloats / 2, 0);
      for (std::int32_t k = 0; k < kFloats; ++k) {
        in[static_cast<std::size_t>(k)] = std::bit_cast<float>(first + k);
      }
      detail::scalar_ordered_kernels().row(row, in.data(), nullptr, kFloats, expected.data());
      for (const detail::OrderedKernels& kernels : detail::simd_ordered_kernels()) {
        kernels.row(row, in.data(), nullptr, kFloats, out.data());
        ASSERT_EQ(out, expected) << kernels.name << " rank " << rank << " level " << i;
      }
    }
  }
}

TEST(EveryFloat, IsDitheredAlikeAroundEachThreshold) {
  const std::pair<const char*, Response> responses[] = {{"srgb", SrgbResponse{}},
                                                        {"gamma 2.2", GammaResponse{}},
                                                        {"gamma 2.6", GammaResponse{2.6}},
                                                        {"bt1886", Bt1886Response{0.001}}};
  for (const auto& [name, response] : responses) {
    for (const int bits : {5, 8, 10}) {
      const LevelScale scale = level_scale({.response = response}, bits, BlackPoint::kRelative);
      for (const char* recipe : {"d3", "bayer8", "blue-noise128"}) {
        SCOPED_TRACE(testing::Message() << name << ", " << bits << " bits, " << recipe);
        check_ordered({scale.light, scale.code}, recipe);
      }
    }
  }
}

}  // namespace
}  // namespace tristim
