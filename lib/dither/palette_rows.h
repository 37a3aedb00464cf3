#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "lib/dither/entry_grid.h"
#include "lib/dither/skewed_rows.h"
#include "tristim/image/view.h"

namespace tristim::detail {

/// What diffusion to a palette is told, and its entries in planes.
struct PaletteRowsPlan {
  PaletteRowsPlan(const MixPalette& palette, const EntryGrid& grid, const ErrorRows& errors,
                  bool closed, float jitter, std::uint32_t seed);

  const EntryGrid* grid;
  std::array<std::vector<float>, 3> entry;  // light, or the numbers of the mix
  std::array<float, 3> low, high;           // that colours are held within
  std::array<float, 3> jitter;              // of the threshold
  float passed_on;
  std::uint32_t seed;

  SkewedRows rows;
};

/// Rows that follow one another, from left to right.
struct PaletteRowsBand {
  int y0;
  std::array<ImageView<const float>, 3> wanted;  // planes, inside of what the palette mixes
  ImageView<const std::int32_t> fixed;           // entries that are to be taken; -1: none
  ImageView<std::uint16_t> indices;
};

/// Where groups of rows meet, by channel.
struct PaletteMeetingRows {
  PaletteMeetingRows(int width, const SkewedRows& rows, int lanes)
      : channel{MeetingRows(width, rows, lanes), MeetingRows(width, rows, lanes),
                MeetingRows(width, rows, lanes)} {}

  std::array<MeetingRows, 3> channel;
};

/// Diffusion of rows to a palette as PaletteDiffusion defines it, bit for bit. Takes up to
/// `lanes` rows side by side.
struct PaletteRows {
  std::string_view name;  // instruction set
  int lanes = 0;
  void (*run)(const PaletteRowsPlan& plan, const PaletteRowsBand& band,
              const PaletteMeetingRows& above, PaletteMeetingRows& below) = nullptr;
};

/// Those that this processor has, the best first; none where there are no vectors.
std::span<const PaletteRows> all_palette_rows();

/// The best, or the one that TRISTIM_SIMD names; nullptr: the definition is to be taken.
const PaletteRows* palette_rows();

}  // namespace tristim::detail
