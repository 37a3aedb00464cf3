#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "tristim/color/gamut_map.h"
#include "tristim/color/primaries.h"
#include "tristim/image/view.h"

namespace tristim {

/// Some full rows of a picture: what stages work on, in place. Three channels of linear light.
struct Band {
  ImageView<float> view;
  int y0 = 0;  // the picture's row of the view's first row; ordered dither needs it
  ImageView<const float> dither_mask =
      {};  // strength of the dither, 1 channel, 0 .. 1; empty: 1 everywhere
};

/// Pixels that a stage could not keep as they were.
struct StageCounts {
  std::uint64_t out_of_gamut = 0;  // a channel below 0: no mixture of the device's primaries
  std::uint64_t clipped = 0;       // a channel above 1: brighter than the device's white
  friend constexpr bool operator==(const StageCounts&, const StageCounts&) = default;
  constexpr StageCounts& operator+=(const StageCounts& other) noexcept {
    out_of_gamut += other.out_of_gamut;
    clipped += other.clipped;
    return *this;
  }
};

/// One step of the chain in words, for --explain and reports.
struct StepReport {
  std::string name;
  std::string formula;
  std::string source;
  std::vector<std::pair<std::string, std::string>> numbers;
};

/// Multiplies light by 2^stops.
struct Exposure {
  double stops = 0;
};

/// A curve that brings the luminances of a scene into [0, 1].
struct ToneOperator {
  std::string_view name;
  float (*luminance)(float luminance, float white) noexcept;  // of a luminance above 0
  double (*exact)(double luminance, double white) noexcept;   // the same in double
  std::string_view formula;
  std::string_view source;
};

/// L/(1 + L), and with a white W above 0 that comes out as 1: L (1 + L/W^2)/(1 + L).
float reinhard_luminance(float luminance, float white) noexcept;
double reinhard_luminance(double luminance, double white) noexcept;

/// Every operator. The command line, the docs and the tests read this list.
inline constexpr ToneOperator kToneOperators[] = {
    {"reinhard", reinhard_luminance, reinhard_luminance, "Ld = L (1 + L/W^2)/(1 + L), RGB Ld/L",
     "[Reinhard02 eq 4]"}};

/// Scales each pixel so that its luminance goes through the operator; its chromaticity stays.
struct ToneMap {
  ToneOperator tone = kToneOperators[0];
  double white = 0;  // the luminance that becomes 1; 0: none does
  Eigen::RowVector3d luminance = {0.2126, 0.7152, 0.0722};  // of the picture's primaries
};

/// Linear RGB of the picture to linear RGB of the device.
struct ConvertPrimaries {
  Eigen::Matrix3d matrix = Eigen::Matrix3d::Identity();
  Primaries from, to;
  Adaptation adaptation = Adaptation::kBradford;
};

/// Brings colours into the device's gamut, and counts those that were outside.
struct GamutMap {
  GamutMethod method = kClip;
  Eigen::Matrix3d srgb_from_device = Eigen::Matrix3d::Identity();  // linear, for Oklab
};

using Stage = std::variant<Exposure, ToneMap, ConvertPrimaries, GamutMap>;

/// Applies a stage to a band in place. Rows do not depend on one another. Finite input gives finite
/// output as long as no float overflows.
void apply(const Stage& stage, Band band, StageCounts& counts);

/// Takes one colour through a stage in double: what apply() on bands rounds to floats.
Rgb apply(const Stage& stage, Rgb rgb);

/// The step in words, with its numbers.
StepReport explain(const Stage& stage);

}  // namespace tristim
