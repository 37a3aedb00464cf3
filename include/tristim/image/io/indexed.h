#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tristim/image/view.h"

namespace tristim {

/// A picture of positions in a palette, as its file holds it.
struct IndexedPicture {
  std::vector<std::array<std::uint8_t, 4>> palette;  // encoded R, G, B, and alpha; 1 to 256
  Raster<std::uint8_t> positions;                    // one channel, each below the palette's size
  int pictures = 1;  // that a GIF holds; the positions are those of the first
};

/// The palette and the positions of a PNG, GIF, BMP or TIFF file; nothing where it has none, or is
/// of another format. "-" is standard input.
///
/// TIFF's palettes of 16 bits a channel are rounded to 8. Where the first picture of a GIF leaves
/// part of its screen free, that has the transparent position, else the background's.
///
/// Throws Error: kSystem as open_picture; kContent where the file is damaged or larger than 512 MiB
/// of pixels, or a pixel's position is beyond the palette.
std::optional<IndexedPicture> read_indexed_picture(const std::string& path);

}  // namespace tristim
