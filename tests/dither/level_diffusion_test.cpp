#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "lib/dither/position_noise.h"
#include "tests/dither/channel_pictures.h"
#include "tristim/dither/levels.h"

namespace tristim {
namespace {

DiffusionOptions own_options(const DiffusionKernel& kernel) {
  return {.kernel = &kernel, .serpentine = kernel.serpentine, .jitter = kernel.jitter};
}

Codes diffused(const MixLevels& levels, const DiffusionOptions& options, const Picture& picture,
               float strength = 1) {
  const std::vector<float> shares(static_cast<std::size_t>(picture.width), strength);
  LevelDiffusion diffusion(levels, picture.width, options);
  Codes codes(picture.light.size());
  for (int y = 0; y < picture.height; ++y) {
    const std::ptrdiff_t start = std::ptrdiff_t{y} * picture.width;
    diffusion.row({picture.light.data() + start, picture.width, 1},
                  {codes.data() + start, picture.width, 1}, shares);
  }
  return codes;
}

// The definition written out once more, on a whole picture and without tables: one bit, the plain
// borders.
Codes plain_diffusion(const DiffusionOptions& options, const Picture& picture, float strength = 1) {
  const DiffusionKernel& kernel = *options.kernel;
  const int w = picture.width;
  std::vector<float> errors(picture.light.size(), 0);
  Codes codes(picture.light.size());
  for (int y = 0; y < picture.height; ++y) {
    const int step = options.serpentine && y % 2 == 1 ? -1 : 1;
    for (int x = step > 0 ? 0 : w - 1; x >= 0 && x < w; x += step) {
      const auto at = static_cast<std::size_t>(y * w + x);
      const float light = std::clamp(picture.light[at], 0.0F, 1.0F);
      const float wanted = light + errors[at] * strength;
      const float chance = detail::position_noise(x, y, 0);
      float threshold = 0.5F + options.jitter * (chance - 0.5F);
      const auto give = [&](int dx, int dy, float share) {
        const int to = x + step * dx;
        if (to < 0 || to >= w || y + dy >= picture.height) return;
        errors[static_cast<std::size_t>((y + dy) * w + to)] += share;
      };
      if (kernel.tones != nullptr) threshold += kernel.tones()[tone_index(light)].raise * chance;
      codes[at] = wanted - (threshold - 0.5F) > 0.5F ? 1 : 0;
      const float error = (wanted - codes[at]) * strength;
      if (kernel.tones != nullptr) {
        const ToneWeights& tone = kernel.tones()[tone_index(light)];
        give(1, 0, error * tone.next);
        give(-1, 1, error * tone.below_last);
        give(0, 1, error * tone.below);
        continue;
      }
      for (int dy = 0; dy < 4; ++dy) {
        for (int dx = -3; dx <= 3; ++dx) {
          const int weight =
              kernel.weight[static_cast<std::size_t>(dy)][static_cast<std::size_t>(dx + 3)];
          if (weight == 0) continue;
          give(dx, dy, error * (static_cast<float>(weight) / static_cast<float>(kernel.divisor)));
        }
      }
    }
  }
  return codes;
}

TEST(LevelDiffusion, IsThePlainDefinitionForEveryOpenKernel) {
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    if (kernel.closed) continue;
    SCOPED_TRACE(kernel.name);
    for (const int width : {1, 2, 3, 4, 31}) {
      const Picture picture = noise(width, 20, static_cast<unsigned>(width));
      for (const bool serpentine : {false, true}) {
        const DiffusionOptions options{.kernel = &kernel, .serpentine = serpentine};
        EXPECT_EQ(diffused(kBlackAndWhite, options, picture), plain_diffusion(options, picture));
      }
    }
  }
}

TEST(LevelDiffusion, PassesOnAShareOfTheError) {
  const Picture picture = noise(40, 20, 3);
  for (const float strength : {0.0F, 0.5F, 1.0F}) {
    EXPECT_EQ(diffused(kBlackAndWhite, {}, picture, strength),
              plain_diffusion({}, picture, strength));
  }
  EXPECT_EQ(diffused(kBlackAndWhite, {}, flat(40, 20, 0.49F), 0), Codes(800, 0));
}

// Patches of sRGB k/16 side by side, 256 x 256: largest |dL*| of the means, 16 pixels left out at
// the sides of each as there errors pass from one to the next.
struct ToneError {
  double largest = 0;
  int patch = 0;
};

double lightness(double y) { return y > 216.0 / 24389 ? 116 * std::cbrt(y) - 16 : y * 24389 / 27; }

ToneError tone_error(const MixLevels& levels, const DiffusionOptions& options) {
  constexpr int kSide = 256;
  constexpr int kPatches = 17;
  Picture picture = flat(kPatches * kSide, kSide, 0);
  const auto light_of = [](int patch) {
    const double v = patch / 16.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  for (std::size_t i = 0; i < picture.light.size(); ++i) {
    const int x = static_cast<int>(i) % picture.width;
    picture.light[i] = static_cast<float>(light_of(x / kSide));
  }
  const Codes codes = diffused(levels, options, picture);
  ToneError worst;
  for (int patch = 0; patch < kPatches; ++patch) {
    double sum = 0;
    for (int y = 0; y < kSide; ++y) {
      for (int x = patch * kSide + 16; x < (patch + 1) * kSide - 16; ++x) {
        sum += levels.light[codes[static_cast<std::size_t>(y * picture.width + x)]];
      }
    }
    const double mean = sum / (kSide * (kSide - 32));
    const double error = std::abs(lightness(mean) - lightness(light_of(patch)));
    if (error > worst.largest) worst = {error, patch};
  }
  return worst;
}

TEST(LevelDiffusion, KeepsTheToneOfPatches) {
  for (const DiffusionKernel& kernel : kDiffusionKernels) {
    if (passed_on(kernel) < 1) continue;
    SCOPED_TRACE(kernel.name);
    for (const MixLevels* levels : {&kBlackAndWhite, &kUneven}) {
      const ToneError worst = tone_error(*levels, own_options(kernel));
      EXPECT_LE(worst.largest, 0.15) << "patch " << worst.patch << ", " << levels->light.size();
    }
  }
}

}  // namespace
}  // namespace tristim
