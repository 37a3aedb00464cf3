#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

#include "lib/core/math.h"

namespace tristim::detail {

/// 10 log10 of a ratio of powers, 0 or above; -inf of 0.
inline double decibels(double ratio) noexcept {
  constexpr double kLn10 = 2.302585092994045684;
  if (ratio == 0) return -std::numeric_limits<double>::infinity();
  return 10 / kLn10 * log(ratio);
}

/// The value that `share` of the values (not empty) are at or below, linear between two ranks;
/// reorders them.
template <typename T>
double percentile(std::vector<T>& values, double share) {
  const double rank = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), at, values.end());
  if (at + 1 == values.end()) return static_cast<double>(*at);
  const double low = static_cast<double>(*at);
  const double high = static_cast<double>(*std::min_element(at + 1, values.end()));
  return low + (high - low) * (rank - static_cast<double>(below));
}

}  // namespace tristim::detail
