#include "lib/image/io/indexed_readers.h"
#include "lib/image/io/png_input.h"
#include "tristim/core/error.h"

namespace tristim::detail {

std::optional<IndexedPicture> read_indexed_png(InputFilePtr file) {
  PngInput png(std::move(file), /*keep_positions=*/true);
  const std::string& name = png.file().name();
  if (!png.read_header()) {
    throw Error(ErrorKind::kContent, name,
                std::string("its PNG header is damaged or cut off: ") + png.message(),
                "write or copy it again");
  }
  if (png.stored_type() != PNG_COLOR_TYPE_PALETTE) return std::nullopt;
  IndexedPicture picture;
  picture.positions = position_raster(name, png.width(), png.height());
  const auto alphas = png.alphas();
  for (const png_color& color : png.palette()) {
    const std::size_t i = picture.palette.size();
    picture.palette.push_back(
        {color.red, color.green, color.blue, i < alphas.size() ? alphas[i] : png_byte{255}});
  }
  const auto view = picture.positions.view();
  std::vector<png_bytep> rows;
  for (int y = 0; y < view.height; ++y) rows.push_back(view.row(y).data());
  if (png.interlaced()) {
    if (!png.read_rows(rows.data(), view.height)) fail_at_row(name, 0, png.message());
    return picture;
  }
  for (int y = 0; y < view.height; ++y) {
    if (!png.read_rows(&rows[static_cast<std::size_t>(y)], 1)) fail_at_row(name, y, png.message());
  }
  return picture;
}

}  // namespace tristim::detail
