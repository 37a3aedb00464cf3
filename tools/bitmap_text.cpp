#include "tools/bitmap_text.h"

#include <algorithm>

namespace tristim::tools {
namespace {

constexpr std::uint8_t kGlyphs[][kGlyphHeight] = {
#include "luts/fixed_6x13.csv"
};

const std::uint8_t* glyph(char character) noexcept {
  const int place = static_cast<unsigned char>(character) - ' ';
  const bool known = place >= 0 && place < static_cast<int>(std::size(kGlyphs));
  return kGlyphs[known ? place : '?' - ' '];
}

}  // namespace

void draw_text(ImageView<std::uint16_t> picture, int x, int y, std::string_view text) noexcept {
  for (const char character : text) {
    const std::uint8_t* rows = glyph(character);
    for (int row = 0; row < kGlyphHeight; ++row) {
      for (int column = 0; column < kGlyphWidth; ++column) {
        const bool inked = (rows[row] << column & 0x80) != 0;
        const int px = x + column;
        const int py = y + row;
        if (!inked || px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
        std::fill_n(picture.pixel(px, py), picture.channels, std::uint16_t{0});
      }
    }
    x += kGlyphWidth;
  }
}

}  // namespace tristim::tools
