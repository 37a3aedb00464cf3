#include "tristim/palette/palette.h"

#include <cmath>

namespace tristim {

std::uint16_t unit_code(double value, int most) noexcept {
  if (!(value > 0)) return 0;
  if (value >= 1) return static_cast<std::uint16_t>(most);
  return static_cast<std::uint16_t>(std::floor(value * most + 0.5));
}

std::array<std::uint8_t, 3> color_codes8(const EncodedRgb& color) noexcept {
  const auto code = [](double v) { return static_cast<std::uint8_t>(unit_code(v, 255)); };
  return {code(color.r), code(color.g), code(color.b)};
}

bool is_8_bits(const EncodedRgb& color) noexcept {
  const auto [r, g, b] = color_codes8(color);
  return color == EncodedRgb{r / 255.0, g / 255.0, b / 255.0};
}

std::string hex_text(const EncodedRgb& color) {
  constexpr char kDigits[] = "0123456789abcdef";
  std::string text = "#";
  for (const std::uint8_t code : color_codes8(color)) {
    text += kDigits[code >> 4];
    text += kDigits[code & 15];
  }
  return text;
}

}  // namespace tristim
