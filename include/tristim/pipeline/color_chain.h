#pragma once

#include <array>
#include <vector>

#include "tristim/color/lab.h"
#include "tristim/color/rgb.h"
#include "tristim/pipeline/chain.h"

namespace tristim {

/// How a display of levels, not of a palette, turns light into what drives its channels, before it
/// is rounded to a code.
class DisplayDrive {
 public:
  /// Throws Error (kMisuse) where the display has a palette or inks: then no curve leads from light
  /// to codes.
  DisplayDrive(const Display& display, BlackPoint black_point);

  /// Linear light of the display's primaries to codes over the highest, [0, 1]; of a display of
  /// greys its luminance, three times. Of intensity levels the codes of the response between them.
  EncodedRgb drive(Rgb light) const noexcept;

  /// Back from codes over the highest to the picture's light.
  Rgb picture(EncodedRgb drive) const noexcept;

  /// The light that such codes make, relative to the white, [0, 1].
  Rgb light(EncodedRgb drive) const noexcept;

 private:
  std::array<Response, 3> response_;
  std::array<double, 3> code_max_;
  std::array<double, 3> black_;  // the light that picture black becomes; 0 where it is absolute
  bool grey_;
  Eigen::RowVector3d luminance_;
};

/// What process makes of one colour of a picture, in double and before it is rounded to a code.
class ColorChain {
 public:
  /// `picture`: of the light that comes in. Throws as DisplayDrive does.
  ColorChain(const Primaries& picture, const Display& display, const Settings& settings);

  /// Light of the picture to codes over the highest.
  EncodedRgb operator()(Rgb light) const;

  /// What codes over the highest look like: L*a*b* of the light that they make, relative to the
  /// display's white.
  Lab appearance(EncodedRgb drive) const noexcept;

  const std::vector<Stage>& stages() const noexcept { return stages_; }

 private:
  std::vector<Stage> stages_;
  DisplayDrive drive_;
  Eigen::Matrix3d xyz_from_light_;
  Xyz white_;
};

}  // namespace tristim
