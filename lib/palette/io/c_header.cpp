#include <algorithm>
#include <array>
#include <charconv>

#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

std::string identifier_of(const std::string& name) {
  std::string identifier;
  for (const char c : name) {
    const bool word = is_letter_or_digit(c);
    if (word) identifier += c;
    if (!word && !identifier.empty() && identifier.back() != '_') identifier += '_';
  }
  if (identifier.ends_with('_')) identifier.pop_back();
  if (identifier.empty()) return "colors";
  return identifier[0] <= '9' ? "colors_" + identifier : identifier;
}

std::string comment_text(const std::string& name) {
  std::string text = one_line_name(name);
  std::ranges::replace_if(
      text, [](char c) { return c == '\\' || c == '?'; }, ' ');
  return text;
}

// The integers of a list, in decimal or as 0xff; nothing where something else is there.
std::optional<std::vector<int>> integers_of(std::string_view text) {
  std::vector<int> numbers;
  for (std::string_view part : split(text, ',')) {
    std::string_view word = take_word(part);
    if (word.empty()) continue;
    const bool hex = word.starts_with("0x") || word.starts_with("0X");
    if (hex) word.remove_prefix(2);
    int value = -1;
    const auto [end, error] =
        std::from_chars(word.data(), word.data() + word.size(), value, hex ? 16 : 10);
    const bool whole = error == std::errc() && end == word.data() + word.size() && part.empty();
    if (!whole || value < 0 || value > 65535) return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

// `name` behind "// ".
std::string comment_of(std::string_view line) {
  const std::size_t at = line.find("// ");
  return at == std::string_view::npos ? "" : one_line_name(line.substr(at + 3));
}

// {r, g, b} or {r, g, b, alpha}; nothing where the row is something else.
std::optional<PaletteColor> color_of_row(const TextRow& row, const std::string& file) {
  if (!row.text.starts_with('{')) return std::nullopt;
  const std::size_t end = row.text.find('}');
  const auto numbers =
      end == std::string_view::npos ? std::nullopt : integers_of(row.text.substr(1, end - 1));
  const bool good = numbers && (numbers->size() == 3 || numbers->size() == 4) &&
                    *std::ranges::max_element(*numbers) <= 255;
  if (!good) fail_row(file, row.number, "is no colour", "write {red, green, blue}, each 0 to 255");
  const double alpha = numbers->size() == 4 ? (*numbers)[3] / 255.0 : 1;
  return PaletteColor{color_of_codes((*numbers)[0], (*numbers)[1], (*numbers)[2]),
                      comment_of(row.text), alpha};
}

}  // namespace

// Rows that begin with '{' are colours, a row a colour; behind "_codes" come their codes. Headers
// of pictures have both.
Palette read_c_header(std::string_view bytes, const std::string& file) {
  Palette palette;
  std::vector<int> codes;
  bool in_codes = false;
  for (const TextRow& row : text_rows(bytes)) {
    if (in_codes && row.text.starts_with('}')) break;
    if (in_codes) {
      const auto numbers = integers_of(row.text);
      if (!numbers) fail_row(file, row.number, "holds something else than codes");
      codes.insert(codes.end(), numbers->begin(), numbers->end());
    } else if (row.text.find("_codes") != std::string_view::npos && row.text.ends_with('{')) {
      in_codes = true;
    } else if (auto color = color_of_row(row, file)) {
      palette.colors.push_back(std::move(*color));
    }
  }
  if (in_codes && codes.size() != palette.colors.size()) {
    throw Error(ErrorKind::kContent, file,
                "has " + std::to_string(palette.colors.size()) + " colours, but " +
                    std::to_string(codes.size()) + " codes");
  }
  for (std::size_t i = 0; i < codes.size(); ++i) {
    palette.colors[i].code = static_cast<std::uint16_t>(codes[i]);
  }
  return palette;
}

std::string write_c_header(const Palette& palette) {
  const std::string name = identifier_of(palette.name);
  const std::string count = "[" + std::to_string(palette.colors.size()) + "]";
  const bool alpha = has_alpha(palette);
  const bool codes =
      std::ranges::all_of(palette.colors, [](const auto& c) { return c.code.has_value(); });
  std::string text = "#pragma once\n\n#include <stdint.h>\n\n// sRGB red, green, blue";
  text += std::string(alpha ? ", alpha" : "") + ".\nstatic const uint8_t " + name + "_palette" +
          count + (alpha ? "[4]" : "[3]") + " = {\n";
  for (const PaletteColor& entry : palette.colors) {
    const auto [r, g, b] = color_codes8(entry.color);
    text += "  {" + std::to_string(r) + ", " + std::to_string(g) + ", " + std::to_string(b);
    if (alpha) text += ", " + std::to_string(unit_code(entry.alpha, 255));
    text += "},";
    if (!entry.name.empty()) text += "  // " + comment_text(entry.name);
    text += "\n";
  }
  text += "};\n";
  if (!codes) return text;
  text += "\n// What the frame buffer holds for each.\nstatic const uint16_t " + name +
          "_palette_codes" + count + " = {\n";
  for (const PaletteColor& entry : palette.colors) {
    text += "  " + std::to_string(*entry.code) + ",\n";
  }
  return text + "};\n";
}

}  // namespace tristim::detail
