#include <stdexcept>
#include <string>

#include "lib/dither/cells.h"
#include "tristim/dither/cells.h"

namespace tristim {

std::int64_t cell_level_count(int n, int bits) {
  constexpr int kMostBits = 16;
  if (n < 1 || n > detail::kMostCellSize) {
    throw std::invalid_argument("side of a cell: " + std::to_string(n) + "; expected 1 to " +
                                std::to_string(detail::kMostCellSize));
  }
  if (bits < 1 || bits > kMostBits) {
    throw std::invalid_argument("bits of a device: " + std::to_string(bits) + "; expected 1 to " +
                                std::to_string(kMostBits));
  }
  return std::int64_t{n} * n * ((std::int64_t{1} << bits) - 1) + 1;
}

CellLevel cell_level(int n, int bits, std::int64_t k) {
  const std::int64_t cells = std::int64_t{n} * n;
  const auto most = static_cast<double>(cell_level_count(n, bits) - 1);
  return {k, static_cast<double>(k) / most, static_cast<int>(k / cells),
          static_cast<int>(k % cells)};
}

std::int64_t cell_color_count(int n, std::span<const int> bits) {
  std::int64_t count = 1;
  for (const int b : bits) {
    const std::int64_t levels = cell_level_count(n, b);
    if (__builtin_mul_overflow(count, levels, &count)) {
      throw std::invalid_argument("colours of a cell: more than 2^63");
    }
  }
  return count;
}

}  // namespace tristim
