#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "tristim/color/primaries.h"
#include "tristim/frame/layout.h"
#include "tristim/image/view.h"

namespace tristim {

/// An entry of a device's palette as a writer needs it.
struct PaletteEntry {
  std::array<std::uint8_t, 3> srgb{};  // what it looks like, relative to the device's white
  std::uint16_t code = 0;              // what the frame buffer holds for it
  std::string name;                    // may be empty
  std::uint8_t alpha = 255;            // coverage; files without it take the colour as it is
};

/// What a frame of codes is, before any of its rows is written.
///
/// Samples are what the frame buffer holds, except where there is a palette: then they are
/// positions in it (PNG, GIF, BMP and TIFF keep them, in the palette's order; raw and C writers
/// store the entry's code instead).
struct FrameInfo {
  int width = 0;
  int height = 0;
  FrameLayout layout;
  std::vector<PaletteEntry> palette;
  int frames = 1;      // pictures of that size, one after the other, for formats that move
  double delay_s = 0;  // seconds that each of them is shown

  // For the file formats that describe their colours; the codes do not depend on them.
  Primaries primaries;          // of RGB codes
  bool srgb = false;            // codes are sRGB: its primaries and its curve
  std::optional<double> gamma;  // the codes' exponent, where one describes them
  double dpi = 0;               // dots an inch on paper; 0: not known
  std::string device;           // for comments
};

/// Takes rows of codes, top to bottom.
class CodeSink {
 public:
  virtual ~CodeSink() = default;

  /// The next rows: `layout.packing.samples` channels, each code below 2^bits (or below the
  /// palette's size). Throws Error (kSystem) where they cannot be written.
  virtual void write(ImageView<const std::uint16_t> rows) = 0;

  /// After the last row: makes the file appear under its name. Without it nothing is left behind.
  virtual void finish() = 0;
};

}  // namespace tristim
