#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <vector>

#include "tristim/dither/palette.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::detail {

/// Light to positions in a palette of colours.
class PaletteReducer {
 public:
  /// Throws std::invalid_argument where the display has no palette. `options` must outlive this.
  PaletteReducer(const Display& display, const ReduceOptions& options, int width);

  /// Error diffusion on up to `threads` threads.
  void reduce(Band band, ImageView<std::uint16_t> indices, int threads = 1);

  int size() const noexcept { return palette_->size(); }

 private:
  const ReduceOptions* options_;
  std::unique_ptr<const MixPalette> palette_;  // where the diffusion knows it
  std::optional<PaletteOrdered> ordered_;
  std::optional<PaletteDiffusion> diffusion_;
  Eigen::Matrix3f srgb_from_device_;
};

}  // namespace tristim::detail
