#include "lib/dither/step_table.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

#include "tristim/device/display.h"
#include "tristim/dither/level_search.h"

namespace tristim {
namespace {

using detail::StepKernel;
using detail::StepTable;

std::vector<std::uint16_t> count_codes(const std::vector<float>& threshold) {
  std::vector<std::uint16_t> code(threshold.size() + 1);
  std::iota(code.begin(), code.end(), std::uint16_t{0});
  return code;
}

std::vector<float> thresholds_of(const Response& response, int bits) {
  Display display;
  display.response = response;
  return level_scale(display, bits, BlackPoint::kAbsolute).threshold;
}

// Each threshold with its neighbours, and what is odd.
std::vector<float> around(const std::vector<float>& threshold) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  std::vector<float> in = {-1, -kInfinity, -0.0F, 0,         1e-42F,
                           1,  1.5F,       3e38F, kInfinity, std::nanf("")};
  for (const float t : threshold) {
    for (const float v : {std::nextafter(t, -1.0F), t, std::nextafter(t, 2.0F)}) in.push_back(v);
  }
  return in;
}

void expect_counts(const StepTable& table, const std::vector<float>& threshold) {
  const LevelSearch search(threshold);
  const std::vector<float> in = around(threshold);
  std::vector<std::uint16_t> expected;
  for (const float v : in) {
    expected.push_back(static_cast<std::uint16_t>(
        table.codes[static_cast<std::size_t>(search.count_not_above(v))]));
  }
  std::vector<StepKernel> kernels = {detail::scalar_step_kernel()};
  for (const StepKernel& simd : detail::simd_step_kernels()) kernels.push_back(simd);
  for (const StepKernel& kernel : kernels) {
    std::vector<std::uint16_t> out(in.size());
    kernel.row(table, in.data(), in.size(), out.data());
    EXPECT_EQ(out, expected) << kernel.name;
  }
}

TEST(StepTable, TurnsAtTheThresholdsOfEveryResponse) {
  const Response responses[] = {SrgbResponse{}, LinearResponse{}, GammaResponse{1.8, 0, 0},
                                GammaResponse{2.6, 0, 0}, Bt1886Response{0.001}};
  for (const Response& response : responses) {
    for (const int bits : {1, 2, 4, 8}) {
      const std::vector<float> threshold = thresholds_of(response, bits);
      const auto table = detail::step_table(threshold, count_codes(threshold));
      ASSERT_TRUE(table) << describe(response) << ", " << bits << " bits";
      expect_counts(*table, threshold);
    }
  }
}

TEST(StepTable, TakesCodesInAnyOrder) {
  const std::vector<float> threshold = {0.1F, 0.5F, 0.5001F, 0.9F};
  const std::vector<std::uint16_t> code = {7, 65535, 0, 3, 9};
  const auto table = detail::step_table(threshold, code);
  ASSERT_TRUE(table);
  EXPECT_FALSE(table->codes_count);
  expect_counts(*table, threshold);
}

TEST(StepTable, IsNotMadeOfWhatItCannotHold) {
  const float nan = std::nanf("");
  for (const std::vector<float>& threshold : {std::vector<float>{},
                                              {0.0F, 1.0F},
                                              {-1.0F, 1.0F},
                                              {0.5F, INFINITY},
                                              {0.5F, nan},
                                              {0.5F, std::nextafter(0.5F, 1.0F)}}) {
    EXPECT_FALSE(detail::step_table(threshold, count_codes(threshold)));
  }
}

RC_GTEST_PROP(StepTable, AnyLevels, ()) {
  std::vector<float> threshold;
  const auto count = *rc::gen::inRange(1, 300);
  float t = 1e-6F;
  for (int i = 0; i < count; ++i) {
    t *= 1 + static_cast<float>(*rc::gen::inRange(1, 1000)) / 5000;
    threshold.push_back(t);
  }
  if (const auto table = detail::step_table(threshold, count_codes(threshold))) {
    expect_counts(*table, threshold);
    RC_ASSERT(!::testing::Test::HasFailure());
  }
}

}  // namespace
}  // namespace tristim
