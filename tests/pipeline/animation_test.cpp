// Pictures of an animation: what stands still must not flicker under a fixed mask, and what
// flickers under a mask of its own for every picture must do so around the tone.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/pipeline/pictures.h"
#include "tristim/core/find.h"
#include "tristim/device/display_file.h"
#include "tristim/dither/matrices.h"
#include "tristim/pipeline/chain.h"
#include "tristim/pipeline/dither_trial.h"

namespace tristim {
namespace {

constexpr int kSide = 64;

std::vector<std::uint16_t> codes_of(const Display& display, const Settings& settings,
                                    Image picture) {
  Reducer reducer(display, reduce_options(display, settings), picture.view().width);
  Raster<std::uint16_t> codes(picture.view().width, picture.view().height, reducer.samples());
  reducer.reduce({picture.view(), 0}, codes.view());
  std::vector<std::uint16_t> all;
  for (int y = 0; y < picture.view().height; ++y) {
    const auto row = codes.view().row(y);
    all.insert(all.end(), row.begin(), row.end());
  }
  return all;
}

bool in_square(int x, int y, int frame) {
  return x >= 4 * frame && x < 4 * frame + 12 && y >= 20 && y < 32;
}

// A bright square that moves to the right over a picture that stands still.
Image moving_square(int frame) {
  Image picture = test_picture(kSide, kSide);
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      if (in_square(x, y, frame)) std::fill_n(picture.view().pixel(x, y), 3, 0.7F);
    }
  }
  return picture;
}

TEST(Animation, StandsStillUnderAFixedMask) {
  for (const char* device : {"laser-300", "epaper-7color", "vga16", "lcd-rgb565", "offset-cmyk"}) {
    const Display display = load_display(device);
    for (const char* dither : {"blue-noise", "bayer8", "screen"}) {
      SCOPED_TRACE(device + std::string(", ") + dither);
      Settings settings;
      settings.dither = *find_by_name(dither_methods(), dither);
      const auto before = codes_of(display, settings, moving_square(0));
      const auto after = codes_of(display, settings, moving_square(5));
      const std::size_t samples = before.size() / (kSide * kSide);
      int still = 0;
      int moved = 0;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const auto pixel = static_cast<int>(i / samples);
        const int x = pixel % kSide;
        const int y = pixel / kSide;
        const bool changes = in_square(x, y, 0) || in_square(x, y, 5);
        if (before[i] != after[i]) ++(changes ? moved : still);
      }
      EXPECT_EQ(still, 0);
      EXPECT_GT(moved, 0);
    }
  }
}

// How far the mean of a number of pictures is from the tone, pixel by pixel: root of mean squares.
double error_of_mean(int pictures, int step, float tone) {
  const Display display = one_bit_display();
  std::vector<double> sum(kSide * kSide, 0.0);
  for (int i = 0; i < pictures; ++i) {
    Settings settings;
    settings.dither = *find_by_name(dither_methods(), "blue-noise");
    settings.dither_parameters.size = kSide;
    settings.dither_parameters.frame = step * i;
    const auto codes = codes_of(display, settings, flat_picture(kSide, kSide, tone, tone, tone));
    double lit = 0;
    for (std::size_t k = 0; k < codes.size(); ++k) sum[k] += codes[k];
    for (const std::uint16_t code : codes) lit += code;
    EXPECT_NEAR(lit / (kSide * kSide), tone, 1e-3) << i;  // each has the tone by itself
  }
  double squares = 0;
  for (const double lit : sum) squares += (lit / pictures - tone) * (lit / pictures - tone);
  return std::sqrt(squares / (kSide * kSide));
}

TEST(Animation, PicturesOfSlicesMixToTheTone) {
  for (const float tone : {0.25F, 0.5F, 0.75F}) {
    SCOPED_TRACE(tone);
    const double one = std::sqrt(tone * (1 - tone));
    EXPECT_NEAR(error_of_mean(1, 1, tone), one, 0.01);
    // Independent pictures mix with the root of their number; these are spread along time.
    EXPECT_LT(error_of_mean(4, 1, tone), 0.72 * one / 2);
    EXPECT_LT(error_of_mean(kBlueNoiseFrames, 1, tone), 0.6 * one / 4);
  }
  EXPECT_GT(error_of_mean(4, kBlueNoiseFrames, 0.5F), 0.49);  // the same slice again: no mixing
}

}  // namespace
}  // namespace tristim
