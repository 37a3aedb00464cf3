#include "tristim/dither/whole_picture.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tristim/core/find.h"

namespace tristim {
namespace {

const MixLevels kBlackAndWhite{{0, 1}, {0, 1}};
const MixLevels kUneven{{0, 0.1F, 0.15F, 0.7F, 1}, {9, 8, 7, 6, 5}};

Raster<float> flat(int width, int height, float light) {
  Raster<float> picture(width, height, 1);
  for (int y = 0; y < height; ++y) std::ranges::fill(picture.view().row(y), light);
  return picture;
}

Raster<float> noise(int width, int height, float low, float high) {
  std::mt19937 random(5);
  Raster<float> picture(width, height, 1);
  for (int y = 0; y < height; ++y) {
    for (float& v : picture.view().row(y)) v = std::uniform_real_distribution(low, high)(random);
  }
  return picture;
}

Raster<std::uint16_t> dithered(const WholePictureDither& dither, const MixLevels& levels,
                               const Raster<float>& picture,
                               const WholePictureParameters& parameters = {}) {
  const ImageView<const float> light = picture.view();
  Raster<std::uint16_t> codes(light.width, light.height, 1);
  for (int y = 0; y < light.height; ++y) std::ranges::fill(codes.view().row(y), 99);
  dither.channel(light, levels, parameters, codes.view());
  return codes;
}

std::vector<std::uint16_t> all_codes(const Raster<std::uint16_t>& codes) {
  std::vector<std::uint16_t> all;
  for (int y = 0; y < codes.view().height; ++y) {
    all.insert(all.end(), codes.view().row(y).begin(), codes.view().row(y).end());
  }
  return all;
}

double mean_light(const MixLevels& levels, const Raster<std::uint16_t>& codes) {
  double sum = 0;
  const auto all = all_codes(codes);
  for (const std::uint16_t code : all) {
    const auto at = std::ranges::find(levels.code, code) - levels.code.begin();
    sum += levels.light[static_cast<std::size_t>(at)];
  }
  return sum / static_cast<double>(all.size());
}

TEST(WholePictureDithers, GiveEveryPixelOfAnySizeACode) {
  for (const WholePictureDither& dither : kWholePictureDithers) {
    SCOPED_TRACE(dither.name);
    for (const auto& [width, height] :
         {std::pair{1, 1}, {1, 9}, {9, 1}, {7, 8}, {16, 16}, {17, 40}, {70, 130}, {200, 3}}) {
      for (const MixLevels* levels : {&kBlackAndWhite, &kUneven}) {
        for (const auto code : all_codes(dithered(dither, *levels, noise(width, height, 0, 1)))) {
          ASSERT_NE(std::ranges::find(levels->code, code), levels->code.end());
        }
      }
    }
  }
}

TEST(WholePictureDithers, KeepLevelsAsTheyAre) {
  for (const WholePictureDither& dither : kWholePictureDithers) {
    for (std::size_t i = 0; i < kUneven.light.size(); ++i) {
      const auto codes = dithered(dither, kUneven, flat(30, 20, kUneven.light[i]));
      EXPECT_EQ(all_codes(codes), std::vector<std::uint16_t>(600, kUneven.code[i])) << dither.name;
    }
    const MixLevels one{{0.5F}, {3}};
    EXPECT_EQ(all_codes(dithered(dither, one, noise(9, 9, 0, 1))),
              std::vector<std::uint16_t>(81, 3));
  }
}

TEST(WholePictureDithers, KeepTheTone) {
  for (const WholePictureDither& dither : kWholePictureDithers) {
    SCOPED_TRACE(dither.name);
    for (const MixLevels* levels : {&kBlackAndWhite, &kUneven}) {
      for (const float light : {0.01F, 0.06F, 0.117F, 0.2159F, 0.5F, 0.8F, 0.97F}) {
        const auto codes = dithered(dither, *levels, flat(256, 256, light));
        // A dot in 400 pixels: what is dropped at the sides of dot diffusion.
        EXPECT_NEAR(mean_light(*levels, codes), light, 0.0025);
      }
    }
  }
}

TEST(WholePictureDithers, TakeTheNearestLevelWhereThereIsNoStrength) {
  const Raster<float> picture = noise(40, 50, -0.1F, 1.1F);
  Raster<float> mask(40, 50, 1);
  for (int y = 0; y < 50; ++y) std::ranges::fill(mask.view().row(y).subspan(20), 1.0F);
  for (const WholePictureDither& dither : kWholePictureDithers) {
    SCOPED_TRACE(dither.name);
    const auto none = dithered(dither, kBlackAndWhite, picture, {.strength = 0});
    const auto half = dithered(dither, kBlackAndWhite, picture, {.dither_mask = mask.view()});
    int different = 0;
    for (int y = 0; y < 50; ++y) {
      for (int x = 0; x < 40; ++x) {
        const int nearest = *std::as_const(picture).view().pixel(x, y) > 0.5F ? 1 : 0;
        ASSERT_EQ(*none.view().pixel(x, y), nearest);
        if (x < 20) ASSERT_EQ(*half.view().pixel(x, y), nearest);
        if (*half.view().pixel(x, y) != nearest) ++different;
      }
    }
    EXPECT_GT(different, 20);
  }
}

// The first sixteen pixels of .4 along the curve; weights 1 : 16 from the oldest to the newest.
TEST(Riemersma, FollowsTheHilbertCurve) {
  const auto& riemersma = *find_by_name(kWholePictureDithers, "riemersma");
  const auto codes = dithered(riemersma, kBlackAndWhite, flat(2, 2, 0.4F));
  // (0, 0): .4 dark. (0, 1): .4 + .174 x .4 = .47 dark. (1, 1): .4 + .174 x .47 + .144 x .4 = .54
  // lit. (1, 0): .4 + .174 x -.46 + .144 x .47 + .12 x .4 = .44 dark.
  EXPECT_EQ(all_codes(codes), (std::vector<std::uint16_t>{0, 0, 0, 1}));
}

// Class 0 at (1, 6) is first; at .6 it is lit and owes .4 to its eight later neighbours.
TEST(DotDiffusion, GoesByClasses) {
  const auto& knuth = *find_by_name(kWholePictureDithers, "dot-diffusion");
  Raster<float> picture = flat(8, 8, 0);
  *picture.view().pixel(1, 6) = 0.49F;
  *picture.view().pixel(1, 5) = 0.45F;  // class 4 receives 2/12 of .49: .53
  const auto codes = dithered(knuth, kBlackAndWhite, picture);
  EXPECT_EQ(*codes.view().pixel(1, 6), 0);
  EXPECT_EQ(*codes.view().pixel(1, 5), 1);
}

// Error that the eye sees: the light of 9 x 9 pixels, weighted by a pyramid.
double seen_error(const Raster<float>& picture, const Raster<std::uint16_t>& codes) {
  double sum = 0;
  for (int y = 4; y < picture.view().height - 4; ++y) {
    for (int x = 4; x < picture.view().width - 4; ++x) {
      double seen = 0;
      for (int dy = -4; dy <= 4; ++dy) {
        for (int dx = -4; dx <= 4; ++dx) {
          const double light = *picture.view().pixel(x + dx, y + dy);
          seen += (5 - std::abs(dx)) * (5 - std::abs(dy)) *
                  (*codes.view().pixel(x + dx, y + dy) - light);
        }
      }
      sum += seen * seen;
    }
  }
  return sum;
}

TEST(DirectSearch, LessensWhatTheEyeSees) {
  const auto& search = *find_by_name(kWholePictureDithers, "direct-search");
  Raster<float> picture(96, 96, 1);
  for (int y = 0; y < 96; ++y) {
    for (int x = 0; x < 96; ++x) {
      *picture.view().pixel(x, y) = static_cast<float>(x + y) / 190;
    }
  }
  double last = 1e30;
  for (const int effort : {1, 3, 12}) {
    const auto codes = dithered(search, kBlackAndWhite, picture, {.effort = effort});
    EXPECT_LE(seen_error(picture, codes), 1.01 * last);  // the test's eye is a simpler one
    last = seen_error(picture, codes);
  }
  const auto& other = *find_by_name(kWholePictureDithers, "riemersma");
  EXPECT_LT(last, 0.5 * seen_error(picture, dithered(other, kBlackAndWhite, picture)));
}

}  // namespace
}  // namespace tristim
