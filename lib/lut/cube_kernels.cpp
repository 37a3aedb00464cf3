#include "lib/lut/cube_kernels.h"

#include <algorithm>
#include <cmath>

#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

// Where a colour lies: the lowest corner of its cell, and how far beyond it.
struct Cell {
  const float* corner;
  float fraction[3];
};

struct Place {
  float index, fraction;
};

// In this order NaN becomes 0.
template <typename T>
T held(T x, T most) noexcept {
  const T above = x > 0 ? x : 0;
  return above < most ? above : most;
}

Place place(const CubeTable& cube, std::size_t channel, float x) noexcept {
  if (cube.whole_steps) {
    const float position = held(x, 1.0F) * cube.last;
    const float index = std::min(std::floor(position), cube.last - 1);
    return {index, position - index};
  }
  const double last = cube.last;
  const double position = held((x - cube.low[channel]) * cube.per_unit[channel], last);
  const double index = std::min(std::floor(position), last - 1);
  return {static_cast<float>(index), static_cast<float>(position - index)};
}

Cell cell(const CubeTable& cube, const float* in) noexcept {
  Cell found{};
  float offset = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    const Place at = place(cube, c, in[c]);
    offset += at.index * cube.index_step[c];
    found.fraction[c] = at.fraction;
  }
  found.corner = &cube.points.data()->r + static_cast<std::size_t>(offset);
  return found;
}

void tetrahedral_row(const CubeTable& cube, const float* in, float* out, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i, in += 3, out += 3) {
    const Cell at = cell(cube, in);
    const auto [r, g, b] = at.fraction;
    const float most = std::max(std::max(r, g), b);
    const float least = std::min(std::min(r, g), b);
    const float middle = std::max(std::min(r, g), std::min(std::max(r, g), b));
    // Of equal fractions any may be the first: the corner between them has no weight.
    const std::size_t first = r == most ? cube.step[0] : g == most ? cube.step[1] : cube.step[2];
    const std::size_t last = r == least ? cube.step[0] : g == least ? cube.step[1] : cube.step[2];
    const float* p0 = at.corner;
    const float* p1 = p0 + first;
    const float* p2 = p0 + (cube.all - last);
    const float* p3 = p0 + cube.all;
    for (int c = 0; c < 3; ++c) {
      out[c] = ((1 - most) * p0[c] + (most - middle) * p1[c]) +
               ((middle - least) * p2[c] + least * p3[c]);
    }
  }
}

void trilinear_row(const CubeTable& cube, const float* in, float* out, std::size_t count) {
  const auto [red, green, blue] = cube.step;
  for (std::size_t i = 0; i < count; ++i, in += 3, out += 3) {
    const Cell at = cell(cube, in);
    const auto [r, g, b] = at.fraction;
    for (int c = 0; c < 3; ++c) {
      const float* p = at.corner + c;
      const auto along_red = [t = r, step = red](const float* q) {
        return (1 - t) * q[0] + t * q[step];
      };
      const float low = (1 - g) * along_red(p) + g * along_red(p + green);
      const float high = (1 - g) * along_red(p + blue) + g * along_red(p + blue + green);
      out[c] = (1 - b) * low + b * high;
    }
  }
}

bool is_power_of_two(int n) noexcept { return (n & (n - 1)) == 0; }

}  // namespace

CubeTable::CubeTable(const Lut3D& cube)
    : points(cube.rgb.size() / 3),
      last(static_cast<float>(cube.size - 1)),
      whole_steps(cube.range == LutRange{} && is_power_of_two(cube.size - 1)),
      low(cube.range.low) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const float* rgb = &cube.rgb[3 * i];
    points[i] = {rgb[0], rgb[1], rgb[2], 0};
  }
  const auto n = static_cast<std::size_t>(cube.size);
  step = {4, 4 * n, 4 * n * n};
  all = step[0] + step[1] + step[2];
  for (std::size_t c = 0; c < 3; ++c) {
    index_step[c] = static_cast<float>(step[c]);
    per_unit[c] = (cube.size - 1) / (cube.range.high[c] - cube.range.low[c]);
  }
}

const CubeKernels& scalar_cube_kernels() noexcept {
  static const CubeKernels kernels{"scalar", tetrahedral_row, trilinear_row};
  return kernels;
}

const CubeKernels& cube_kernels() {
  const CubeKernels* simd = chosen_instruction_set(simd_cube_kernels());
  return simd == nullptr ? scalar_cube_kernels() : *simd;
}

}  // namespace tristim::detail
