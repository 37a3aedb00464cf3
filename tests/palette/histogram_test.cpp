#include "tristim/palette/histogram.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>

namespace tristim {
namespace {

// Few colours, so that they repeat and come in runs.
Color8 any_color() {
  const auto part = [] { return *rc::gen::element<std::uint8_t>(0, 1, 255); };
  return {part(), part(), part()};
}

TEST(Histogram, CountsColoursInAscendingOrder) {
  Histogram histogram;
  histogram.add(Color8{3, 2, 1});
  histogram.add(Color8{1, 200, 3}, 5);
  histogram.add(Color8{3, 2, 1}, 2);
  histogram.add(Color8{1, 2, 255});
  const auto entries = histogram.entries();
  ASSERT_EQ(entries.size(), 3U);
  EXPECT_EQ(entries[0].color, (Color8{1, 2, 255}));
  EXPECT_EQ(entries[1].color, (Color8{1, 200, 3}));
  EXPECT_EQ(entries[1].count, 5U);
  EXPECT_EQ(entries[2].color, (Color8{3, 2, 1}));
  EXPECT_EQ(entries[2].count, 3U);
}

TEST(Histogram, IsEmptyAtFirst) { EXPECT_TRUE(Histogram{}.entries().empty()); }

RC_GTEST_PROP(Histogram, OfRowsIsThatOfTheirPixels, ()) {
  const int width = *rc::gen::inRange(0, 12);
  const int height = *rc::gen::inRange(0, 6);
  Raster<std::uint16_t> codes(width, height, 3);
  std::map<Color8, std::uint64_t> expected;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Color8 c = any_color();
      std::uint16_t* pixel = codes.view().pixel(x, y);
      pixel[0] = c.r, pixel[1] = c.g, pixel[2] = c.b;
      ++expected[c];
    }
  }
  Histogram histogram;
  histogram.add(codes.view());
  const auto entries = histogram.entries();
  RC_ASSERT(entries.size() == expected.size());
  RC_ASSERT(std::ranges::is_sorted(entries, {}, &Histogram::Entry::color));
  std::uint64_t total = 0;
  for (const auto& entry : entries) {
    RC_ASSERT(entry.count == expected.at(entry.color));
    total += entry.count;
  }
  RC_ASSERT(total == static_cast<std::uint64_t>(width * height));
}

RC_GTEST_PROP(Histogram, MergedIsTheSumOfBoth, ()) {
  Histogram first;
  Histogram second;
  Histogram both;
  for (int i = 0; i < 20; ++i) {
    const Color8 c = any_color();
    (i % 3 == 0 ? first : second).add(c);
    both.add(c);
  }
  first.merge(second);
  const auto merged = first.entries();
  const auto expected = both.entries();
  RC_ASSERT(merged.size() == expected.size());
  for (std::size_t i = 0; i < merged.size(); ++i) {
    RC_ASSERT(merged[i].color == expected[i].color && merged[i].count == expected[i].count);
  }
}

}  // namespace
}  // namespace tristim
