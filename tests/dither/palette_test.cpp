#include "tristim/dither/palette.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "tristim/core/find.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

using Indices = std::vector<std::uint16_t>;
using Color = MixPalette::Color;

const std::vector<Rgb> kBlackWhite{{0, 0, 0}, {1, 1, 1}};
const std::vector<Rgb> kCube{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0},
                             {0, 0, 1}, {1, 0, 1}, {0, 1, 1}, {1, 1, 1}};

const Metric& metric(std::string_view name) { return *find_by_name(kMetrics, name); }

constexpr int kSide = 128;

template <typename Row>
Indices flat(const Color& light, Row&& row) {
  std::vector<float> rgb;
  for (int x = 0; x < kSide; ++x) rgb.insert(rgb.end(), light.begin(), light.end());
  Indices all;
  Indices indices(kSide);
  for (int y = 0; y < kSide; ++y) {
    row(y, rgb, indices);
    all.insert(all.end(), indices.begin(), indices.end());
  }
  return all;
}

Indices diffused(const MixPalette& palette, const Color& light, bool serpentine = false) {
  PaletteDiffusion diffusion(palette, kSide, {.serpentine = serpentine});
  return flat(light, [&](int, const auto& rgb, auto& indices) { diffusion.row(rgb, indices); });
}

Indices ordered(const MixPalette& palette, std::string_view matrix_name, const Color& light) {
  const PaletteOrdered dither(palette, make_matrix(*find_by_name(kMatrixRecipes, matrix_name)));
  return flat(light, [&](int y, const auto& rgb, auto& indices) { dither.row(y, rgb, indices); });
}

std::array<double, 3> mean(const std::vector<Rgb>& palette, const Indices& indices) {
  std::array<double, 3> sum{};
  for (const std::uint16_t i : indices) {
    sum[0] += palette[i].r;
    sum[1] += palette[i].g;
    sum[2] += palette[i].b;
  }
  for (double& s : sum) s /= static_cast<double>(indices.size());
  return sum;
}

void expect_mean(const std::vector<Rgb>& palette, const Indices& indices, const Color& light,
                 double tolerance) {
  const auto shown = mean(palette, indices);
  for (std::size_t c = 0; c < 3; ++c) EXPECT_NEAR(shown[c], light[c], tolerance);
}

std::vector<Color> mixable_colors() {
  std::mt19937 random(1);
  std::vector<Color> colors{{0.2159F, 0.2159F, 0.2159F}, {0.5F, 0.5F, 0.5F}, {0.05F, 0.9F, 0.4F}};
  for (int i = 0; i < 6; ++i) {
    Color c{};
    for (float& v : c) v = std::uniform_real_distribution(0.02F, 0.98F)(random);
    colors.push_back(c);
  }
  return colors;
}

TEST(PaletteDiffusion, KeepsTheMeanOfMixableColours) {
  for (const Metric& m : kMetrics) {
    const MixPalette palette(kCube, m, Mix::kLight);
    for (const Color& light : mixable_colors()) {
      for (const bool serpentine : {false, true}) {
        SCOPED_TRACE(testing::Message() << m.name << " " << light[0] << " " << light[1]);
        // What is under way at the end: errors up to the slack, for three rows' rims.
        expect_mean(kCube, diffused(palette, light, serpentine), light, 0.02);
      }
    }
  }
}

TEST(PaletteDiffusion, LightsAsManyDotsAsThereIsLight) {
  const MixPalette palette(kBlackWhite, metric("oklab-toe"), Mix::kLight);
  const Color grey{0.2159F, 0.2159F, 0.2159F};
  for (const bool serpentine : {false, true}) {
    expect_mean(kBlackWhite, diffused(palette, grey, serpentine), grey, 0.005);
  }
}

// The sRGB code of .2159 is 128/255: mixed in encoded numbers, half of the dots are lit.
TEST(PaletteDither, EncodedMixLightsHalfOfTheDots) {
  const MixPalette palette(kBlackWhite, metric("encoded"), Mix::kEncoded);
  const Color grey{0.2159F, 0.2159F, 0.2159F};
  const Color half{0.5F, 0.5F, 0.5F};
  expect_mean(kBlackWhite, diffused(palette, grey), half, 0.01);
  expect_mean(kBlackWhite, ordered(palette, "bayer8", grey), half, 1 / 128.0);
}

TEST(PaletteOrdered, KeepsTheMeanWithinAStepOfTheMatrix) {
  for (const Metric& m : kMetrics) {
    const MixPalette palette(kCube, m, Mix::kLight);
    for (const Color& light : mixable_colors()) {
      SCOPED_TRACE(testing::Message() << m.name << " " << light[0] << " " << light[1]);
      // Of four shares each end between two of 64 ranks.
      expect_mean(kCube, ordered(palette, "bayer8", light), light, 2 / 64.0);
    }
  }
}

