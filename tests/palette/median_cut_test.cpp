#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <set>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

using Palette = std::vector<Color8>;

Palette median_cut(const Histogram& histogram, int colors) {
  return choose_median_cut({.entries = histogram.entries(), .colors = colors});
}

Histogram any_histogram() {
  Histogram histogram;
  const auto part = [] { return *rc::gen::inRange<std::uint8_t>(0, 255); };
  const int colors = *rc::gen::inRange(0, 40);
  for (int i = 0; i < colors; ++i) {
    histogram.add(Color8{part(), part(), part()}, *rc::gen::inRange<std::uint64_t>(1, 100));
  }
  return histogram;
}

// Reds 0 10 20 100 with 1 1 1 3 pixels. The median, pixel 3 of 6, is red 20: {0 10 20} and {100}.
// {0 10 20} then falls at its pixel 2 into {0 10}, mean 5, and {20}.
TEST(MedianCut, FollowsTheExampleByHand) {
  Histogram histogram;
  histogram.add(Color8{0, 0, 0});
  histogram.add(Color8{10, 0, 0});
  histogram.add(Color8{20, 0, 0});
  histogram.add(Color8{100, 0, 0}, 3);
  EXPECT_EQ(median_cut(histogram, 1), (Palette{{55, 0, 0}}));  // 330/6
  EXPECT_EQ(median_cut(histogram, 2), (Palette{{10, 0, 0}, {100, 0, 0}}));
  EXPECT_EQ(median_cut(histogram, 3), (Palette{{5, 0, 0}, {20, 0, 0}, {100, 0, 0}}));
}

TEST(MedianCut, SplitsTheLongestSide) {
  Histogram histogram;
  histogram.add(Color8{0, 0, 7});
  histogram.add(Color8{100, 0, 7});
  histogram.add(Color8{0, 101, 7});
  histogram.add(Color8{100, 101, 7});
  EXPECT_EQ(median_cut(histogram, 2), (Palette{{50, 0, 7}, {50, 101, 7}}));
}

TEST(MedianCut, RoundsTheCountWeightedMean) {
  Histogram histogram;
  histogram.add(Color8{0, 0, 0}, 1);
  histogram.add(Color8{1, 3, 255}, 1);
  EXPECT_EQ(median_cut(histogram, 1), (Palette{{1, 2, 128}}));  // .5, 1.5, 127.5 go up
  histogram.add(Color8{0, 0, 0}, 2);
  EXPECT_EQ(median_cut(histogram, 1), (Palette{{0, 1, 64}}));  // .25, .75, 63.75
}

TEST(MedianCut, ComesInOrderOfLuma) {
  Histogram histogram;
  histogram.add(Color8{255, 255, 255});
  histogram.add(Color8{0, 0, 255});
  histogram.add(Color8{0, 255, 0});
  histogram.add(Color8{255, 0, 0});
  EXPECT_EQ(median_cut(histogram, 4),
            (Palette{{0, 0, 255}, {255, 0, 0}, {0, 255, 0}, {255, 255, 255}}));
}

RC_GTEST_PROP(MedianCut, StaysInsideTheBoxOfTheColoursUsed, ()) {
  const Histogram histogram = any_histogram();
  const auto entries = histogram.entries();
  RC_PRE(!entries.empty());
  for (const auto channel : {&Color8::r, &Color8::g, &Color8::b}) {
    const auto value = [channel](const Histogram::Entry& e) { return e.color.*channel; };
    const auto [low, high] = std::ranges::minmax_element(entries, {}, value);
    for (const Color8& c : median_cut(histogram, 7)) {
      const bool inside = c.*channel >= value(*low) && c.*channel <= value(*high);
      RC_ASSERT(inside);
    }
  }
}

}  // namespace
}  // namespace tristim
