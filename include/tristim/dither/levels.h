#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/dither/error_rows.h"
#include "tristim/dither/kernel.h"
#include "tristim/dither/level_search.h"
#include "tristim/dither/threshold_matrix.h"

namespace tristim {

/// One channel of a row inside interleaved samples.
template <typename T>
struct ChannelRow {
  T* data = nullptr;
  int width = 0;
  int step = 1;  // samples from pixel to pixel
  T& operator[](int x) const noexcept { return data[static_cast<std::ptrdiff_t>(x) * step]; }
};

/// Chooses the nearest of a device's levels by decision points made beforehand.
class NearestLevel {
 public:
  /// `code[i + 1]` is taken from `threshold[i]` on: one more code than thresholds, which ascend.
  NearestLevel(std::span<const float> threshold, std::span<const std::uint16_t> code);

  void row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out) const noexcept;

 private:
  LevelSearch search_;
  std::vector<std::uint16_t> code_;
};

/// Levels among which a channel is mixed: their light, strictly ascending, and their codes. At
/// least one.
struct MixLevels {
  std::vector<float> light;
  std::vector<std::uint16_t> code;
};

/// Ordered dither between the levels that bracket a light, at its fraction f of the way, in light:
/// S = floor(f N + 1/2), N the ranks of the matrix; the upper level where S > rank [Shoaff 2.1.2].
class OrderedDither {
 public:
  OrderedDither(MixLevels levels, ThresholdMatrix matrix);

  /// Row `y` of the picture. Light outside the levels takes the end level. `strength`, pixel by
  /// pixel, 0 .. 1, draws the thresholds towards half way, where the nearest level changes;
  /// empty: 1.
  void row(ChannelRow<const float> in, int y, ChannelRow<std::uint16_t> out,
           std::span<const float> strength = {}) const noexcept;

 private:
  MixLevels levels_;
  std::vector<float> steps_per_light_;  // N / (upper - lower), by lower level
  ThresholdMatrix matrix_;
  LevelSearch search_;
};

struct DiffusionOptions {
  const DiffusionKernel* kernel = &kFloydSteinberg;
  bool serpentine = false;  // the second, fourth, ... row right to left with the kernel mirrored
};

/// Error diffusion between the levels of one channel, in light [FloydSteinberg76].
///
/// The upper of two levels is taken above half way between them. Input is clipped to the levels'
/// range, the stored error is not; error that falls off the picture is dropped. Rows must come in
/// order, from the first.
class LevelDiffusion {
 public:
  LevelDiffusion(const MixLevels& levels, int width, const DiffusionOptions& options);
  /// The next row. `strength`, pixel by pixel, 0 .. 1, is the share of the error that is passed on;
  /// empty: 1.
  void row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out,
           std::span<const float> strength = {});

 private:
  MixLevels levels_;
  LevelSearch search_;  // half way points
  DiffusionOptions options_;
  int width_;
  int y_ = 0;
  ErrorRows errors_;
};

}  // namespace tristim
