#pragma once

#include <memory>
#include <vector>

#include "tristim/device/display.h"
#include "tristim/dither/method.h"
#include "tristim/dither/palette.h"
#include "tristim/frame/code.h"
#include "tristim/palette/metric.h"
#include "tristim/pipeline/plan.h"

namespace tristim {

/// What suits a device: none from 8 bits a channel on, the clustered screen for
/// printers that cannot hold isolated dots, blue-diffusion for other 1-bit devices and for palettes
/// chosen for a picture, Floyd-Steinberg for the rest.
const NamedDither& default_dither(const Display& display);

/// Whether a dither works on a display: those for whole pictures take channels and inks, not
/// palettes.
bool takes_dither(const Display& display, const DitherMethod& dither) noexcept;

struct ReduceOptions {
  DitherMethod dither = NoDither{};
  DitherParameters parameters;
  Metric metric = kMetrics[0];
  Mix mix = Mix::kLight;
  BlackPoint black_point = BlackPoint::kRelative;
};

/// Picture light in the device's primaries to samples of a frame: codes, or positions in the
/// device's palette.
class Reducer {
 public:
  /// For pictures of `width` pixels. Throws std::invalid_argument for an indexed display without
  /// palette and for a dither that the display does not take.
  Reducer(const Display& display, const ReduceOptions& options, int width);
  Reducer(Reducer&&) noexcept;
  ~Reducer();

  /// Samples of a pixel: 3 or 1.
  int samples() const noexcept;

  /// Whether the one band must be the whole picture.
  bool whole_picture() const noexcept;

  /// `band` (three channels, light; values outside of [0, 1] count as the nearer end) to `codes`,
  /// of the same size with samples() channels. May use the band as scratch. Where chains() is not
  /// 0, bands must come one after the other from the picture's top; else several threads may call
  /// this at once, in any order.
  void reduce(Band band, ImageView<std::uint16_t> codes, int threads = 1);

  /// Whether prepare() takes the lead of a plan.
  bool leads() const noexcept;

  /// How many parts of reduce() need the bands in order: error diffusion, each channel by itself.
  int chains() const noexcept;

  /// reduce() in steps, for those who have several bands under way: prepare() of any bands at once;
  /// then advance() of each chain, which takes the bands in order and may do so beside other chains
  /// with other bands; then finish(). Up to `threads` threads may help with a band. Returns what
  /// the lead counted.
  StageCounts prepare(Band band, ImageView<std::uint16_t> codes, const Lead& lead = {},
                      int threads = 1);
  void advance(int chain, Band band, ImageView<std::uint16_t> codes, int threads = 1);
  void finish(ImageView<std::uint16_t> codes) const;

  /// The steps in words.
  std::vector<StepReport> explain() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Samples of a frame back to light through the device model, relative to its white, in linear RGB
/// of its primaries.
class Decoder {
 public:
  explicit Decoder(const Display& display);

  /// `codes` as a Reducer made them, to `light`, three channels.
  void decode(ImageView<const std::uint16_t> codes, ImageView<float> light) const;

  /// Light of one sample of channel `channel`; of a palette entry or grey level all three.
  Rgb light(const std::uint16_t* samples) const noexcept;

 private:
  int samples_;
  std::vector<float> channel_[3];
  std::vector<Rgb> entries_;  // by sample, of palettes and greys
};

/// What writers need to know of a frame for a display: layout, palette (sRGB appearance), colour
/// tags.
FrameInfo frame_info(const Display& display, int width, int height);

}  // namespace tristim
