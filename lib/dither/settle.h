#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace tristim::detail {

/// How far rows go above a picture until errors are what they would be in the midst of a field of
/// which the share `tone` is lit, or the share 1 - tone: dots there are 1/sqrt(tone) apart.
int settling_rows(float tone) noexcept;

/// Jitter of the threshold in a row above the picture, -rows <= y < 0: at first much, so that the
/// dots of neighbouring columns do not stand in line, then ever less.
float settling_jitter(int y, int rows) noexcept;

/// Marks the pixels of runs of at least 32 for which `same(x)` holds from the second on: that x is
/// like x - 1.
template <typename Same>
std::vector<std::uint8_t> flat_pixels(int width, Same&& same) {
  constexpr int kLeast = 32;
  std::vector<std::uint8_t> flat(static_cast<std::size_t>(width), 0);
  int start = 0;
  for (int x = 1; x <= width; ++x) {
    if (x < width && same(x)) continue;
    if (x - start >= kLeast) std::fill(flat.begin() + start, flat.begin() + x, std::uint8_t{1});
    start = x;
  }
  return flat;
}

}  // namespace tristim::detail
