#include "tristim/palette/weights.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tristim/palette/histogram.h"

namespace tristim {
namespace {

TEST(ContrastWeights, AreFullInFlatAreasAndSmallInTexture) {
  Raster<std::uint16_t> codes(8, 4, 3);
  for (int y = 0; y < 4; ++y) {
    for (int x = 4; x < 8; ++x) {
      codes.view().pixel(x, y)[1] = (x + y) % 2 == 0 ? 200 : 0;
    }
  }
  Raster<std::uint16_t> weights(8, 4, 1);
  contrast_weights(codes.view(), {}, weights.view());
  EXPECT_EQ(*weights.view().pixel(1, 1), kFlatWeight);
  EXPECT_EQ(*weights.view().pixel(6, 2), 1);  // 16 16/(16 + 200)
}

TEST(ContrastWeights, OfBandsAreThoseOfTheWhole) {
  Raster<std::uint16_t> codes(5, 6, 3);
  for (int y = 0; y < 6; ++y) {
    for (int i = 0; i < 15; ++i)
      codes.view().row(y)[std::size_t(i)] = std::uint16_t(i * y * 7 % 256);
  }
  Raster<std::uint16_t> whole(5, 6, 1);
  contrast_weights(codes.view(), {}, whole.view());
  Raster<std::uint16_t> bands(5, 6, 1);
  contrast_weights(codes.view().rows(0, 2), {}, bands.view().rows(0, 2));
  contrast_weights(codes.view().rows(2, 4), codes.view().row(1), bands.view().rows(2, 4));
  for (int y = 0; y < 6; ++y)
    EXPECT_TRUE(std::ranges::equal(whole.view().row(y), bands.view().row(y)));
}

TEST(Histogram, CountsPixelsByTheirWeights) {
  Raster<std::uint16_t> codes(2, 1, 3);
  codes.view().pixel(1, 0)[0] = 9;
  Raster<std::uint16_t> weights(2, 1, 1);
  *weights.view().pixel(0, 0) = 7;
  Histogram histogram;
  histogram.add(codes.view(), weights.view());
  EXPECT_EQ(histogram.entries(), (std::vector<Histogram::Entry>{{{0, 0, 0}, 7}}));
  EXPECT_THROW(histogram.add(codes.view(), codes.view()), std::invalid_argument);
}

TEST(Histogram, CountsBeyond32Bits) {
  Histogram histogram;
  constexpr std::uint64_t kMany = (std::uint64_t{1} << 32) - 1;
  histogram.add(Color8{1, 2, 3}, kMany);
  histogram.add(Color8{1, 2, 3}, 1);
  histogram.add(Color8{4, 5, 6}, kMany);
  Raster<std::uint8_t> pixel(1, 1, 3);
  std::ranges::copy(std::array{4, 5, 6}, pixel.view().data);
  histogram.add(ImageView<const std::uint8_t>(pixel.view()));
  histogram.add(ImageView<const std::uint8_t>(pixel.view()));
  EXPECT_EQ(histogram.entries(),
            (std::vector<Histogram::Entry>{{{1, 2, 3}, kMany + 1}, {{4, 5, 6}, kMany + 2}}));
}

TEST(WithAlpha, ComposesThresholdsOrKeeps) {
  Histogram histogram;
  histogram.add(Color8{200, 100, 0, 128}, 2);
  histogram.add(Color8{200, 100, 0, 127}, 3);
  histogram.add(Color8{9, 9, 9, 0}, 4);
  histogram.add(Color8{1, 1, 1, 0}, 5);
  using Entries = std::vector<Histogram::Entry>;
  EXPECT_EQ(with_alpha(histogram, AlphaMode::kThreshold).entries(), (Entries{{{200, 100, 0}, 2}}));
  EXPECT_EQ(with_alpha(histogram, AlphaMode::kOver).entries(),
            (Entries{{{0, 0, 0}, 9}, {{100, 50, 0}, 5}}));
  EXPECT_EQ(with_alpha(histogram, AlphaMode::kEntries).entries(),
            (Entries{{{0, 0, 0, 0}, 9}, {{200, 100, 0, 127}, 3}, {{200, 100, 0, 128}, 2}}));
}

}  // namespace
}  // namespace tristim
