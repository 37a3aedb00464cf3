#pragma once

#include <cstdint>

#include "tristim/palette/histogram.h"

namespace tristim::detail {

/// Cells of 4 x 4 x 4 opaque colours.
inline constexpr std::uint32_t kColorCells = 1U << 18;
inline constexpr std::uint32_t kCellColors = 64;

/// Opaque colours in an order in which neighbours are together: by the upper four bits of r, g and
/// b, then by the two below, which is a cell, then by the lowest two.
constexpr std::uint32_t color_number(std::uint32_t r, std::uint32_t g, std::uint32_t b) {
  return (r & 0xF0) << 16 | (g & 0xF0) << 12 | (b & 0xF0) << 8 |  //
         (r & 0x0C) << 8 | (g & 0x0C) << 6 | (b & 0x0C) << 4 |    //
         (r & 0x03) << 4 | (g & 0x03) << 2 | (b & 0x03);
}

/// Of a number its cell; the cells of 16 x 16 x 16 colours come one after the other.
constexpr std::uint32_t cell_of(std::uint32_t number) { return number / kCellColors; }
constexpr std::uint32_t place_in_cell(std::uint32_t number) { return number % kCellColors; }
constexpr std::uint32_t coarse_cell_of(std::uint32_t number) { return number >> 12; }

constexpr std::uint32_t color_number(Color8 c) { return color_number(c.r, c.g, c.b); }
constexpr Color8 numbered_color(std::uint32_t number) {
  const auto code = [number](int high, int middle, int low) {
    return static_cast<std::uint8_t>((number >> high & 15) << 4 | (number >> middle & 3) << 2 |
                                     (number >> low & 3));
  };
  return {code(20, 10, 4), code(16, 8, 2), code(12, 6, 0)};
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
