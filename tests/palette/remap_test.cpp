#include "tristim/palette/remap.h"

#include <gtest/gtest.h>

#include "tests/error_text.h"
#include "tristim/color/transfer.h"
#include "tristim/palette/nearest.h"

namespace tristim {
namespace {

Raster<std::uint8_t> picture(int channels) {
  Raster<std::uint8_t> codes(64, 40, channels);
  std::uint32_t state = 3;
  for (int y = 0; y < 40; ++y) {
    for (std::uint8_t& code : codes.view().row(y)) {
      state = state * 1664525 + 1013904223;
      code = static_cast<std::uint8_t>(y * 4 + (state >> 27));
    }
  }
  return codes;
}

TEST(PaletteMap, FindsTheNearestOfAllInEveryMetric) {
  const Raster<std::uint8_t> codes = picture(3);
  Histogram histogram;
  histogram.add(codes.view());
  std::vector<Color8> palette;
  std::vector<Rgb> light;
  for (int i = 0; i < 300; ++i) {
    const auto part = [i](int k) { return static_cast<std::uint8_t>(i * k % 251); };
    palette.push_back({part(5), part(11), part(3)});
    const Color8 c = palette.back();
    light.push_back({srgb_decode(c.r / 255.0), srgb_decode(c.g / 255.0), srgb_decode(c.b / 255.0)});
  }
  for (const Metric& metric : kMetrics) {
    const PaletteMap map(histogram, palette, metric);
    const NearestColor nearest(light, metric);
    Raster<std::uint16_t> positions(64, 40, 1);
    map.map(codes.view(), positions.view());
    int differ = 0;
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 64; ++x) {
        const std::uint8_t* p = codes.view().pixel(x, y);
        const int expected = nearest.find(
            {srgb_decode(p[0] / 255.0), srgb_decode(p[1] / 255.0), srgb_decode(p[2] / 255.0)});
        differ += *positions.view().pixel(x, y) == expected ? 0 : 1;
      }
    }
    EXPECT_LE(differ, 2) << metric.name;  // ties that rounding decides: rows are in float
  }
}

TEST(PaletteMap, KeepsTransparentEntriesForTransparentColours) {
  Histogram histogram;
  histogram.add(Color8{0, 0, 0, 0});
  histogram.add(Color8{1, 1, 1});
  histogram.add(Color8{200, 200, 200, 100});
  const PaletteMap map(histogram, std::vector<Color8>{{0, 0, 0, 0}, {255, 255, 255}, {9, 9, 9}},
                       *kMetrics.begin());
  EXPECT_EQ(map.position({0, 0, 0, 0}), 0);
  EXPECT_EQ(map.position({1, 1, 1}), 2);
  EXPECT_GT(map.position({200, 200, 200, 100}), 0);
}

TEST(PaletteMap, RefusesOtherShapes) {
  const auto refused = [](std::size_t colors) {
    return error_text([&] { PaletteMap({}, std::vector<Color8>(colors), *kMetrics.begin()); });
  };
  EXPECT_EQ(refused(0), "invalid: palette: 0 colours, expected 1 to 65536");
  EXPECT_EQ(refused(65537), "invalid: palette: 65537 colours, expected 1 to 65536");
  const PaletteMap map({}, std::vector<Color8>(1), *kMetrics.begin());
  Raster<std::uint16_t> positions(3, 2, 1);
  EXPECT_NE(error_text([&] { map.map(picture(3).view(), positions.view()); }), "");
}

}  // namespace
}  // namespace tristim
