#include "tristim/dither/levels.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/dither/channel_pictures.h"
#include "tristim/dither/matrices.h"
#include "tristim/dither/ordered.h"

namespace tristim {
namespace {

// Calls row(in, y, out) for each row of the picture.
template <typename Row>
Codes each_row(const Picture& picture, Row&& row) {
  Codes codes(picture.light.size());
  for (int y = 0; y < picture.height; ++y) {
    const std::ptrdiff_t start = std::ptrdiff_t{y} * picture.width;
    row(ChannelRow<const float>{picture.light.data() + start, picture.width, 1}, y,
        ChannelRow<std::uint16_t>{codes.data() + start, picture.width, 1});
  }
  return codes;
}

Codes ordered(const MixLevels& levels, const MatrixRecipe& recipe, const Picture& picture) {
  const OrderedDither dither(levels, make_matrix(recipe));
  return each_row(picture, [&](auto in, int y, auto out) { dither.row(in, y, out); });
}

Codes diffused(const MixLevels& levels, const DiffusionOptions& options, const Picture& picture) {
  LevelDiffusion diffusion(levels, picture.width, options);
  return each_row(picture, [&](auto in, int, auto out) { diffusion.row(in, out); });
}

double mean_light(const MixLevels& levels, const Codes& codes) {
  double sum = 0;
  for (const std::uint16_t code : codes) sum += levels.light[code];
  return sum / static_cast<double>(codes.size());
}

TEST(NearestLevel, TakesACodeFromItsThresholdOn) {
  const float thresholds[] = {0.2F, 0.6F};
  const std::uint16_t codes[] = {7, 3, 9};
  const NearestLevel nearest(thresholds, codes);
  const float in[] = {-1, 0.19F, 0.2F, 0.59F, 0.6F, 5, std::nanf("")};
  Codes out(std::size(in));
  nearest.row({in, static_cast<int>(std::size(in)), 1}, {out.data(), 7, 1});
  EXPECT_EQ(out, (Codes{7, 7, 3, 3, 9, 9, 7}));
}

TEST(NearestLevel, StepsOverTheOtherChannels) {
  const float thresholds[] = {0.5F};
  const std::uint16_t codes[] = {0, 1};
  const float in[] = {1, 0, 0, 1, 0, 0};
  Codes out(6, 5);
  NearestLevel(thresholds, codes).row({in, 2, 3}, {out.data(), 2, 3});
  EXPECT_EQ(out, (Codes{1, 5, 5, 1, 5, 5}));
}

TEST(OrderedDither, LightsExactlySCellsOfAFlatField) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    const int cells = recipe.size * recipe.size;
    const int step = 1 + cells / 300;  // every count of the small ones
    for (int s = 0; s <= cells; s += step) {
      const float light = static_cast<float>(s) / static_cast<float>(cells);
      const Codes codes = ordered(kBlackAndWhite, recipe, flat(recipe.size, recipe.size, light));
      ASSERT_EQ(std::ranges::count(codes, 1), s) << recipe.name;
    }
  }
}

TEST(OrderedDither, ShiftsEveryRowOfTilesByTheMatrixShift) {
  ThresholdMatrix matrix{.name = "shifted", .width = 5, .height = 2, .ranks = 10, .shift = 3};
  matrix.rank = {0, 9, 9, 9, 9, 1, 9, 9, 9, 9};
  const OrderedDither dither(kBlackAndWhite, matrix);
  const Codes codes =
      each_row(flat(12, 9, 0.2F), [&](auto in, int y, auto out) { dither.row(in, y, out); });
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 12; ++x) {
      const bool first_column = (x - y / 2 * 3 + 60) % 5 == 0;
      ASSERT_EQ(codes[static_cast<std::size_t>(12 * y + x)], first_column ? 1 : 0) << x << " " << y;
    }
  }
}

TEST(OrderedDither, TakesRowsFromYAndTilesFromTheTopLeft) {
  const MatrixRecipe& d2 = kMatrixRecipes[0];  // [0 2; 3 1]
  EXPECT_EQ(ordered(kBlackAndWhite, d2, flat(4, 3, 0.25F)),
            (Codes{1, 0, 1, 0, 0, 0, 0, 0, 1, 0, 1, 0}));
  EXPECT_EQ(ordered(kBlackAndWhite, d2, flat(4, 2, 0.75F)), (Codes{1, 1, 1, 1, 0, 1, 0, 1}));
}

TEST(OrderedDither, KeepsTheToneOfUnequalLevels) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    SCOPED_TRACE(recipe.name);
    const double cells = recipe.size * recipe.size;
    for (float light = 0; light <= 1; light += cells > 4096 ? 0.05F : 0.003F) {
      const Codes codes = ordered(kUneven, recipe, flat(recipe.size, recipe.size, light));
      const auto above = std::ranges::upper_bound(kUneven.light, light);
      const double step = above == kUneven.light.end() ? 0 : *above - *(above - 1);
      // Half a rank of the step between the levels, and the rounding of floats.
      ASSERT_NEAR(mean_light(kUneven, codes), light, step / (2 * cells) + 1e-6);
    }
  }
}

