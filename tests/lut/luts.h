#pragma once

#include <random>

#include "tristim/lut/lut.h"

namespace tristim {

/// A cube of random numbers in [0, 1): what interpolates worst.
inline Lut3D noise_cube(int size, unsigned seed, LutRange range = {}) {
  Lut3D cube{range, size, std::vector<float>(cube_samples(size))};
  std::mt19937 random(seed);
  for (float& x : cube.rgb) x = static_cast<float>(random() >> 8) * 0x1p-24F;
  return cube;
}

/// A cube of what `step` makes of its points.
inline Lut3D sampled(const LutStep& step, int size, LutRange range = {}) {
  Lut3D cube{range, size, {}};
  const auto at = [&](int i, std::size_t c) {
    return range.low[c] + (range.high[c] - range.low[c]) * i / (size - 1);
  };
  for (int b = 0; b < size; ++b) {
    for (int g = 0; g < size; ++g) {
      for (int r = 0; r < size; ++r) {
        const Rgb out = evaluate(step, {at(r, 0), at(g, 1), at(b, 2)});
        for (const double x : {out.r, out.g, out.b}) cube.rgb.push_back(static_cast<float>(x));
      }
    }
  }
  return cube;
}

}  // namespace tristim
