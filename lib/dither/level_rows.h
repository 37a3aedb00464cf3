#pragma once

#include <cstdint>
#include <string_view>

#include "lib/dither/level_table.h"
#include "lib/dither/skewed_rows.h"
#include "tristim/image/view.h"

namespace tristim::detail {

/// What diffusion to levels is told.
struct LevelRowsPlan {
  SkewedRows rows;
  const LevelTable* table;
  float jitter = 0;  // of the threshold; 0 of many levels
  std::uint32_t seed = 0;
};

/// Rows of one channel that follow one another, from left to right.
struct LevelRowsBand {
  int y0;
  ImageView<const float> in;
  ImageView<std::uint16_t> out;
};

/// Diffusion of rows to levels as LevelDiffusion defines it, bit for bit. Takes up to `most` rows
/// side by side in the lanes of vectors.
struct LevelRows {
  std::string_view name;  // instruction set
  int most = 0;
  void (*run)(const LevelRowsPlan& plan, const LevelRowsBand& band, const MeetingRows& above,
              MeetingRows& below) = nullptr;
};

/// Those that this processor has, the best first; none where there are no vectors.
std::span<const LevelRows> all_level_rows();

/// The best, or the one that TRISTIM_SIMD names; nullptr: the definition is to be taken.
const LevelRows* level_rows();

}  // namespace tristim::detail