TEST(PaletteOrdered, ShowsEntriesAsThemselves) {
  for (const Metric& m : kMetrics) {
    const MixPalette palette(kCube, m, Mix::kLight);
    for (std::size_t i = 0; i < kCube.size(); ++i) {
      const Color light{static_cast<float>(kCube[i].r), static_cast<float>(kCube[i].g),
                        static_cast<float>(kCube[i].b)};
      const Indices only(kSide * kSide, static_cast<std::uint16_t>(i));
      EXPECT_EQ(ordered(palette, "bayer4", light), only) << m.name;
      EXPECT_EQ(diffused(palette, light), only) << m.name;
    }
  }
}

TEST(PaletteNearest, IsTheNearestEntryAndClipsTheRest) {
  const MixPalette palette(kCube, metric("oklab"), Mix::kLight);
  const std::vector<float> rgb{0.9F, 0.1F, 0, 0.1F, 0.9F, 0.9F, 7, 7, 7, -5, -5, -5, 0, 0, 3};
  Indices indices(5);
  palette_nearest_row(palette, rgb, indices);
  EXPECT_EQ(indices, (Indices{1, 6, 7, 0, 4}));
}

TEST(MixPalette, RanksEntriesByLuminance) {
  const MixPalette palette(kCube, metric("oklab"), Mix::kLight);
  // .2126 R + .7152 G + .0722 B: black blue red magenta green cyan yellow white.
  const int expected[] = {0, 2, 4, 6, 1, 3, 5, 7};
  for (int i = 0; i < 8; ++i) EXPECT_EQ(palette.luminance_rank(i), expected[i]);
}

TEST(MixPalette, HoldsColoursNearItself) {
  const MixPalette palette(kBlackWhite, metric("oklab"), Mix::kLight);
  const Color far = palette.bounded({100, -100, 0.5F});
  EXPECT_LT(far[0], 10);
  EXPECT_GT(far[1], -10);
  EXPECT_EQ(far[2], 0.5F);
}

TEST(MixPalette, MixesInTheNumbersOfTheMix) {
  const float grey[] = {0.2159F, 0.2159F, 0.2159F};
  const MixPalette light(kBlackWhite, metric("oklab"), Mix::kLight);
  const MixPalette encoded(kBlackWhite, metric("oklab"), Mix::kEncoded);
  EXPECT_EQ(light.from_light(grey)[0], 0.2159F);
  EXPECT_NEAR(encoded.from_light(grey)[0], 128 / 255.0, 1e-4);
}

TEST(PaletteDiffusion, OneEntryIsAlwaysTaken) {
  const std::vector<Rgb> one{{0.2, 0.4, 0.6}};
  const MixPalette palette(one, metric("lab"), Mix::kLight);
  EXPECT_EQ(diffused(palette, {0.9F, 0, 0.3F}), Indices(kSide * kSide, 0));
  EXPECT_EQ(ordered(palette, "d3", {0.9F, 0, 0.3F}), Indices(kSide * kSide, 0));
}

// A colour that inks cannot mix owes an error for ever; it must not reach its neighbours.
TEST(PaletteDiffusion, ColoursOutsideDoNotRunAway) {
  const std::vector<Rgb> inks{{0, 0, 0}, {1, 1, 1}, {0.3, 0.02, 0.02}, {0.02, 0.2, 0.03}};
  const MixPalette palette(inks, metric("oklab-toe"), Mix::kLight);
  PaletteDiffusion diffusion(palette, kSide, {});
  std::vector<float> blue;
  std::vector<float> grey;
  for (int x = 0; x < kSide; ++x) {
    blue.insert(blue.end(), {0, 0, 1});
    grey.insert(grey.end(), {0.5F, 0.5F, 0.5F});
  }
  Indices indices(kSide);
  for (int y = 0; y < kSide; ++y) diffusion.row(blue, indices);
  Indices below;
  for (int y = 0; y < kSide; ++y) {
    diffusion.row(grey, indices);
    below.insert(below.end(), indices.begin(), indices.end());
  }
  expect_mean(inks, below, {0.5F, 0.5F, 0.5F}, 0.02);
}

// Dark fields lose most where diffusion begins without error; .15 of L* near black is .00017.
TEST(PaletteDiffusion, KeepsTheToneOfDarkFieldsAtTheTop) {
  const Rgb ends[] = {{0, 0, 0}, {1, 1, 1}};
  const MixPalette palette(ends, *find_by_name(kMetrics, "oklab-toe"), Mix::kLight);
  constexpr int kWidth = 768;
  constexpr int kHeight = 256;
  constexpr float kLight = 0.0052F;
  const std::vector<float> row(std::size_t{3} * kWidth, kLight);
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    if (passed_on(kernel) < 1) continue;
    PaletteDiffusion diffusion(palette, kWidth,
                               {.kernel = &kernel, .serpentine = true, .jitter = kernel.jitter});
    std::vector<std::uint16_t> indices(kWidth);
    double lit = 0;
    for (int y = 0; y < kHeight; ++y) {
      diffusion.row(row, indices);
      for (std::size_t x = 256; x < 512; ++x) lit += indices[x];  // the sides drop error
    }
    EXPECT_NEAR(lit / (256 * kHeight), kLight, 0.00017) << kernel.name;
  }
}

}  // namespace
}  // namespace tristim
