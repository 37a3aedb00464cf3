#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace tristim::detail {

/// 1/0!, 1/1!, ... 1/16!: the coefficients of e^x, and with signs of (1 - e^-x)/x.
inline constexpr std::array<double, 17> kInverseFactorial = [] {
  std::array<double, 17> table{1};
  double factorial = 1;  // exact up to 18!
  for (std::size_t k = 1; k < table.size(); ++k) {
    factorial *= static_cast<double>(k);
    table[k] = 1 / factorial;
  }
  return table;
}();

/// e^x in plain double arithmetic, for sums of many; maximum error 2 ulp. 0 below -708 (no
/// subnormal results), +inf above 709; NaN passes.
inline double fast_exp(double x) noexcept {
  if (!(x > -708)) return std::isnan(x) ? x : 0;
  if (x > 709) return HUGE_VAL;
  constexpr double kInverseLn2 = 0x1.71547652b82fep+0;
  constexpr double kLn2High = 0x1.62e42fee00000p-1;  // 21 zero bits: n * kLn2High is exact
  constexpr double kLn2Low = 0x1.a39ef35793c76p-33;
  constexpr double kRound = 0x1.8p52;  // adding and taking it away rounds to an integer
  const double n = (x * kInverseLn2 + kRound) - kRound;
  const double r = (x - n * kLn2High) - n * kLn2Low;  // |r| <= ln(2)/2
  double sum = kInverseFactorial[13];
  for (std::size_t k = 13; k-- > 0;) sum = kInverseFactorial[k] + r * sum;
  const auto bits = static_cast<std::uint64_t>(static_cast<std::int64_t>(n) + 1023) << 52;
  return sum * std::bit_cast<double>(bits);
}

}  // namespace tristim::detail
