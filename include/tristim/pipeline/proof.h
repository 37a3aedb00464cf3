#pragma once

#include <memory>

#include "tristim/image/picture.h"
#include "tristim/pipeline/run.h"

namespace tristim {

/// A proof: codes decoded back to light through the device model, as 8-bit sRGB into a sink.
class ProofObserver : public BandObserver {
 public:
  /// `sink` takes rgb888 rows and outlives this.
  ProofObserver(const Display& display, CodeSink& sink);
  int light_after() const noexcept override { return -1; }
  void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) override;

 private:
  Decoder decoder_;
  Reducer to_srgb_;
  Stage to_srgb_primaries_;
  CodeSink* sink_;
  int y_ = 0;
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
/// device's primaries.
std::unique_ptr<CodeSink> decoding_sink(const Display& display, std::unique_ptr<RowSink> light);

}  // namespace tristim
