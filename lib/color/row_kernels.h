#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

namespace tristim::detail {

/// Pixels of a row on their way through a conversion, in planes. Kernels compute in double, so that
/// a way of many steps is rounded to float once.
struct RowBlock {
  static constexpr std::size_t kSize = 128;  // a multiple of every vector's lanes; stays in L1
  alignas(64) double plane[4][kSize];
  alignas(64) double alpha[kSize];
  alignas(64) double undefined[kSize];  // what stands for NaN: 0 where the colour came in finite
};

/// The numbers of a kernel: matrices row by row.
using RowParameters = std::array<double, 27>;

/// A formula in one instruction set.
struct RowKernel {
  /// Converts the first three planes of a block in place; `count` pixels and up to a whole vector
  /// beyond, where anything may stand.
  void (*block)(RowBlock& block, std::size_t count, const RowParameters& p) = nullptr;

  /// Converts pixels of three channels without a block between, for conversions of one step, some
  /// in floats (row_floats-inl.h); nullptr where that is no gain. `in` and `out` may be the same.
  void (*pixels)(const float* in, float* out, std::size_t count, const RowParameters& p,
                 bool keep_undefined) = nullptr;

  friend constexpr bool operator==(const RowKernel&, const RowKernel&) = default;
};

/// How float pixels lie in memory: `components` numbers of the colour, then alpha where there are
/// more channels, then what is not looked at. Alpha is 1 where there is none.
struct RowChannels {
  std::size_t components = 3;
  std::size_t channels = 3;
};

/// Every kernel in one instruction set. All sets give the same bits: they are one text (see
/// row_formulas-inl.h) with the same operations in the same order.
struct RowKernels {
  std::string_view name;

  void (*load)(const float* in, RowChannels channels, std::size_t count, RowBlock& block);
  void (*store)(const RowBlock& block, RowChannels channels, std::size_t count, float* out);

  RowKernel matrix;       // m[9]
  RowKernel grey_matrix;  // rows (w, a, b): w G + (a (R - G) + b (B - G)), exact on greys
  RowKernel complement;   // 1 - x
  RowKernel hsv_from_rgb, rgb_from_hsv;
  RowKernel hls_from_rgb, rgb_from_hls;
  RowKernel swap_last;  // the second and third plane
  RowKernel hue;        // in the plane p[0], 0 or 2: what would round to 360 becomes 0

  // Lab and Luv of X/Xw, Y/Yw, Z/Zw. Luv: Xw, Zw with Yw = 1.
  RowKernel lab_from_ratios, ratios_from_lab;
  RowKernel luv_from_ratios, ratios_from_luv;

  // A matrix or a grey matrix with what follows it: its nine numbers, then those of the second.
  RowKernel lab_of_matrix, lab_of_grey_matrix, luv_of_matrix, luv_of_grey_matrix;
  RowKernel matrix_of_lab, grey_matrix_of_lab, matrix_of_luv, grey_matrix_of_luv;  // and back

  // A matrix, cube roots or cubes, a matrix, and the second's numbers rounded to 1/4096.
  RowKernel oklab, linear_of_oklab;

  // Curves; see PowerCurve for the numbers of the first two.
  RowKernel power_encode, power_decode;
  RowKernel bt1886_encode, bt1886_decode;  // roots of white - black, of black
  RowKernel pq_encode, pq_decode;
  RowKernel hlg_encode, hlg_decode;  // a, b, c
  RowKernel acescc_encode, acescc_decode;
  RowKernel acescct_encode, acescct_decode;
};

/// The numbers of power_encode and power_decode: E = slope L below the joint, else alpha L^exponent
/// - beta. `straight`: 1 where the line goes on below 0, 0 where the curve is odd.
struct PowerCurve {
  double slope = 1, joint_linear = 0, joint_encoded = 0, alpha = 1, beta = 0, exponent = 1,
         inverse_exponent = 1, straight = 0;

  constexpr RowParameters parameters() const noexcept {
    return {slope, joint_linear, joint_encoded, alpha, beta, exponent, inverse_exponent, straight};
  }
};

/// The definition, and last in the list.
const RowKernels& scalar_row_kernels() noexcept;

/// By Highway, for every instruction set that this processor has, best first.
std::span<const RowKernels> simd_row_kernels();

/// What conversions use: those that the environment's TRISTIM_SIMD names ("scalar", "sse4", "avx2",
/// "avx512"), else the best.
const RowKernels& row_kernels();

}  // namespace tristim::detail
