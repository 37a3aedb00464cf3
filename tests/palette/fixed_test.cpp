#include <gtest/gtest.h>

#include <set>

#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/palette/nearest.h"
#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

// [Shoaff 2.2.10]
TEST(Fixed332, HasRedInTheTopBitsAndBlueInTheLowest) {
  const std::vector<Color8> palette = choose_fixed_332({});
  ASSERT_EQ(palette.size(), 256U);
  EXPECT_EQ(palette[0], (Color8{0, 0, 0}));
  EXPECT_EQ(palette[255], (Color8{255, 255, 255}));
  EXPECT_EQ(palette[0b11100000], (Color8{255, 0, 0}));
  EXPECT_EQ(palette[0b00011100], (Color8{0, 255, 0}));
  EXPECT_EQ(palette[0b00000011], (Color8{0, 0, 255}));
  // i 255/7 = 36.43, 72.86, 109.29, 145.71, 182.14, 218.57 and i 255/3 = 85, 170, rounded.
  const int eighths[] = {0, 36, 73, 109, 146, 182, 219, 255};
  const int quarters[] = {0, 85, 170, 255};
  for (std::size_t i = 0; i < 256; ++i) {
    EXPECT_EQ(palette[i].r, eighths[i >> 5]);
    EXPECT_EQ(palette[i].g, eighths[i >> 2 & 7]);
    EXPECT_EQ(palette[i].b, quarters[i & 3]);
  }
}

// The nearest level of a channel is floor(v (2^b - 1)/255 + 1/2): with encoded numbers as metric
// the nearest colour is that of each channel, but for codes half way between rounded levels.
TEST(Fixed332, IsReachedByTheNearestLevelOfEachChannel) {
  const auto light = [](int code) { return srgb_decode(code / 255.0); };
  std::vector<Rgb> palette;
  for (const Color8& c : choose_fixed_332({}))
    palette.push_back({light(c.r), light(c.g), light(c.b)});
  const NearestColor nearest(palette, *find_by_name(kMetrics, "encoded"));
  const std::set<int> half_way{18, 91, 164, 237};  // of 0 36, 73 109, 146 182, 219 255
  for (int v = 0; v <= 255; ++v) {
    EXPECT_EQ(nearest.find({0, 0, light(v)}), (v * 3 * 2 + 255) / 510) << v;
    if (half_way.contains(v)) continue;
    const int eighth = (v * 7 * 2 + 255) / 510;
    EXPECT_EQ(nearest.find({light(v), 0, 0}), eighth << 5) << v;
    EXPECT_EQ(nearest.find({0, light(v), 0}), eighth << 2) << v;
  }
}

TEST(FixedPalette, HasTheBitsThatAreAskedForOrFit) {
  EXPECT_EQ(choose_fixed({.colors = 256}).size(), 256U);
  EXPECT_EQ(choose_fixed({.colors = 256}), choose_fixed_332({}));
  EXPECT_EQ(choose_fixed({.colors = 65536}).size(), 65536U);  // 5, 6, 5
  EXPECT_EQ(choose_fixed({.colors = 15}).size(), 8U);
  EXPECT_EQ(choose_fixed({.colors = 1}), (std::vector<Color8>{{0, 0, 0}}));
  const std::vector<Color8> bits = choose_fixed({.colors = 256, .bits = {1, 0, 2}});
  EXPECT_EQ(bits, (std::vector<Color8>{{0, 0, 0},
                                       {0, 0, 85},
                                       {0, 0, 170},
                                       {0, 0, 255},
                                       {255, 0, 0},
                                       {255, 0, 85},
                                       {255, 0, 170},
                                       {255, 0, 255}}));
}

TEST(UniformPalette, IsACubeAndGreysBetween) {
  const std::vector<Color8> palette = choose_uniform({.colors = 12});
  ASSERT_EQ(palette.size(), 12U);
  EXPECT_EQ(palette[6], (Color8{255, 255, 0}));
  EXPECT_EQ(palette[8], (Color8{51, 51, 51}));
  EXPECT_EQ(palette[11], (Color8{204, 204, 204}));
  EXPECT_EQ(choose_uniform({.colors = 3}),
            (std::vector<Color8>{{0, 0, 0}, {128, 128, 128}, {255, 255, 255}}));
  for (int colors = 1; colors < 300; ++colors) {
    const std::vector<Color8> all = choose_uniform({.colors = colors});
    EXPECT_LE(std::ssize(all), colors);
    EXPECT_EQ(std::set<Color8>(all.begin(), all.end()).size(), all.size());
  }
}

}  // namespace
}  // namespace tristim
