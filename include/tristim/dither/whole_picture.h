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
  int threads = 0;                     // that may help, 0: one for each processor; the same codes

  /// The strength of a pixel.
  float share(int x, int y) const noexcept {
    return dither_mask.data == nullptr ? strength : strength * *dither_mask.pixel(x, y);
  }
};

/// A dither that cannot work row by row: it sees all of a channel's light before it gives a code.
struct WholePictureDither {
  std::string_view name;
  /// `light` (1 channel) between `levels` to `codes`, of the same size.
  void (*channel)(ImageView<const float> light, const MixLevels& levels,
                  const WholePictureParameters& parameters, ImageView<std::uint16_t> codes);
  std::string_view source;
};

/// Error diffusion along a Hilbert curve [Riemersma98]: a pixel receives the errors of the 16
/// before it on the curve, the nearest sixteen times as much as the farthest. Where the article
/// adds up the errors of input against output, these are errors of what was wanted, in shares that
/// sum to 1: the tone is kept.
void riemersma_channel(ImageView<const float> light, const MixLevels& levels,
                       const WholePictureParameters& parameters, ImageView<std::uint16_t> codes);

/// Dot diffusion [Knuth87]: pixels go by their class in an 8 x 8 matrix, the error to neighbours of
/// later classes, to those at the sides twice what those at the corners get. What the two barons of
/// a matrix, which have no such neighbours, drop in the article goes on from baron to baron: the
/// tone is kept.
void dot_diffusion_channel(ImageView<const float> light, const MixLevels& levels,
                           const WholePictureParameters& parameters,
                           ImageView<std::uint16_t> codes);

/// Direct binary search [Analoui92]: from blue-diffusion on, pixels change to the next level or
/// trade levels with a neighbour wherever that lessens the error that an eye sees, by the contrast
/// sensitivity of [Nasanen84] at 40 pixels a degree. `effort` is the most passes over the picture,
/// 12 of its own; it ends where nothing changes. The same for any number of threads.
void direct_search_channel(ImageView<const float> light, const MixLevels& levels,
                           const WholePictureParameters& parameters,
                           ImageView<std::uint16_t> codes);

/// Every such method. The command line, the docs and the property tests read this list.
inline constexpr std::array kWholePictureDithers{
    WholePictureDither{"riemersma", riemersma_channel, "[Riemersma98]"},
    WholePictureDither{"dot-diffusion", dot_diffusion_channel, "[Knuth87]"},
    WholePictureDither{"direct-search", direct_search_channel, "[Analoui92], [Nasanen84]"},
};

}  // namespace tristim
