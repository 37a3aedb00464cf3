#pragma once

#include <vector>

#include "lib/render/tile_draw.h"
#include "tristim/render/scene.h"

namespace tristim::detail {

/// Where the samples of a pixel lie: at its centre, or the points of Hammersley's set, of which
/// each row, column and cell of equal area has one [Hammersley60].
/// Throws std::invalid_argument for a number other than 1, 4, 16 and 64.
std::vector<SampleOffset> sample_offsets(int samples, int bits);

/// What a sample adds to the pixel `x` to the right and `y` below its own.
struct FilterTap {
  int x = 0, y = 0;
  double weight = 0;
};

/// For each sample the pixels that it counts for; all weights of a pixel add up to 1.
std::vector<std::vector<FilterTap>> filter_taps(const PixelFilter& filter,
                                                const std::vector<SampleOffset>& offsets, int bits);

/// How many pixels around a tile are needed for the pixels in it.
int filter_margin(const PixelFilter& filter) noexcept;

}  // namespace tristim::detail
