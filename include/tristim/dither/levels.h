#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "tristim/dither/error_rows.h"
#include "tristim/dither/kernel.h"
#include "tristim/dither/level_search.h"
#include "tristim/image/view.h"

namespace tristim {

namespace detail {
struct LevelRows;
struct LevelTable;
struct StepTable;
}  // namespace detail

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
  std::shared_ptr<const detail::StepTable> table_;  // where one look-up tells the code
};

/// Levels among which a channel is mixed: their light, strictly ascending, and their codes. At
/// least one.
struct MixLevels {
  std::vector<float> light;
  std::vector<std::uint16_t> code;
};

struct DiffusionOptions {
  const DiffusionKernel* kernel = &kFloydSteinberg;
  bool serpentine = false;  // the second, fourth, ... row right to left with the kernel mirrored
  float jitter = 0;         // 0 .. 1: the threshold by chance, within half of it on either side
  std::uint64_t seed = 0;   // of what is left to chance
  bool settled = true;      // flat fields at the top begin as if they went on above
};

/// Error diffusion between the levels of one channel, in light [FloydSteinberg76].
///
/// The upper of two levels is taken above half way between them. Input is clipped to the levels'
/// range, the stored error is not; error that falls off the picture is dropped. Rows must come in
/// order, from the first.
///
/// Diffusion that begins without error gives its first dots late: near black a flat field loses a
/// tenth of its light in 256 rows. So fields that are flat in the first row, 32 pixels or more,
/// begin `settled`: with the errors that they would have if they went on above.
class LevelDiffusion {
 public:
  LevelDiffusion(const MixLevels& levels, int width, const DiffusionOptions& options);

  /// The next row. `strength`, pixel by pixel, 0 .. 1, is the share of the errors that a pixel
  /// takes and passes on; empty: 1.
  void row(ChannelRow<const float> in, ChannelRow<std::uint16_t> out,
           std::span<const float> strength = {});

  /// The next rows of a channel by itself: what row() makes of them one after the other, many at
  /// a time where they go one way, on up to `threads` threads.
  void rows(ImageView<const float> in, ImageView<std::uint16_t> out, int threads = 1);

 private:
  struct Raise {
    float by = 0;                       // of the threshold
    const ToneWeights* tone = nullptr;  // of kernels that follow it
  };
  struct Row {
    ChannelRow<const float> in;
    int y;
    float jitter;
    std::span<const float> strength;
    std::span<const std::uint8_t> taking_part;  // empty: all
  };
  Raise raise(int x, int y, float clipped, float jitter) const noexcept;
  template <typename Choose>
  void diffuse_row(const Row& row, Choose&& choose);
  void settle(ChannelRow<const float> first, std::span<const float> strength);
  const detail::LevelRows* fast_rows();

  MixLevels levels_;
  LevelSearch search_;  // half way points
  LevelSearch lower_;   // which two levels a light lies between
  DiffusionOptions options_;
  std::span<const ToneWeights> tones_;
  std::uint32_t seed_;
  int width_;
  int y_ = 0;
  ErrorRows errors_;
  std::shared_ptr<const detail::LevelTable> table_;  // of the fast rows, when they are first asked
};

}  // namespace tristim
