#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/dither/matrices.h"
#include "tristim/dither/palette.h"

namespace tristim {
namespace {

using Indices = std::vector<std::uint16_t>;

const Metric& toe() { return *find_by_name(kMetrics, "oklab-toe"); }

double lstar(double light) {
  return light > 216.0 / 24389 ? 116 * std::cbrt(light) - 16 : light * 24389 / 27;
}

double shown(const PaletteOrdered& dither, const std::vector<Rgb>& entries, float light) {
  constexpr int kSide = 256;
  const std::vector<float> rgb(std::size_t{3} * kSide, light);
  Indices indices(kSide);
  double sum = 0;
  for (int y = 0; y < kSide; ++y) {
    dither.row(y, rgb, indices);
    for (const std::uint16_t i : indices) {
      sum += 0.2126 * entries[i].r + 0.7152 * entries[i].g + 0.0722 * entries[i].b;
    }
  }
  return sum / (kSide * kSide);
}

// The lightness of greys is kept as docs/dither-quality.md promises, by greys and by inks.
TEST(PaletteOrdered, KeepsTheToneOfGreys) {
  const std::vector<std::vector<Rgb>> palettes{
      {{0, 0, 0}, {1, 1, 1}, {0.5, 0.5, 0.5}},
      {{0, 0, 0}, {1, 1, 1}, {0.6, 0.05, 0.05}, {0.05, 0.3, 0.1}, {0.05, 0.06, 0.5}}};
  for (const std::vector<Rgb>& entries : palettes) {
    const MixPalette palette(entries, toe(), Mix::kLight);
    for (const std::string_view name : {"blue-noise", "bayer64", "bayer256"}) {
      const PaletteOrdered dither(palette, make_matrix(*find_matrix_recipe(name)));
      for (int patch = 0; patch <= 16; ++patch) {
        const auto light = static_cast<float>(srgb_decode(patch / 16.0));
        EXPECT_NEAR(lstar(shown(dither, entries, light)), lstar(light), 0.15)
            << name << " " << patch << " of " << entries.size() << " entries";
      }
    }
  }
}

TEST(PaletteOrdered, RowsAreTheSameInParts) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-0.1F, 1.1F);
  std::vector<Rgb> entries;
  for (int i = 0; i < 9; ++i) entries.push_back({any(random), any(random), any(random)});
  const MixPalette palette(entries, toe(), Mix::kLight);
  const PaletteOrdered dither(palette, make_matrix(*find_by_name(kMatrixRecipes, "blue-noise")));
  std::vector<float> rgb(3 * 3000);
  for (float& v : rgb) v = any(random);
  Indices whole(3000);
  dither.row(5, rgb, whole);
  Indices first(1023);
  dither.row(5, std::span(rgb).first(3 * 1023), first);
  EXPECT_EQ(first, Indices(whole.begin(), whole.begin() + 1023));
  Indices drawn(3000);
  dither.row(5, rgb, drawn, std::vector<float>(3000, 0.0F));
  Indices nearest(3000);
  palette_nearest_row(palette, rgb, nearest);
  int other = 0;
  for (std::size_t x = 0; x < drawn.size(); ++x) other += drawn[x] != nearest[x] ? 1 : 0;
  EXPECT_LT(other, 3000 / 2);  // colours outside are moved into the hull before they are drawn
}

// More than mixtures are made of: plans of sixteen entries.
TEST(PaletteOrdered, TakesLargePalettes) {
  std::vector<Rgb> entries;
  for (int i = 0; i < 1100; ++i)
    entries.push_back({i % 11 / 10.0, i / 11 % 10 / 9.0, i / 110 / 9.0});
  const MixPalette palette(entries, toe(), Mix::kLight);
  const PaletteOrdered dither(palette, make_matrix(*find_by_name(kMatrixRecipes, "bayer16")));
  EXPECT_NEAR(shown(dither, entries, 0.43F), 0.43, 0.02);
}

}  // namespace
}  // namespace tristim
