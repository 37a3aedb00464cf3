#include "tristim/dither/level_search.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace tristim {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kTiny = std::numeric_limits<float>::denorm_min();

int reference(const std::vector<float>& ascending, float value) {
  if (std::isnan(value)) return 0;
  return static_cast<int>(std::ranges::upper_bound(ascending, value) - ascending.begin());
}

// Values of every kind, and the thresholds with their neighbours.
std::vector<float> probes(const std::vector<float>& thresholds) {
  std::vector<float> all{0.0F,       -0.0F,         1.0F,  -1.0F,  kTiny,
                         -kTiny,     1e-3F,         1e30F, -1e30F, kInfinity,
                         -kInfinity, std::nanf(""), 0.5F,  2.0F,   -std::nanf("")};
  for (const float t : thresholds) {
    all.push_back(t);
    all.push_back(std::nextafter(t, kInfinity));
    all.push_back(std::nextafter(t, -kInfinity));
  }
  return all;
}

void expect_exact(std::vector<float> thresholds, const std::vector<float>& more = {}) {
  std::ranges::sort(thresholds);
  const LevelSearch search(thresholds);
  std::vector<float> values = probes(thresholds);
  values.insert(values.end(), more.begin(), more.end());
  for (const float value : values) {
    ASSERT_EQ(search.count_not_above(value), reference(thresholds, value)) << value;
  }
}

TEST(LevelSearch, CountsAmongFewThresholds) {
  expect_exact({});
  expect_exact({0.5F});
  expect_exact({0.0F});
  expect_exact({-0.0F, 0.0F});
  expect_exact({-2, -1, 0, 1, 2});
  expect_exact({0.25F, 0.25F, 0.25F});
  expect_exact({-kInfinity, kInfinity});
  expect_exact({-kInfinity, -kInfinity, 0.5F, kInfinity, kInfinity});
  expect_exact({kTiny, 2 * kTiny, 1e-40F, std::numeric_limits<float>::min()});
  expect_exact({std::numeric_limits<float>::max()});
  expect_exact({-5, -4, -3});
}

RC_GTEST_PROP(LevelSearch, IsTheUpperBoundOfAnyFloats,
              (std::vector<std::uint32_t> bits, std::vector<std::uint32_t> more)) {
  const auto floats = [](const std::vector<std::uint32_t>& list) {
    std::vector<float> values;
    for (const std::uint32_t b : list) values.push_back(std::bit_cast<float>(b));
    return values;
  };
  std::vector<float> thresholds = floats(bits);
  std::erase_if(thresholds, [](float t) { return std::isnan(t); });
  expect_exact(thresholds, floats(more));
}

// As many thresholds as a channel of 8, 10 and 16 bits has, of linear and of power curves.
TEST(LevelSearch, CountsAmongTheThresholdsOfCurves) {
  std::mt19937 random(1);
  for (const int count : {255, 1023, 1024, 1025, 65535}) {
    for (const double gamma : {1.0, 2.4}) {
      SCOPED_TRACE(testing::Message() << count << " thresholds, gamma " << gamma);
      std::vector<float> thresholds;
      for (int i = 0; i < count; ++i) {
        thresholds.push_back(static_cast<float>(std::pow((i + 0.5) / count, gamma)));
      }
      const LevelSearch search(thresholds);
      for (int i = 0; i < 20000; ++i) {
        const float value = std::uniform_real_distribution(-0.1F, 1.1F)(random);
        ASSERT_EQ(search.count_not_above(value), reference(thresholds, value));
        const float at = thresholds[static_cast<std::size_t>(i % count)];
        ASSERT_EQ(search.count_not_above(at), reference(thresholds, at));
        const float below = std::nextafter(at, -1.0F);
        ASSERT_EQ(search.count_not_above(below), reference(thresholds, below));
      }
    }
  }
}

}  // namespace
}  // namespace tristim
