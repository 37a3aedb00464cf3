#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/image/io/indexed.h"
#include "tristim/palette/palette.h"

namespace tristim::tools {

/// A palette and where it comes from.
struct PaletteSource {
  std::string name;  // as messages call it
  Palette palette;
  std::vector<std::uint64_t> pixels;  // of each colour, where it is a picture's; else empty
};

/// A palette as the command line names it: a file of palettes, a built-in device or a device file,
/// or a picture with a palette ("-": standard input); or colours as words. `option` is for
/// messages.
///
/// Throws Error: kContent for words that are no colours and for pictures without palette that have
/// more than 256 colours, else as read_palette.
PaletteSource load_palette(const std::vector<std::string>& words, const std::string& option);

/// The palette of a picture of positions, with the pixels that have them.
PaletteSource palette_source(const std::string& path, const IndexedPicture& picture);

/// Whether the words name one file rather than colours.
bool names_file(const std::vector<std::string>& words);

/// Whether a file is a picture rather than a palette of words or numbers.
bool is_picture(const std::string& path);

/// The light of a palette's colours.
std::vector<Rgb> palette_light(const Palette& palette);

}  // namespace tristim::tools
