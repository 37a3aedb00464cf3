#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tristim/palette/palette.h"

namespace tristim {

/// A file format for palettes.
struct PaletteFormat {
  std::string_view name;
  std::string_view extensions;  // separated by spaces, without the dot
  std::string_view what;
  int most_colors;  // that it holds
  int bits;         // of a channel that it keeps; 0: all that a double has

  // What it keeps of an entry besides its colour.
  bool keeps_names, keeps_alpha, keeps_codes;

  /// Whether the first bytes tell the format; nullptr: only the extension does.
  bool (*begins)(std::string_view bytes);

  /// Throws Error (kContent) "<file>, row 7: ..." or "<file>, byte 70: ..." for what it cannot
  /// read.
  Palette (*read)(std::string_view bytes, const std::string& file);

  /// Of at most most_colors.
  std::string (*write)(const Palette& palette);
};

/// Every format; of those with one extension the first is written. The command line, the docs, the
/// fuzz targets and the tests read this list.
std::span<const PaletteFormat> palette_formats() noexcept;

/// What a palette may have, whatever the format.
inline constexpr int kMostPaletteColors = 65536;

/// The format that a file is written in: by name, or by the extension of `path`. Throws Error
/// (kMisuse) for unknown ones, with what there is.
const PaletteFormat& palette_format_of(const std::string& path, std::string_view format = {});

/// A palette from the bytes of a file, whose format they tell, or else the extension of `file`; a
/// text without either is taken for colours as words.
///
/// Throws Error (kContent) where it is no palette, damaged, empty of colours or has more than
/// kMostPaletteColors.
Palette parse_palette(std::string_view bytes, const std::string& file,
                      std::string_view format = {});

/// A palette from a file; "-" is standard input. Throws Error: kSystem as read_text_file does, else
/// as parse_palette.
Palette read_palette(const std::string& path, std::string_view format = {});

/// The bytes of a palette file. Throws Error (kMisuse) where the format does not hold so many
/// colours, or there are none. `path` is for messages.
std::string palette_bytes(const Palette& palette, const PaletteFormat& format,
                          const std::string& path);

}  // namespace tristim
