#include <gtest/gtest.h>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

using Palette = std::vector<Color8>;

Palette popularity(const Histogram& histogram, int colors) {
  return choose_popularity({.entries = histogram.entries(), .colors = colors});
}

Histogram example() {
  Histogram histogram;
  histogram.add(Color8{9, 0, 0}, 5);
  histogram.add(Color8{0, 0, 2}, 3);
  histogram.add(Color8{0, 1, 0}, 3);
  histogram.add(Color8{0, 0, 1}, 3);
  histogram.add(Color8{1, 0, 0}, 1);
  return histogram;
}

TEST(Popularity, TakesTheMostFrequentAndOfEqualOnesTheSmaller) {
  EXPECT_EQ(popularity(example(), 1), (Palette{{9, 0, 0}}));
  EXPECT_EQ(popularity(example(), 3), (Palette{{9, 0, 0}, {0, 0, 1}, {0, 0, 2}}));
  EXPECT_EQ(popularity(example(), 4), (Palette{{9, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 1, 0}}));
}

TEST(Popularity, KeepsEveryColourWhereThereAreFew) {
  EXPECT_EQ(popularity(example(), 5).size(), 5U);
  EXPECT_EQ(popularity(example(), 256), popularity(example(), 5));
}

}  // namespace
}  // namespace tristim
