#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "tristim/color/rgb.h"

namespace tristim {

/// A colour by its CSS name [CSS4 6.1].
struct NamedColor {
  std::string_view name;
  int rgb;  // 0xrrggbb
};

/// Every CSS colour name, in the order of the alphabet.
std::span<const NamedColor> css_colors() noexcept;

EncodedRgb encoded_rgb(const NamedColor& color) noexcept;

/// A colour from text: "#rgb", "#rrggbb", a CSS name, or three numbers of encoded sRGB in [0, 1]
/// separated by commas or spaces. Nothing where it is none.
std::optional<EncodedRgb> parse_color(std::string_view text);

/// What to do about a text that is no colour: the nearest name, or the forms.
std::string color_hint(std::string_view text);

}  // namespace tristim