TEST(OrderedDither, TakesTheEndLevelOutside) {
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    const MixLevels levels{{0.2F, 0.8F}, {5, 6}};
    const int side = recipe.size;
    const auto only = [&](float light, std::uint16_t code) {
      return ordered(levels, recipe, flat(side, side, light)) ==
             Codes(static_cast<std::size_t>(side * side), code);
    };
    EXPECT_TRUE(only(-1, 5) && only(0.1F, 5) && only(0.2F, 5) && only(0.8F, 6) && only(9, 6));
    EXPECT_TRUE(only(std::numeric_limits<float>::infinity(), 6) && only(std::nanf(""), 5));
  }
}

TEST(OneLevel, IsAlwaysTaken) {
  const MixLevels one{{0.3F}, {4}};
  const Picture picture = noise(9, 4, 1);
  EXPECT_EQ(ordered(one, kMatrixRecipes[2], picture), Codes(36, 4));
  EXPECT_EQ(diffused(one, {}, picture), Codes(36, 4));
}

// The worked flat .4: .4 is dark, .4 + .175 lit, .4 - .1859375 dark; then .4453125, .5271484,
// .2334595; then .4505005, .5209332, .2338116.
TEST(LevelDiffusion, FollowsTheExampleByHand) {
  EXPECT_EQ(diffused(kBlackAndWhite, {}, flat(3, 3, 0.4F)), (Codes{0, 1, 0, 0, 1, 0, 0, 1, 0}));
}

// Exactly half way is not above half way.
TEST(LevelDiffusion, TakesTheUpperLevelAboveHalfWay) {
  EXPECT_EQ(diffused(kBlackAndWhite, {}, flat(1, 1, 0.5F)), Codes{0});
  EXPECT_EQ(diffused(kBlackAndWhite, {}, flat(1, 1, std::nextafter(0.5F, 1.0F))), Codes{1});
}

// Floyd-Steinberg written out once more, on a whole picture.
Codes plain_floyd_steinberg(const MixLevels& levels, bool serpentine, const Picture& picture) {
  const int w = picture.width;
  const int h = picture.height;
  std::vector<float> errors(picture.light.size(), 0);
  Codes codes(picture.light.size());
  for (int y = 0; y < h; ++y) {
    const int step = serpentine && y % 2 == 1 ? -1 : 1;
    for (int x = step > 0 ? 0 : w - 1; x >= 0 && x < w; x += step) {
      const auto at = static_cast<std::size_t>(y * w + x);
      const float clipped =
          std::clamp(picture.light[at], levels.light.front(), levels.light.back());
      const float wanted = clipped + errors[at];
      std::size_t level = 0;
      while (level + 1 < levels.light.size() &&
             wanted > (double{levels.light[level]} + levels.light[level + 1]) / 2) {
        ++level;
      }
      codes[at] = levels.code[level];
      const float error = wanted - levels.light[level];
      const auto give = [&](int dx, int dy, float weight) {
        const int to = x + step * dx;
        if (to < 0 || to >= w || y + dy >= h) return;
        errors[static_cast<std::size_t>((y + dy) * w + to)] += error * weight;
      };
      give(1, 0, 7 / 16.0F);
      give(-1, 1, 3 / 16.0F);
      give(0, 1, 5 / 16.0F);
      give(1, 1, 1 / 16.0F);
    }
  }
  return codes;
}

TEST(LevelDiffusion, IsFloydSteinbergWithAndWithoutSerpentine) {
  for (const MixLevels* levels : {&kBlackAndWhite, &kUneven}) {
    for (const int width : {1, 2, 3, 31}) {
      const Picture picture = noise(width, 20, static_cast<unsigned>(width));
      for (const bool serpentine : {false, true}) {
        EXPECT_EQ(diffused(*levels, {.serpentine = serpentine}, picture),
                  plain_floyd_steinberg(*levels, serpentine, picture));
      }
    }
  }
}

// Chosen in perception, mixed in light: a flat sRGB 128 lights 21.6 % of the dots.
TEST(Dither, LightsAsManyDotsAsThereIsLight) {
  constexpr float kGrey = 0.2159F;
  constexpr int kSide = 256;
  for (const MatrixRecipe& recipe : kMatrixRecipes) {
    if (recipe.size * recipe.size < 64) continue;
    const Codes codes = ordered(kBlackAndWhite, recipe, flat(kSide, kSide, kGrey));
    EXPECT_NEAR(mean_light(kBlackAndWhite, codes), kGrey, 0.005) << recipe.name;
  }
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    if (passed_on(kernel) < 1) continue;
    for (const bool serpentine : {false, true}) {
      const Codes codes =
          diffused(kBlackAndWhite, {&kernel, serpentine}, flat(kSide, kSide, kGrey));
      EXPECT_NEAR(mean_light(kBlackAndWhite, codes), kGrey, 0.005) << kernel.name;
    }
  }
}

RC_GTEST_PROP(LevelDiffusion, KeepsTheToneOfUnequalLevels, ()) {
  const float light = static_cast<float>(*rc::gen::inRange(0, 1001)) / 1000.0F;
  const bool serpentine = *rc::gen::arbitrary<bool>();
  const Codes codes = diffused(kUneven, {.serpentine = serpentine}, flat(64, 64, light));
  // What is left below the last row and dropped at the sides: half a level for each pixel of them.
  RC_ASSERT(std::fabs(mean_light(kUneven, codes) - light) <= 0.275 * (64 + 64) / (64.0 * 64));
}

}  // namespace
}  // namespace tristim
