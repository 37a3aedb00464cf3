#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "tristim/dither/levels.h"
#include "tristim/image/view.h"

namespace tristim {

/// What a method for whole pictures may be told.
struct WholePictureParameters {
  std::uint64_t seed = 0;
  int effort = 0;                      // how long to search; 0: the method's own
  float strength = 1;                  // of the dither, 0 .. 1
  ImageView<const float> dither_mask;  // strength by pixel, 1 channel, 0 .. 1; empty: 1 everywhere
};

/// A dither that cannot work row by row: it sees all of a channel's light before it gives a code.
struct WholePictureDither {
  std::string_view name;
  /// `light` (1 channel) between `levels` to `codes`, of the same size.
  void (*channel)(ImageView<const float> light, const MixLevels& levels,
                  const WholePictureParameters& parameters, ImageView<std::uint16_t> codes);
  std::string_view source;
};

/// Every such method. The command line, the docs and the property tests read this list.
inline constexpr std::array<WholePictureDither, 0> kWholePictureDithers{};

}  // namespace tristim
