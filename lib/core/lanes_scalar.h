#pragma once

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tristim::detail {

/// One sample at a time, for kernels that are written once for any number of them; lanes-inl.h has
/// the vectors, with the same results.
struct ScalarLanes {
  using F = float;
  using D = double;  // as many as there are floats in an F

  static constexpr std::size_t size() noexcept { return 1; }
  static F load(const float* from) noexcept { return *from; }
  static void store(F x, float* to) noexcept { *to = x; }
  static F f(float x) noexcept { return x; }
  static D d(double x) noexcept { return x; }
  static D load_wide(const float* from) noexcept { return *from; }
  static D load_double(const double* from) noexcept { return *from; }
  static F narrow(D x) noexcept { return static_cast<float>(x); }
  static D widen(F x) noexcept { return x; }

  // As SSE's instructions: the second where one of them is NaN.
  template <typename T>
  static T min(T a, T b) noexcept {
    return a < b ? a : b;
  }
  template <typename T>
  static T max(T a, T b) noexcept {
    return a > b ? a : b;
  }
  template <typename T>
  static T root(T x) noexcept {
    return std::sqrt(x);
  }
  /// `yes` where x > 0, else `no`.
  template <typename T>
  static T where_positive(T x, T yes, T no) noexcept {
    return x > 0 ? yes : no;
  }

  /// a 2^-e with e, a whole number that brings it near to b: their ratio is within 2^+-.59. Both
  /// are positive and no subnormals; 0 counts as the power of 2 below the least of them.
  static D scale_near(D a, D b, D& e) noexcept {
    constexpr std::uint64_t kHalf = std::uint64_t{1} << 51;
    constexpr std::uint64_t kExponents = ~((std::uint64_t{1} << 52) - 1);
    const auto bits = std::bit_cast<std::uint64_t>(a);
    const std::uint64_t shift = (bits - std::bit_cast<std::uint64_t>(b) + kHalf) & kExponents;
    // shift is e 2^52, also where negative: e + 1024 as an integer below 2^52, then as a double.
    constexpr std::uint64_t kBias = std::uint64_t{1024} << 52;
    const std::uint64_t biased = ((shift + kBias) >> 52) | std::bit_cast<std::uint64_t>(0x1p52);
    e = std::bit_cast<double>(biased) - (0x1p52 + 1024);
    return std::bit_cast<double>(bits - shift);
  }

  static F scale_near(F a, F b, F& e) noexcept {
    constexpr std::uint32_t kHalf = std::uint32_t{1} << 22;
    constexpr std::uint32_t kExponents = ~((std::uint32_t{1} << 23) - 1);
    const auto bits = std::bit_cast<std::uint32_t>(a);
    const std::uint32_t shift = (bits - std::bit_cast<std::uint32_t>(b) + kHalf) & kExponents;
    e = static_cast<float>(std::bit_cast<std::int32_t>(shift) >> 23);
    return std::bit_cast<float>(bits - shift);
  }

  /// The whole number nearest to |x| < 2^22 or to |x| < 2^51: a sum without digits behind the
  /// point.
  static F whole(F x) noexcept { return (x + 0x1.8p23F) - 0x1.8p23F; }
  static D whole(D x) noexcept { return (x + 0x1.8p52) - 0x1.8p52; }

  /// 2^n of a whole number in [-127, 128]; 0 for -127, infinite for 128.
  static F power_of_two(F n) noexcept {
    return std::bit_cast<float>((static_cast<std::int32_t>(n) + 127) << 23);
  }
};

}  // namespace tristim::detail
