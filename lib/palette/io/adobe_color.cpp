#include "lib/palette/io/adobe_color.h"

#include <cmath>

#include "tristim/color/adaptation.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/core/find.h"
#include "tristim/palette/palette.h"

namespace tristim::detail {
namespace {

constexpr double kFloatError = 0.004;  // of a float in [0, 1], in codes of 16 bits

const Chromaticity& d50() {
  static const Chromaticity white = find_by_name(kWhitePoints, "d50")->chromaticity;
  return white;
}

}  // namespace

EncodedRgb color_of_lab_d50(Lab lab) {
  static const Eigen::Matrix3d rgb_from_d50 =
      rgb_from_xyz(Primaries{}) * adaptation_matrix(d50(), kD65, Adaptation::kBradford);
  const Xyz xyz = lab_to_xyz(lab, white_xyz(d50()));
  const Eigen::Vector3d light = rgb_from_d50 * Eigen::Vector3d(xyz.x, xyz.y, xyz.z);
  return {srgb_encode(light.x()), srgb_encode(light.y()), srgb_encode(light.z())};
}

EncodedRgb color_of_cmyk(Cmyk ink) noexcept {
  const double light = 1 - ink.k;
  return {(1 - ink.c) * light, (1 - ink.m) * light, (1 - ink.y) * light};
}

double nearest_code16(double channel) noexcept {
  const double code = channel * 65535;
  const double whole = std::round(code);
  return std::fabs(code - whole) <= kFloatError ? whole / 65535 : channel;
}

}  // namespace tristim::detail
