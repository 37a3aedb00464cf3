#pragma once

#include <cstdint>

#include "tristim/palette/histogram.h"

namespace tristim::detail {

/// Cells of 4 x 4 x 4 opaque colours.
inline constexpr std::uint32_t kColorCells = 1U << 18;

constexpr std::uint32_t cell_of(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return r >> 2 << 12 | g >> 2 << 6 | b >> 2;
}
constexpr std::uint32_t place_in_cell(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return (r & 3) << 4 | (g & 3) << 2 | (b & 3);
}

/// A colour as one number, r first: keys ascend as colours do.
constexpr std::uint32_t key_of(Color8 c) {
  return std::uint32_t{c.r} << 24 | std::uint32_t{c.g} << 16 | std::uint32_t{c.b} << 8 | c.a;
}
constexpr Color8 color_of(std::uint32_t key) {
  return {static_cast<std::uint8_t>(key >> 24), static_cast<std::uint8_t>(key >> 16 & 255),
          static_cast<std::uint8_t>(key >> 8 & 255), static_cast<std::uint8_t>(key & 255)};
}

}  // namespace tristim::detail
