#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/palette/io/file.h"

namespace tristim::detail {
namespace {

// "0100", then how many colours there are.
std::size_t count_of_head(const std::vector<TextRow>& rows, const std::string& file) {
  if (rows.empty() || rows[0].text != "JASC-PAL") {
    fail_row(file, rows.empty() ? 1 : rows[0].number, "does not begin with 'JASC-PAL'");
  }
  if (rows.size() < 3) throw Error(ErrorKind::kContent, file, "is cut off in its head");
  if (rows[1].text != "0100") {
    fail_row(file, rows[1].number, "version '" + std::string(rows[1].text) + "' is not known",
             "version 0100 is");
  }
  const auto count = parse_integer(rows[2].text);
  if (!count || *count < 0 || *count > kMostPaletteColors) {
    fail_row(file, rows[2].number,
             "'" + std::string(rows[2].text) + "' is no number of colours up to " +
                 std::to_string(kMostPaletteColors));
  }
  return static_cast<std::size_t>(*count);
}

}  // namespace

// The palette of PaintShop Pro [JASC]; a fourth number is alpha.
Palette read_jasc(std::string_view bytes, const std::string& file) {
  const std::vector<TextRow> rows = text_rows(bytes);
  const std::size_t count = count_of_head(rows, file);
  if (rows.size() - 3 != count) {
    throw Error(ErrorKind::kContent, file,
                "says that it has " + std::to_string(count) + " colours, but has " +
                    std::to_string(rows.size() - 3),
                "write or copy it again");
  }
  Palette palette;
  for (std::size_t i = 3; i < rows.size(); ++i) {
    std::string_view rest = rows[i].text;
    std::array<int, 4> codes{0, 0, 0, 255};
    for (std::size_t c = 0; c < 4 && (c < 3 || !rest.empty()); ++c) {
      const std::string_view word = take_word(rest);
      const auto code = code_of_word(word);
      if (!code) {
        fail_row(file, rows[i].number, "'" + std::string(word) + "' is no code from 0 to 255",
                 "write red green blue");
      }
      codes[c] = *code;
    }
    palette.colors.push_back({color_of_codes(codes[0], codes[1], codes[2]), {}, codes[3] / 255.0});
  }
  return palette;
}

std::string write_jasc(const Palette& palette) {
  std::string text = "JASC-PAL\r\n0100\r\n" + std::to_string(palette.colors.size()) + "\r\n";
  for (const PaletteColor& entry : palette.colors) {
    const auto [r, g, b] = color_codes8(entry.color);
    text += std::to_string(r) + " " + std::to_string(g) + " " + std::to_string(b);
    if (entry.alpha < 1) text += " " + std::to_string(unit_code(entry.alpha, 255));
    text += "\r\n";
  }
  return text;
}

}  // namespace tristim::detail
