#include "lib/image/io/half_row.h"

#include <bit>
#include <cstddef>

#if defined(__x86_64__)
#include <immintrin.h>
#define TRISTIM_HAS_F16C \
  1  // intrinsics, as Highway's conversion is not exact at infinities on SSE4
#endif

namespace tristim::detail {
namespace {

void float_from_half_scalar(std::span<const std::uint16_t> halves,
                            std::span<float> values) noexcept {
  for (std::size_t i = 0; i < halves.size(); ++i) values[i] = float_from_half(halves[i]);
}

void half_from_float_scalar(std::span<const float> values,
                            std::span<std::uint16_t> halves) noexcept {
  for (std::size_t i = 0; i < values.size(); ++i) halves[i] = half_from_float(values[i]);
}

#ifdef TRISTIM_HAS_F16C

// Every processor with AVX2 has F16C; clang 14 cannot ask for the latter.
bool has_f16c() noexcept {
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
}

__attribute__((target("avx,f16c"))) void float_from_half_f16c(std::span<const std::uint16_t> halves,
                                                              std::span<float> values) noexcept {
  std::size_t i = 0;
  for (; i + 8 <= halves.size(); i += 8) {
    const __m128i eight = _mm_loadu_si128(reinterpret_cast<const __m128i*>(halves.data() + i));
    _mm256_storeu_ps(values.data() + i, _mm256_cvtph_ps(eight));
  }
  float_from_half_scalar(halves.subspan(i), values.subspan(i));
}

__attribute__((target("avx,f16c"))) void half_from_float_f16c(
    std::span<const float> values, std::span<std::uint16_t> halves) noexcept {
  std::size_t i = 0;
  for (; i + 8 <= values.size(); i += 8) {
    const __m256 eight = _mm256_loadu_ps(values.data() + i);
    _mm_storeu_si128(reinterpret_cast<__m128i*>(halves.data() + i),
                     _mm256_cvtps_ph(eight, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC));
  }
  half_from_float_scalar(values.subspan(i), halves.subspan(i));
}

#endif

}  // namespace

float float_from_half(std::uint16_t half) noexcept {
  const std::uint32_t sign = std::uint32_t{half & 0x8000u} << 16;
  const std::uint32_t magnitude = half & 0x7fffu;
  if (magnitude > 0x7c00)
    return std::bit_cast<float>(sign | 0x7fc00000u | (magnitude & 0x3ffu) << 13);
  if (magnitude == 0x7c00) return std::bit_cast<float>(sign | 0x7f800000u);
  if (magnitude >= 0x400) return std::bit_cast<float>(sign | ((magnitude << 13) + (112u << 23)));
  const float subnormal = static_cast<float>(magnitude) * 0x1p-24f;
  return sign != 0 ? -subnormal : subnormal;
}

std::uint16_t half_from_float(float value) noexcept {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const auto sign = static_cast<std::uint16_t>(bits >> 16 & 0x8000u);
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  std::uint32_t half = 0;
  if (magnitude > 0x7f800000u) {
    half = 0x7e00u | (magnitude >> 13 & 0x3ffu);
  } else if (magnitude >= 0x477ff000u) {  // 65520, half way to what would be the next half
    half = 0x7c00u;
  } else if (magnitude >= 0x38800000u) {  // 2^-14, the smallest normal half
    half = (magnitude - (112u << 23) + 0xfffu + (magnitude >> 13 & 1u)) >> 13;
  } else {
    // adding 0.5 leaves the subnormal half in the low bits, rounded by the addition itself
    half = std::bit_cast<std::uint32_t>(std::bit_cast<float>(magnitude) + 0.5f) - 0x3f000000u;
  }
  return static_cast<std::uint16_t>(sign | half);
}

void float_from_half(std::span<const std::uint16_t> halves, std::span<float> values) noexcept {
#ifdef TRISTIM_HAS_F16C
  if (has_f16c()) return float_from_half_f16c(halves, values);
#endif
  float_from_half_scalar(halves, values);
}

void half_from_float(std::span<const float> values, std::span<std::uint16_t> halves) noexcept {
#ifdef TRISTIM_HAS_F16C
  if (has_f16c()) return half_from_float_f16c(values, halves);
#endif
  half_from_float_scalar(values, halves);
}

}  // namespace tristim::detail
