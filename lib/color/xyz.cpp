#include "tristim/color/xyz.h"

#include <limits>

namespace tristim {

Xyy xyz_to_xyy(Xyz xyz) noexcept {
  const double sum = xyz.x + xyz.y + xyz.z;
  if (sum == 0) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    return {kNone, kNone, xyz.y};
  }
  return {xyz.x / sum, xyz.y / sum, xyz.y};
}

Xyz xyy_to_xyz(Xyy xyy) noexcept {
  if (xyy.luminance == 0) return {};
  return {xyy.x * xyy.luminance / xyy.y, xyy.luminance,
          (1 - xyy.x - xyy.y) * xyy.luminance / xyy.y};
}

Xyz white_xyz(Chromaticity white) noexcept { return xyy_to_xyz({white.x, white.y, 1}); }

}  // namespace tristim
