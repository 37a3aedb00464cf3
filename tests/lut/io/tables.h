#pragma once

#include <cmath>
#include <random>
#include <string>

#include "tristim/lut/io/file.h"

namespace tristim {

/// Values with all the bits of a float, or codes of so many bits where the format has integers.
inline float test_value(std::mt19937& generator, int bits) {
  if (bits > 0) {
    const unsigned most = (1U << bits) - 1;
    return static_cast<float>(generator() % (most + 1)) / static_cast<float>(most);
  }
  return std::ldexp(static_cast<float>(generator() % (1U << 24)), -24) * 1.3F - 0.1F;
}

inline Lut1D test_curves(int size, int bits, const LutRange& range = {}) {
  std::mt19937 generator(static_cast<unsigned>(size));
  Lut1D curves{range, size, {}};
  for (std::size_t i = 0; i < curve_samples(size); ++i) {
    curves.rgb.push_back(test_value(generator, bits));
  }
  curves.rgb.back() = 1;
  return curves;
}

inline Lut3D test_cube(int size, int bits, const LutRange& range = {}) {
  std::mt19937 generator(static_cast<unsigned>(size));
  Lut3D cube{range, size, {}};
  for (std::size_t i = 0; i < cube_samples(size); ++i) {
    cube.rgb.push_back(test_value(generator, bits));
  }
  cube.rgb.back() = 1;
  return cube;
}

/// A curve that rises, the same for all channels.
inline Lut1D test_shaper(int size, int bits, const LutRange& range = {}) {
  Lut1D curves{range, size, {}};
  const float most = bits > 0 ? std::ldexp(1.0F, bits) - 1 : 0;
  for (int i = 0; i < size; ++i) {
    float value = std::sqrt(static_cast<float>(i) / static_cast<float>(size - 1));
    if (bits > 0) value = std::round(value * most) / most;
    curves.rgb.insert(curves.rgb.end(), 3, value);
  }
  return curves;
}

inline LutRange test_range(LutRanges ranges) {
  switch (ranges) {
    case LutRanges::kUnit:
      return {};
    case LutRanges::kEqual:
      return {{-0.1, -0.1, -0.1}, {1.7, 1.7, 1.7}};
    case LutRanges::kAny:
      return {{-0.1, 0, 0.025}, {1.7, 2, 65504}};
  }
  return {};
}

/// A table of every kind that the format holds.
inline std::vector<Lut> test_luts(const LutFormat& format) {
  const LutCapacity& holds = format.holds;
  std::vector<Lut> luts;
  const auto add = [&](std::vector<LutStep> steps) { luts.push_back({"A \"table\"", steps}); };
  const auto sizes = [&](std::vector<int> usual) {
    if (!holds.sizes.empty()) usual.assign(holds.sizes.begin(), holds.sizes.begin() + 3);
    return usual;
  };
  for (const LutRanges ranges : {LutRanges::kUnit, holds.alone}) {
    const LutRange range = test_range(ranges);
    if (holds.curves > 0) {
      for (const int size : sizes({2, 17, 256})) add({test_curves(size, holds.bits, range)});
    }
    if (holds.cube > 0) {
      for (const int size : sizes({2, 3, 9, 17})) add({test_cube(size, holds.bits, range)});
    }
  }
  if (holds.shaper > 0) {
    add({test_shaper(64, holds.bits, test_range(holds.first)),
         test_cube(5, holds.bits, test_range(holds.second))});
  }
  if (holds.any) {
    LutMatrix matrix;
    matrix.matrix << 0.1, 1.5, -1.0 / 3, 0, 1, 1e-9, 12345.678, -7, 0.25;
    matrix.offset << 0.5, -0.125, 1e10 / 3;
    add({});
    add({test_cube(3, 0), matrix, test_curves(5, 0)});
  }
  if (holds.points || holds.points_first) {
    LutPoints points;
    for (std::size_t c = 0; c < 3; ++c)
      points.curves[c] = {{-1, 0.3F, 0.5F, 64}, {0, 0.1F, 0.7F, 1}};
    points.curves[1] = {{0.1F, 0.2F}, {1, 0}};
    if (holds.points) add({points});
    if (holds.points_first) {
      add({points, test_cube(3, 0)});
      add({points, test_curves(3, 0)});
    }
  }
  return luts;
}

/// The most by which two tables differ at random colours, and at the ends of [-0.25, 1.25].
inline double largest_difference(const Lut& a, const Lut& b, double low = -0.25,
                                 double high = 1.25) {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> any(low, high);
  double most = 0;
  for (int i = 0; i < 5000; ++i) {
    const Rgb in{any(generator), any(generator), any(generator)};
    const Rgb x = evaluate(a, in);
    const Rgb y = evaluate(b, in);
    for (const double d : {x.r - y.r, x.g - y.g, x.b - y.b}) most = std::max(most, std::fabs(d));
  }
  return most;
}

}  // namespace tristim
