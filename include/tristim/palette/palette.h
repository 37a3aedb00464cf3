#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tristim/color/rgb.h"

namespace tristim {

/// An entry of a palette.
struct PaletteColor {
  EncodedRgb color;                     // sRGB; [0, 1] inside of its gamut
  std::string name = {};                // UTF-8; may be empty
  double alpha = 1;                     // coverage, [0, 1]
  std::optional<std::uint16_t> code{};  // what a device's frame buffer holds for it
  friend bool operator==(const PaletteColor&, const PaletteColor&) = default;
};

/// Colours in an order: a colour's position is what pixels hold.
struct Palette {
  std::string name;  // UTF-8; may be empty
  std::vector<PaletteColor> colors;
  friend bool operator==(const Palette&, const Palette&) = default;
};

/// A value of [0, 1] as a code from 0 to `most`, rounded half up; values outside count as the
/// nearer end, NaN as 0.
std::uint16_t unit_code(double value, int most) noexcept;

/// A colour as codes of 8 bits a channel.
std::array<std::uint8_t, 3> color_codes8(const EncodedRgb& color) noexcept;

/// Whether a colour's channels are codes of 8 bits, each exactly c/255.
bool is_8_bits(const EncodedRgb& color) noexcept;

/// "#rrggbb", the colour rounded to 8 bits.
std::string hex_text(const EncodedRgb& color);

}  // namespace tristim
