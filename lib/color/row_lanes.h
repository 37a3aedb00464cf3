#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>

#include "lib/color/row_kernels.h"

namespace tristim::detail {

// The operations that the row formulas are written in, on one lane. row_kernels_simd.cpp has the
// same for vectors. Every one is exact or rounded once as IEEE says, so the two give the same bits.

template <std::floating_point T>
inline T select(bool mask, T yes, T no) noexcept {
  return mask ? yes : no;
}
template <std::floating_point T>
inline bool is_nan(T x) noexcept {
  return std::isnan(x);
}
inline bool any(bool mask) noexcept { return mask; }
template <std::floating_point T>
inline T magnitude(T x) noexcept {
  return std::fabs(x);
}
template <std::floating_point T>
inline T with_sign_of(T magnitude, T x) noexcept {
  return std::copysign(magnitude, x);
}
inline double root(double x) noexcept { return std::sqrt(x); }
inline double whole_part(double x) noexcept { return std::trunc(x); }

// Where one is NaN: the second.
template <std::floating_point T>
inline T larger(T a, T b) noexcept {
  return a > b ? a : b;
}
template <std::floating_point T>
inline T smaller(T a, T b) noexcept {
  return a < b ? a : b;
}

inline constexpr double kRoundToWhole = 0x1.8p52;  // added and taken off again

inline constexpr std::uint64_t kOneBits = 0x3ff0000000000000;
inline constexpr std::uint64_t kHalfRootBits = 0x3fe6a09e667f3bcd;  // sqrt(1/2)
inline constexpr std::uint64_t kMantissaMask = 0x000fffffffffffff;
inline constexpr std::uint64_t kWholeBits = 0x4330000000000000;  // 2^52: whole numbers in its bits

/// x = mantissa 2^exponent of a normal x > 0, the mantissa in [sqrt(1/2), sqrt(2)).
template <typename W>
struct MantissaExponent {
  W mantissa, exponent;
};

inline MantissaExponent<double> split(double x) noexcept {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x) + (kOneBits - kHalfRootBits);
  return {std::bit_cast<double>((bits & kMantissaMask) + kHalfRootBits),
          std::bit_cast<double>((bits >> 52) | kWholeBits) - (0x1p52 + 1023)};
}

/// 2^n of a whole n in [-1022, 1023].
inline double power_of_2(double n) noexcept {
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>(n + (kRoundToWhole + 1023)) << 52);
}

/// x^(-1/3) of a normal x > 0 within 4 %: a third of the bits' logarithm.
inline constexpr double kInverseCubeRootBits = 0x553ef0ff289p0;
inline double inverse_cube_root_guess(double x) noexcept {
  const std::uint64_t bits = (std::bit_cast<std::uint64_t>(x) >> 20) | kWholeBits;
  const double third = (std::bit_cast<double>(bits) - 0x1p52) * (1.0 / 3);
  return std::bit_cast<double>(std::bit_cast<std::uint64_t>((kInverseCubeRootBits - third) + 0x1p52)
                               << 20);
}

/// The same of a normal float x > 0, and any number for 0, within 3.6 %.
inline constexpr std::uint32_t kWholeFloatBits = 0x4b000000;  // 2^23
inline constexpr double kFloatCubeRootBits = 16731311;        // 2^23 (1 + 1/3) and what is for 1.0
inline float inverse_cube_root_guess(float x) noexcept {
  const float whole =
      std::bit_cast<float>((std::bit_cast<std::uint32_t>(x) >> 8) | kWholeFloatBits);
  const float guess = float(kFloatCubeRootBits) - whole * float(1.0 / 3);
  return std::bit_cast<float>(std::bit_cast<std::uint32_t>(guess) << 8);
}

/// A float rounded to 8 binary digits, whose cube is a float.
inline constexpr std::uint32_t kHalfOf8Digits = 0x8000;
inline constexpr std::uint32_t k8DigitsMask = 0xffff0000;
inline float to_8_digits(float x) noexcept {
  return std::bit_cast<float>((std::bit_cast<std::uint32_t>(x) + kHalfOf8Digits) & k8DigitsMask);
}

/// f(x) where the mask holds, for the few numbers where a formula is too coarse.
inline double where(bool mask, double x, double otherwise, double (*f)(double) noexcept) noexcept {
  return mask ? f(x) : otherwise;
}

/// Pixels [begin, end) of a row into a block, and out of it.
inline void load_pixels_of(const float* in, RowChannels channels, std::size_t begin,
                           std::size_t end, RowBlock& block) noexcept {
  for (std::size_t i = begin; i < end; ++i) {
    const float* pixel = in + i * channels.channels;
    double sum = 0;
    for (std::size_t c = 0; c < channels.components; ++c) {
      block.plane[c][i] = pixel[c];
      sum += block.plane[c][i];
    }
    block.alpha[i] = channels.channels > channels.components ? pixel[channels.components] : 1;
    block.undefined[i] = sum - sum;  // NaN where one is NaN or infinite
  }
}

inline void store_pixels_of(const RowBlock& block, RowChannels channels, std::size_t begin,
                            std::size_t end, float* out) noexcept {
  for (std::size_t i = begin; i < end; ++i) {
    float* pixel = out + i * channels.channels;
    for (std::size_t c = 0; c < channels.components; ++c) {
      const double x = block.plane[c][i];
      pixel[c] = static_cast<float>(std::isnan(x) ? block.undefined[i] : x);
    }
    if (channels.channels > channels.components) {
      pixel[channels.components] = static_cast<float>(block.alpha[i]);
    }
  }
}

}  // namespace tristim::detail
