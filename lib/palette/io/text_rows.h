#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/palette/palette.h"

namespace tristim::detail {

/// A line of a text file, without its end and blanks around it.
struct TextRow {
  std::string_view text;
  int number = 0;  // from 1
};

/// The lines of a text, those without anything but blanks left out.
std::vector<TextRow> text_rows(std::string_view bytes);

/// Throws Error (kContent) "<file>, row <number>: <wrong>; <remedy>".
[[noreturn]] void fail_row(const std::string& file, int number, std::string_view wrong,
                           std::string_view remedy = {});

/// Takes the next word off `text`, with the blanks around it; "" at the end.
std::string_view take_word(std::string_view& text);

/// The code of a channel that all of `word` is, 0 to 255. Nothing for other texts.
std::optional<std::uint8_t> code_of_word(std::string_view word);

/// A colour of codes from 0 to 255.
EncodedRgb color_of_codes(int r, int g, int b);

/// A colour from a word: rrggbb or rrggbbaa with or without '#', #rgb, or a CSS name, which the
/// entry keeps. Nothing for other texts.
std::optional<PaletteColor> color_of_word(std::string_view word);

/// Names of one line: control characters become blanks.
std::string one_line_name(std::string_view name);

/// Whether an entry of the palette is not opaque.
bool has_alpha(const Palette& palette) noexcept;

}  // namespace tristim::detail
