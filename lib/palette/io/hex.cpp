#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/color/parse.h"

namespace tristim::detail {

// Words with blanks or commas between them; '#' or ';' by itself or at the end of colours begins a
// comment.
Palette read_hex(std::string_view bytes, const std::string& file) {
  Palette palette;
  for (const TextRow& row : text_rows(bytes)) {
    std::string_view rest = row.text;
    while (!rest.empty()) {
      std::string_view word = take_word(rest);
      if (word == "#" || word.starts_with(';') || word.starts_with("//")) break;
      while (word.ends_with(',')) word.remove_suffix(1);
      if (word.empty()) continue;
      auto color = color_of_word(word);
      if (!color) {
        fail_row(file, row.number, "'" + std::string(word) + "' is no colour", color_hint(word));
      }
      palette.colors.push_back(std::move(*color));
    }
  }
  return palette;
}

std::string write_hex(const Palette& palette) {
  std::string text;
  for (const PaletteColor& entry : palette.colors) {
    text += hex_text(entry.color).substr(1);
    if (entry.alpha < 1) {
      const double alpha = entry.alpha;
      text += hex_text({alpha, 0, 0}).substr(1, 2);
    }
    text += '\n';
  }
  return text;
}

}  // namespace tristim::detail
