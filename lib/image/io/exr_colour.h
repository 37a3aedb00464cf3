#pragma once

#include <Eigen/Core>
#include <optional>
#include <string>

#include "lib/image/io/exr_channels.h"

namespace tristim::detail {

/// What the stored numbers of an EXR file mean.
struct ExrColour {
  Primaries primaries;  // of the light delivered
  std::optional<Eigen::Matrix3d>
      delivered;      // delivered RGB from stored RGB or XYZ; none: as stored
  std::string words;  // where that comes from
};

/// The white is `adoptedNeutral`, else that of `chromaticities`; files without either have sRGB's
/// primaries, XYZ-encoded ones (channels X Y Z, or primaries 1,0 0,1 0,0, whose E is no white) are
/// made linear sRGB under D65. An adopted neutral keeps every colour's XYZ: RGB are rescaled so
/// that (1, 1, 1) is it. Throws Error (kContent) where the chromaticities make no colours.
ExrColour exr_colour(const std::string& name, const ExrPart& part, ExrColourModel model);

/// Stored to delivered colours, in place: `pixels` of `channels` samples each. Sums in a fixed
/// order, so that the bits do not depend on who compiled it.
void convert_pixels(const Eigen::Matrix3d& delivered, int pixels, int channels,
                    float* samples) noexcept;

}  // namespace tristim::detail
