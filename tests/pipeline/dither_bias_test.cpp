#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/pipeline/pictures.h"
#include "tristim/device/display_file.h"
#include "tristim/pipeline/reduce.h"

namespace tristim {
namespace {

constexpr int kSide = 256;
constexpr double kMostBias = 0.005;  // of a step between two codes

// By how much light comes out brighter than it went in, in steps.
double bias(const Display& display, const NamedDither& dither, const Image& picture, double step) {
  Image light(kSide, kSide, 3);
  std::ranges::copy(picture.view().row(0).data(),
                    picture.view().row(0).data() + std::ptrdiff_t{3} * kSide * kSide,
                    light.view().data);
  Reducer reducer(display, {.dither = dither.method}, kSide);
  Raster<std::uint16_t> codes(kSide, kSide, 3);
  reducer.reduce({light.view(), 0}, codes.view());
  Image shown(kSide, kSide, 3);
  Decoder(display).decode(codes.view(), shown.view());
  double sum = 0;
  for (int y = 0; y < kSide; ++y) {
    const auto out = shown.view().row(y);
    const auto in = picture.view().row(y);
    for (std::size_t i = 0; i < out.size(); ++i) sum += double{out[i]} - double{in[i]};
  }
  return sum / (3.0 * kSide * kSide) / step;
}

// A matrix gives the nearest of its counts of dots.
double allowed(const NamedDither& dither) {
  const std::vector<ThresholdMatrix> matrices = dither_matrices(dither.method, {}, 1);
  if (matrices.empty()) return kMostBias;
  return kMostBias + 0.5 / matrices.front().ranks;
}

TEST(Dithers, AddAndLoseNothingBetweenEightBitCodes) {
  const Display display = load_display("srgb");
  const Decoder decoder(display);
  const auto light_of = [&](std::uint16_t code) {
    const std::uint16_t samples[3] = {code, code, code};
    return decoder.light(samples).r;
  };
  for (const NamedDither& dither : dither_methods()) {
    const auto* kernel = std::get_if<DiffusionKernel>(&dither.method);
    if (dither.name == "none" || (kernel != nullptr && passed_on(*kernel) < 1)) continue;
    for (const std::uint16_t code : {std::uint16_t{3}, std::uint16_t{200}}) {
      const double lower = light_of(code);
      const double step = light_of(static_cast<std::uint16_t>(code + 1)) - lower;
      for (const double fraction : {0.06, 0.5}) {
        const auto light = static_cast<float>(lower + fraction * step);
        const Image field = flat_picture(kSide, kSide, light, light, light);
        EXPECT_LE(std::abs(bias(display, dither, field, step)), allowed(dither))
            << dither.name << ", " << fraction << " above code " << code;
      }
      Image ramp(kSide, kSide, 3);
      for (int y = 0; y < kSide; ++y) {
        for (int i = 0; i < 3 * kSide; ++i) {
          ramp.view().row(y)[static_cast<std::size_t>(i)] =
              static_cast<float>(lower + step * (i / 3 + 0.5) / kSide);
        }
      }
      EXPECT_LE(std::abs(bias(display, dither, ramp, step)), allowed(dither))
          << dither.name << ", ramp from code " << code;
    }
  }
}

}  // namespace
}  // namespace tristim
