#include "lib/frame/io/paeth.h"

#include <algorithm>
#include <cstdlib>

namespace tristim::detail {
namespace {

std::uint8_t expected(int left, int above, int above_left) noexcept {
  const int to_left = std::abs(above - above_left);
  const int to_above = std::abs(left - above_left);
  const int to_above_left = std::abs(left + above - 2 * above_left);
  const int near = to_left <= to_above ? left : above;
  return static_cast<std::uint8_t>(std::min(to_left, to_above) <= to_above_left ? near
                                                                                : above_left);
}

}  // namespace

void filter_paeth_scalar(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                         std::size_t pixel_bytes, std::uint8_t* out) noexcept {
  const std::size_t first = std::min(pixel_bytes, row.size());
  for (std::size_t i = 0; i < first; ++i) out[i] = static_cast<std::uint8_t>(row[i] - above[i]);
  for (std::size_t i = first; i < row.size(); ++i) {
    const std::uint8_t from = expected(row[i - pixel_bytes], above[i], above[i - pixel_bytes]);
    out[i] = static_cast<std::uint8_t>(row[i] - from);
  }
}

}  // namespace tristim::detail
