#pragma once

#include <Eigen/Core>
#include <array>
#include <string_view>

#include "tristim/color/primaries.h"
#include "tristim/color/rgb.h"

namespace tristim {

/// The gamut of linear RGB in [0, 1], and the way from it to the cone responses of Oklab.
struct GamutSpace {
  Eigen::Matrix3d lms_from_rgb, rgb_from_lms;
};

/// `srgb_from_rgb`: linear RGB to linear sRGB, white to white.
GamutSpace gamut_space(const Eigen::Matrix3d& srgb_from_rgb);

/// Of `primaries`; their white is adapted to sRGB's by Bradford.
GamutSpace gamut_space(const Primaries& primaries);

/// Whether every component is in [0, 1]; NaN is not.
constexpr bool in_gamut(Rgb rgb) noexcept {
  return rgb.r >= 0 && rgb.r <= 1 && rgb.g >= 0 && rgb.g <= 1 && rgb.b >= 0 && rgb.b <= 1;
}

// Ways to bring linear RGB into [0, 1]. What comes out is inside, exactly, for every finite input;
// NaN gives NaN.

/// Each channel to [0, 1] by itself.
Rgb gamut_clip(Rgb rgb, const GamutSpace& space) noexcept;

/// Towards the grey of the same Oklab lightness at constant hue, as far as it takes: the largest
/// chroma inside that is at most the colour's. Colours inside stay as they are to the bit;
/// lightness beyond white's becomes white, below black's black.
///
/// Continuous. Hue within .9 degrees and lightness within .003 for the gamuts of displays; those of
/// cameras and ProPhoto, whose primaries no light has, turn the darkest blues by more.
Rgb gamut_desaturate(Rgb rgb, const GamutSpace& space) noexcept;

/// Chroma above kCompressKnee of the largest at its Oklab lightness and hue is compressed so that
/// none reaches that: with x the chroma over the largest and k the knee, k + (1-k) z/(1+z), z =
/// (x-k)/(1-k). Rising and smooth; colours below the knee stay as they are to the bit; lightness
/// beyond white's becomes white, below black's black.
Rgb gamut_compress(Rgb rgb, const GamutSpace& space) noexcept;

inline constexpr double kCompressKnee = 0.8;

/// A way to bring colours inside.
struct GamutMethod {
  std::string_view name;
  Rgb (*map)(Rgb rgb, const GamutSpace& space) noexcept;
  bool keeps_inside;  // colours inside stay as they are
  std::string_view formula;
  std::string_view source;
};

inline constexpr GamutMethod kClip{"clip", gamut_clip, true, "each channel to [0, 1]",
                                   "[Shoaff 2.2.3]"};
inline constexpr GamutMethod kDesaturate{
    "desaturate", gamut_desaturate, true,
    "Oklch: largest chroma inside [0, 1] at the same lightness and hue", "[Ottosson20]"};
inline constexpr GamutMethod kCompress{
    "compress", gamut_compress, false,
    "Oklch at the same lightness and hue: chroma x of the largest above .8 to .8 + .2 z/(1 + z), "
    "z = (x - .8)/.2",
    "[Ottosson20]"};

/// Every method; the first is the default. The command line, the docs and the tests read this list.
inline constexpr std::array kGamutMethods{kClip, kDesaturate, kCompress};

}  // namespace tristim
