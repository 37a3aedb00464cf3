#pragma once

#include "tristim/color/munsell.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"

namespace tristim {

/// A colour of sRGB as Munsell sees it under illuminant C.
inline Munsell srgb_munsell(int red, int green, int blue) {
  static const Eigen::Matrix3d matrix =
      adaptation_matrix(kD65, kMunsellWhite, Adaptation::kBradford) * xyz_from_rgb(Primaries{});
  const Eigen::Vector3d xyz =
      matrix * Eigen::Vector3d(srgb_decode(red / 255.0), srgb_decode(green / 255.0),
                               srgb_decode(blue / 255.0));
  return xyy_to_munsell(xyz_to_xyy({xyz.x(), xyz.y(), xyz.z()}));
}

}  // namespace tristim
