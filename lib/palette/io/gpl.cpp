#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"

namespace tristim::detail {
namespace {

// A row of red, green, blue, alpha where the file has it, and the name.
PaletteColor color_of_row(std::string_view text, bool alpha, const std::string& file, int number) {
  std::array<int, 4> codes{0, 0, 0, 255};
  for (std::size_t i = 0; i < (alpha ? 4u : 3u); ++i) {
    const std::string_view word = take_word(text);
    const auto code = code_of_word(word);
    if (!code) {
      fail_row(file, number, "'" + std::string(word) + "' is no code from 0 to 255",
               alpha ? "write red green blue alpha name" : "write red green blue name");
    }
    codes[i] = *code;
  }
  const std::string name = text == "Untitled" ? "" : one_line_name(text);
  return {color_of_codes(codes[0], codes[1], codes[2]), name, codes[3] / 255.0};
}

}  // namespace

// The palette of GIMP [GPL]; Aseprite's line "Channels: RGBA" adds alpha.
Palette read_gpl(std::string_view bytes, const std::string& file) {
  Palette palette;
  bool alpha = false;
  bool first = true;
  for (const TextRow& row : text_rows(bytes)) {
    if (first) {
      if (!row.text.starts_with("GIMP Palette")) {
        fail_row(file, row.number, "does not begin with 'GIMP Palette'");
      }
      first = false;
    } else if (row.text.starts_with("Name:")) {
      palette.name = one_line_name(row.text.substr(5));
    } else if (row.text.starts_with("Channels:")) {
      alpha = row.text.find("RGBA") != std::string_view::npos;
    } else if (!row.text.starts_with("Columns:") && !row.text.starts_with('#')) {
      palette.colors.push_back(color_of_row(row.text, alpha, file, row.number));
    }
  }
  return palette;
}

std::string write_gpl(const Palette& palette) {
  const bool alpha = has_alpha(palette);
  std::string text = "GIMP Palette\n";
  if (alpha) text += "Channels: RGBA\n";
  if (!palette.name.empty()) text += "Name: " + one_line_name(palette.name) + "\n";
  text += "#\n";
  for (const PaletteColor& entry : palette.colors) {
    for (const std::uint8_t code : color_codes8(entry.color)) {
      std::string digits = std::to_string(code);
      text += digits.insert(0, 3 - digits.size(), ' ') + " ";
    }
    if (alpha) text += std::to_string(unit_code(entry.alpha, 255)) + " ";
    text += entry.name.empty() ? "Untitled\n" : one_line_name(entry.name) + "\n";
  }
  return text;
}

}  // namespace tristim::detail
