#include "tristim/color/parse.h"

#include <array>

#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr NamedColor kCssColors[] = {
#include "luts/css_colors.csv"
};

int hex_digit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::optional<EncodedRgb> parse_hex(std::string_view digits) {
  if (digits.size() != 3 && digits.size() != 6) return std::nullopt;
  std::array<double, 3> rgb{};
  for (std::size_t c = 0; c < 3; ++c) {
    const bool short_form = digits.size() == 3;
    const int high = hex_digit(digits[short_form ? c : 2 * c]);
    const int low = hex_digit(digits[short_form ? c : 2 * c + 1]);
    if (high < 0 || low < 0) return std::nullopt;
    rgb[c] = (16 * high + low) / 255.0;
  }
  return EncodedRgb{rgb[0], rgb[1], rgb[2]};
}

std::optional<EncodedRgb> parse_triple(std::string_view text) {
  const char separator = text.find(',') != std::string_view::npos ? ',' : ' ';
  std::array<double, 3> rgb{};
  std::size_t count = 0;
  for (std::string_view part : split(text, separator)) {
    while (part.starts_with(' ')) part.remove_prefix(1);
    while (part.ends_with(' ')) part.remove_suffix(1);
    if (part.empty() && separator == ' ') continue;
    const auto value = parse_number(part);
    if (!value || !(*value >= 0 && *value <= 1) || count == 3) return std::nullopt;
    rgb[count++] = *value;
  }
  if (count != 3) return std::nullopt;
  return EncodedRgb{rgb[0], rgb[1], rgb[2]};
}

}  // namespace

std::span<const NamedColor> css_colors() noexcept { return kCssColors; }

EncodedRgb encoded_rgb(const NamedColor& color) noexcept {
  return {(color.rgb >> 16) / 255.0, (color.rgb >> 8 & 0xff) / 255.0, (color.rgb & 0xff) / 255.0};
}

std::optional<EncodedRgb> parse_color(std::string_view text) {
  if (text.starts_with('#')) return parse_hex(text.substr(1));
  if (const NamedColor* named = find_by_name(kCssColors, text)) return encoded_rgb(*named);
  return parse_triple(text);
}

std::string color_hint(std::string_view text) {
  constexpr std::string_view kForms = "give #rrggbb, a CSS name, or r,g,b in 0..1";
  const bool name = !text.empty() && text[0] >= 'A';  // a letter: no digit, no '#'
  const std::string hint = name ? name_hint(kCssColors, text) : std::string(kForms);
  return hint.starts_with("use one of") ? std::string(kForms) : hint;
}

}  // namespace tristim
