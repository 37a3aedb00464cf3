#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "lib/pipeline/channel_reducer.h"
#include "lib/pipeline/ink_planes.h"
#include "lib/pipeline/stage_rows.h"

namespace tristim::detail {

/// Light to the levels of a device's channels: of three colours, or the luminance alone.
class LevelReducer {
 public:
  /// `options` must outlive this.
  LevelReducer(const Display& display, const ReduceOptions& options, int width);

  /// Whether reduce() and prepare() take a lead: for colours, unless the whole picture is needed.
  bool leads() const noexcept;

  /// By every method but error diffusion. Those for whole pictures work on `threads` threads.
  StageCounts reduce(Band band, ImageView<std::uint16_t> codes, const Lead& lead, int threads);

  /// Error diffusion: the light of a band channel by channel, side by side in its rows.
  StageCounts prepare(const Band& band, const Lead& lead) const;

  /// Error diffusion of one channel of a band so prepared, to codes side by side in theirs.
  void advance(int channel, const Band& band, ImageView<std::uint16_t> codes, int threads);

  /// By channel.
  std::span<const LevelScale> scales() const noexcept { return scales_; }

 private:
  bool grey() const noexcept { return channels_.size() == 1; }
  std::span<float> grey_row(std::span<float> rgb) const;
  StageCounts reduce_rgb_row(const RowLead& lead, std::span<const float> rgb, int y,
                             std::span<std::uint16_t> out, std::span<const float> strength);
  void reduce_whole(const Band& band, ImageView<std::uint16_t> codes, int threads);

  const ReduceOptions* options_;
  std::vector<LevelScale> scales_;
  std::vector<ChannelReducer> channels_;
  Eigen::RowVector3f luminance_;
  ToneBeforeGain tone_before_gain_;
};

}  // namespace tristim::detail
