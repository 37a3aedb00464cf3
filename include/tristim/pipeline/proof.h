#pragma once

#include <memory>

#include "tristim/image/picture.h"
#include "tristim/pipeline/run.h"

namespace tristim {

/// What becomes of dots on paper, for proofs.
struct SeenDots {
  DotGain gain;   // NoGain: the dots are seen as they are
  int reach = 8;  // pixels from one in which its area is counted: about a cell of the screen
};

/// The gain that a dither has to reckon with on a display of dots: of the inks of a press and of
/// greys that are dithered. The reach is of the screen that the options tell.
SeenDots seen_dots(const Display& display, const ReduceOptions& options);

/// A proof: codes decoded back to light through the device model, as 8-bit sRGB into a sink.
///
/// Where dots gain, the paper between them takes as much of the ink as makes the tone around each
/// pixel what comes out on paper [Yule51]; then a row is written when those below it have come.
class ProofObserver : public BandObserver {
 public:
  /// `sink` takes rgb888 rows and outlives this.
  ProofObserver(const Display& display, CodeSink& sink, const SeenDots& dots = {});
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) override;

  /// After the last band: writes what is left and finishes the sink.
  void finish();

 private:
  std::unique_ptr<CodeSink> decode_;
};

/// Measures what the device shows against what was asked for: CIEDE2000 of each pixel, both as sRGB
/// light clipped to [0, 1], relative to their whites.
class DifferenceObserver : public BandObserver {
 public:
  /// `scene_stages`: after how many stages the picture is what was asked for; its primaries are
  /// `picture`.
  DifferenceObserver(const Primaries& picture, Adaptation adaptation, const Display& display,
                     int scene_stages);
  int light_after() const noexcept override { return scene_stages_; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) override;

  /// The mean over the pixels seen so far; 0 before the first.
  double mean_ciede2000() const noexcept {
    return pixels_ > 0 ? sum_ / static_cast<double>(pixels_) : 0;
  }

 private:
  Decoder decoder_;
  Eigen::Matrix3d srgb_from_picture_, srgb_from_device_;
  int scene_stages_;
  double sum_ = 0;
  std::uint64_t pixels_ = 0;
};

/// A sink of codes that writes their light, linear and relative to the device's white, in the
/// device's primaries; of dots that gain as proofs do.
std::unique_ptr<CodeSink> decoding_sink(const Display& display, std::unique_ptr<RowSink> light,
                                        const SeenDots& dots = {});

}  // namespace tristim
