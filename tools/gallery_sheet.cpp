#include "tools/gallery_sheet.h"

#include <algorithm>
#include <cmath>

#include "tools/bitmap_text.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::tools {
namespace {

constexpr int kMargin = 12;  // around a cell
constexpr int kGap = 4;      // between the pictures and the words of a cell
constexpr double kShape = 1.6;

struct CellSize {
  int width = 0, height = 0;
};

CellSize size_of(const std::vector<GalleryCell>& cells) {
  CellSize size;
  for (const GalleryCell& cell : cells) {
    std::size_t longest = cell.title.size();
    for (const std::string& line : cell.lines) longest = std::max(longest, line.size());
    const int words = static_cast<int>(longest) * kGlyphWidth;
    const int rows = static_cast<int>(cell.lines.size() + 1) * kGlyphHeight;
    const int pictures = cell.picture.view().height + cell.ramp.view().height + 2 * kGap;
    size.width = std::max({size.width, cell.picture.view().width, words});
    size.height = std::max(size.height, pictures + rows);
  }
  return {size.width + kMargin, size.height + kMargin};
}

// Light as codes of sRGB at a place of the sheet.
void place(ImageView<std::uint16_t> sheet, int left, int top, ImageView<const float> light) {
  Reducer to_codes(Display{}, {}, light.width);
  Image row(light.width, 1, 3);
  for (int y = 0; y < light.height; ++y) {
    std::copy(light.row(y).begin(), light.row(y).end(), row.view().row(0).begin());
    ImageView<std::uint16_t> to = sheet.rows(top + y, 1);
    to.data += std::ptrdiff_t{left} * sheet.channels;
    to.width = light.width;
    to_codes.reduce({row.view(), y}, to);
  }
}

void draw(const GalleryCell& cell, ImageView<std::uint16_t> sheet, int left, int top) {
  place(sheet, left, top, cell.picture.view());
  top += cell.picture.view().height + kGap;
  place(sheet, left, top, cell.ramp.view());
  top += cell.ramp.view().height + kGap;
  draw_text(sheet, left, top, cell.title);
  for (const std::string& line : cell.lines) {
    top += kGlyphHeight;
    draw_text(sheet, left, top, line);
  }
}

}  // namespace

Raster<std::uint16_t> gallery_sheet(const std::vector<GalleryCell>& cells, int columns) {
  const CellSize size = size_of(cells);
  const auto count = static_cast<int>(cells.size());
  const double ideal = std::sqrt(kShape * count * size.height / size.width);
  if (columns == 0) columns = std::clamp(static_cast<int>(std::lround(ideal)), 1, count);
  const int rows = (count + columns - 1) / columns;
  Raster<std::uint16_t> sheet(columns * size.width + kMargin, rows * size.height + kMargin, 3);
  for (int y = 0; y < sheet.view().height; ++y) {
    std::fill(sheet.view().row(y).begin(), sheet.view().row(y).end(), std::uint16_t{255});
  }
  for (int i = 0; i < count; ++i) {
    draw(cells[static_cast<std::size_t>(i)], sheet.view(), kMargin + i % columns * size.width,
         kMargin + i / columns * size.height);
  }
  return sheet;
}

}  // namespace tristim::tools
