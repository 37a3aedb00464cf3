#include "lib/palette/io/text_rows.h"

#include <algorithm>

#include "tristim/color/parse.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

}  // namespace

std::vector<TextRow> text_rows(std::string_view bytes) {
  std::vector<TextRow> rows;
  int number = 0;
  for (const std::string_view line : split(without_utf8_mark(bytes), '\n')) {
    ++number;
    const std::string_view text = trimmed(line);
    if (!text.empty()) rows.push_back({text, number});
  }
  return rows;
}

void fail_row(const std::string& file, int number, std::string_view wrong,
              std::string_view remedy) {
  throw Error(ErrorKind::kContent, file + ", row " + std::to_string(number), wrong, remedy);
}

std::string_view take_word(std::string_view& text) {
  text = trimmed(text);
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  text = trimmed(text);
  return word;
}

std::optional<std::uint8_t> code_of_word(std::string_view word) {
  const auto code = parse_integer(word);
  if (!code || *code < 0 || *code > 255) return std::nullopt;
  return static_cast<std::uint8_t>(*code);
}

EncodedRgb color_of_codes(int r, int g, int b) { return {r / 255.0, g / 255.0, b / 255.0}; }

std::optional<PaletteColor> color_of_word(std::string_view word) {
  const bool marked = word.starts_with('#');
  const std::string_view digits = marked ? word.substr(1) : word;
  const bool hex = digits.find_first_not_of("0123456789abcdefABCDEF") == std::string_view::npos;
  if (hex && (digits.size() == 6 || digits.size() == 8)) {
    PaletteColor color{parse_color("#" + std::string(digits.substr(0, 6))).value()};
    if (digits.size() == 8) {
      color.alpha = parse_color("#0000" + std::string(digits.substr(6))).value().b;
    }
    return color;
  }
  if (marked || (!word.empty() && word.find_first_of("0123456789,.") != std::string_view::npos)) {
    if (const auto color = parse_color(word)) return PaletteColor{*color};
    return std::nullopt;
  }
  const auto named = parse_color(word);
  if (!named) return std::nullopt;
  return PaletteColor{*named, std::string(word)};
}

std::string one_line_name(std::string_view name) {
  std::string text(name);
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7f; }, ' ');
  return std::string(trimmed(text));
}

bool has_alpha(const Palette& palette) noexcept {
  return std::ranges::any_of(palette.colors, [](const PaletteColor& c) { return c.alpha < 1; });
}

}  // namespace tristim::detail
