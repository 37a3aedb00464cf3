#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tristim/frame/code.h"

namespace tristim::detail {

/// The colours that a file's indices stand for.
struct ColorTable {
  std::vector<PaletteEntry> entries;
  int bits = 8;  // that an index takes, 1 to 8
};

inline constexpr std::size_t kMostTableColors = 256;

/// The table of a frame: its palette, or the greys of its codes. `format` is for messages. Throws
/// Error (kMisuse) where the codes are RGB or greys of 16 bits, or the palette has more than
/// kMostTableColors.
ColorTable color_table(const std::string& path, const FrameInfo& info, std::string_view format);

/// The first entry that is nothing but transparent; -1 where there is none.
int transparent_entry(const std::vector<PaletteEntry>& entries) noexcept;

}  // namespace tristim::detail
