#include "tristim/palette/nearest.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <limits>

namespace tristim {
namespace {

Rgb any_color() {
  const auto part = [] { return *rc::gen::inRange(0, 1001) / 1000.0; };
  return {part(), part(), part()};
}

double distance2(const Metric& metric, const Rgb& a, const Rgb& b) {
  const auto p = metric.place(a);
  const auto q = metric.place(b);
  double sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (double{p[c]} - q[c]) * (double{p[c]} - q[c]);
  return sum;
}

RC_GTEST_PROP(NearestColor, IsTheNearestOfAll, ()) {
  std::vector<Rgb> palette;
  const int entries = *rc::gen::inRange(1, 60);
  for (int i = 0; i < entries; ++i) palette.push_back(any_color());
  for (const Metric& metric : kMetrics) {
    const NearestColor nearest(palette, metric);
    for (int i = 0; i < 20; ++i) {
      const Rgb color = any_color();
      const int found = nearest.find(color);
      RC_ASSERT(found >= 0 && found < entries);
      const double reached = distance2(metric, palette[static_cast<std::size_t>(found)], color);
      for (const Rgb& entry : palette) {
        // Three squares and two sums in float.
        RC_ASSERT(reached <= distance2(metric, entry, color) * (1 + 1e-6));
      }
    }
  }
}

RC_GTEST_PROP(NearestColor, OfARowIsThatOfEachPixel, ()) {
  const auto any_row = [](int pixels) {
    std::vector<float> row;
    for (int i = 0; i < pixels; ++i) {
      // Runs of neighbours with an edge now and then.
      const bool edge = i == 0 || *rc::gen::inRange(0, 10) == 0;
      const Rgb c = any_color();
      for (const double v : {c.r, c.g, c.b}) {
        row.push_back(edge ? static_cast<float>(v) : row[row.size() - 3] * 0.99F);
      }
    }
    return row;
  };
  const std::vector<float> row = any_row(*rc::gen::inRange(0, 70));
  std::vector<Rgb> palette;
  for (int i = *rc::gen::inRange(1, 60); i > 0; --i) palette.push_back(any_color());
  std::vector<float> entries;
  for (const Rgb& c : palette) {
    for (const double v : {c.r, c.g, c.b}) entries.push_back(static_cast<float>(v));
  }
  for (const Metric& metric : kMetrics) {
    std::vector<std::uint16_t> found(row.size() / 3);
    NearestColor(palette, metric).find_row(row, found);
    std::vector<float> at = row;
    std::vector<float> to = entries;
    place_row(metric, at);
    place_row(metric, to);
    for (std::size_t i = 0; i < found.size(); ++i) {
      const auto distance2 = [&](std::size_t k) {
        float sum = 0;
        for (std::size_t c = 0; c < 3; ++c) {
          const float d = to[3 * k + c] - at[3 * i + c];
          sum += d * d;
        }
        return sum;
      };
      for (std::size_t k = 0; k < palette.size(); ++k) {
        RC_ASSERT(distance2(found[i]) <= distance2(k));
        if (k < found[i]) RC_ASSERT(distance2(found[i]) < distance2(k));
      }
    }
  }
}

TEST(NearestColor, OfEqualsIsTheFirst) {
  const std::vector<Rgb> palette{{1, 1, 1}, {0, 0, 0}, {0.5, 0.5, 0.5}, {0, 0, 0}, {1, 1, 1}};
  for (const Metric& metric : kMetrics) {
    const NearestColor nearest(palette, metric);
    EXPECT_EQ(nearest.find({0, 0, 0}), 1) << metric.name;
    EXPECT_EQ(nearest.find({1, 1, 1}), 0) << metric.name;
  }
}

TEST(NearestColor, FindsEveryEntryOfAGrid) {
  std::vector<Rgb> palette;
  for (int i = 0; i < 125; ++i) palette.push_back({i / 25 / 4.0, i / 5 % 5 / 4.0, i % 5 / 4.0});
  for (const Metric& metric : kMetrics) {
    const NearestColor nearest(palette, metric);
    for (std::size_t i = 0; i < palette.size(); ++i) {
      EXPECT_EQ(nearest.find(palette[i]), static_cast<int>(i)) << metric.name;
    }
  }
}

TEST(NearestColor, TakesAnyNumbers) {
  const std::vector<Rgb> palette{{0, 0, 0}, {1, 1, 1}};
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const Metric& metric : kMetrics) {
    const NearestColor nearest(palette, metric);
    for (const double v : {std::nan(""), kInfinity, -kInfinity, 1e300, -1e300, -1.0}) {
      const int found = nearest.find({v, 0.5, v});
      EXPECT_TRUE(found == 0 || found == 1) << metric.name;
    }
  }
}

}  // namespace
}  // namespace tristim
