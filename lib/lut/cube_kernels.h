#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "tristim/lut/lut.h"

namespace tristim::detail {

/// A cube as rows read it.
struct CubeTable {
  explicit CubeTable(const Lut3D& cube);  // of a cube that check() takes

  struct alignas(16) Point {
    float r, g, b, unused;
  };
  std::vector<Point> points;  // red fastest
  float last;                 // number of an edge's last point
  bool whole_steps;           // over [0, 1] in a power of two: the product x last is exact in float
  std::array<double, 3> low, per_unit;  // else: position (x - low) per_unit, in double

  std::array<std::size_t, 3> step;  // floats to the next point of each axis
  std::size_t all;                  // to the one next on all
  std::array<float, 3> index_step;  // `step` as floats: multiples and their sums are exact
};

/// Rows of three interleaved channels through a cube; `in` and `out` do not overlap.
using CubeRow = void (*)(const CubeTable& cube, const float* in, float* out, std::size_t count);

/// The rows in one instruction set; all of them give the same bits.
struct CubeKernels {
  std::string_view name;
  CubeRow tetrahedral, trilinear;
};

/// The definition.
const CubeKernels& scalar_cube_kernels() noexcept;

/// By Highway, for every instruction set that this processor has, best first.
std::span<const CubeKernels> simd_cube_kernels();

/// Those that the environment's TRISTIM_SIMD names, else the best.
const CubeKernels& cube_kernels();

}  // namespace tristim::detail
