#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "tristim/device/display.h"
#include "tristim/lut/lut.h"

namespace tristim {

/// How the numbers of a file lie in it, where the format leaves the choice.
struct LutFileOptions {
  int bits = 0;            // of an integer, 8 to 16; 0: the format's own
  bool cube = false;       // bytes without header are those of a cube; else of curves
  bool progmem = false;    // C arrays lie in the program memory of AVR microcontrollers
  bool one_curve = false;  // bytes without header are one curve for all channels; else R G B
  const Display* display = nullptr;  // whose profile an ICC file is; nullptr: sRGB
};

/// What the ends of a table may stand for.
enum class LutRanges {
  kUnit,   ///< 0 to 1
  kEqual,  ///< the same for all channels
  kAny,
};

/// What a format takes of a Lut as it stands.
struct LutCapacity {
  int curves = 0;                   // entries of a Lut1D that it takes at most; 0: takes none
  int cube = 0;                     // points of an edge of a Lut3D; 0: takes none
  int shaper = 0;                   // entries of a Lut1D in front of a Lut3D; 0: takes no two steps
  std::span<const int> sizes = {};  // all that there are; empty: 2 to the most
  LutRanges alone = LutRanges::kUnit;   // of the only step
  LutRanges first = LutRanges::kUnit;   // of two: the shaper's
  LutRanges second = LutRanges::kUnit;  // and the cube's
  bool grey = false;                    // the shaper is one curve for all channels
  bool points = false;                  // LutPoints alone
  bool points_first = false;            // LutPoints in front of a Lut1D or Lut3D
  bool any = false;                     // any steps in any order, LutPoints where `points`
  int bits = 0;                         // of an integer; 0: floats
  bool chooses_bits = false;            // options may say others, integers instead of floats too
};

/// A file format for look-up tables.
struct LutFormat {
  std::string_view name;
  std::string_view extensions;  // separated by spaces, without the dot
  std::string_view what;
  LutCapacity holds;

  /// Whether the first bytes tell the format; nullptr: only the extension does.
  bool (*begins)(std::string_view bytes);

  /// Throws Error (kContent) "<file>, row 7: ..." or "<file>, byte 70: ..." for what it cannot
  /// read. The result may break the rules of check().
  Lut (*read)(std::string_view bytes, const std::string& file, const LutFileOptions& options);

  /// Of what it holds.
  std::string (*write)(const Lut& lut, const LutFileOptions& options);
};

/// Every format; of those with one extension the first is written. The command line, the docs, the
/// fuzz targets and the tests read this list.
std::span<const LutFormat> lut_formats() noexcept;

/// The format that a file is written in: by name, or by the extension of `path`. Throws Error
/// (kMisuse) for unknown ones, with what there is.
const LutFormat& lut_format_of(const std::string& path, std::string_view format = {});

/// A table from the bytes of a file, whose format they tell, or else the extension of `file`.
///
/// Tables are asked memory for only when the bytes for them are there. Throws Error (kContent)
/// where it is none, damaged, or holds numbers that are not finite.
Lut parse_lut(std::string_view bytes, const std::string& file, std::string_view format = {},
              const LutFileOptions& options = {});

/// A table from a file; "-" is standard input. Throws Error: kSystem as read_text_file does, else
/// as parse_lut.
Lut read_lut(const std::string& path, std::string_view format = {},
             const LutFileOptions& options = {});

/// Whether the format holds the table as it stands.
bool holds(const LutFormat& format, const Lut& lut) noexcept;

/// What the format holds, in words: "a cube of 2 to 256 points an edge over 0 to 1".
std::string describe(const LutCapacity& capacity);

/// The bytes of a file. Values outside of what integers hold are clipped. Throws Error (kMisuse)
/// where the format does not hold the table. `path` is for messages and names.
std::string lut_bytes(const Lut& lut, const LutFormat& format, const std::string& path,
                      const LutFileOptions& options = {});

/// Sizes to sample a table with.
struct LutFitSizes {
  int curves = 0;  // entries of curves, where the result is curves; 0: it is a cube then
  int cube = 0;    // points of a cube's edge; 0: makes no cube
  int shaper = 0;  // entries of curves in front of a cube; 0: as many as the table's own
};

/// A table sampled anew so that the format holds it: as curves where each channel depends on itself
/// alone and the format has curves; else as a cube, behind the table's own first curves where the
/// format has both. The range is that of the first step, or 0 to 1 where the format has no other.
///
/// Throws Error (kMisuse) where no size does; std::invalid_argument for sizes out of bounds.
Lut fit_lut(const Lut& lut, const LutFormat& format, const LutFitSizes& sizes,
            const std::string& path);

}  // namespace tristim
