#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/pipeline/channel_reducer.h"
#include "lib/pipeline/ink_planes.h"

namespace tristim::detail {

/// Light to the levels of a device's channels: of three colours, or the luminance alone.
class LevelReducer {
 public:
  /// `options` must outlive this.
  LevelReducer(const Display& display, const ReduceOptions& options, int width);

  /// By every method but error diffusion. Those for whole pictures work on `threads` threads.
  void reduce(Band band, ImageView<std::uint16_t> codes, int threads = 1);

  /// Error diffusion: the light of a band channel by channel, side by side in its rows.
  void prepare(const Band& band) const;

  /// Error diffusion of one channel of a band so prepared, to codes side by side in theirs.
  void advance(int channel, const Band& band, ImageView<std::uint16_t> codes, int threads);

  /// By channel.
  std::span<const LevelScale> scales() const noexcept { return scales_; }

 private:
  bool grey() const noexcept { return channels_.size() == 1; }
  std::span<float> grey_row(std::span<float> rgb) const;
  void reduce_rgb_row(std::span<float> rgb, int y, std::span<std::uint16_t> out,
                      std::span<const float> strength);
  void reduce_whole(const Band& band, ImageView<std::uint16_t> codes, int threads);

  const ReduceOptions* options_;
  std::vector<LevelScale> scales_;
  std::vector<ChannelReducer> channels_;
  bool alike_ = false;  // all channels take the nearest of the same levels
  Eigen::RowVector3f luminance_;
  ToneBeforeGain tone_before_gain_;
};

}  // namespace tristim::detail
