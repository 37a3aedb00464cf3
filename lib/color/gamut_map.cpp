#include "tristim/color/gamut_map.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "lib/color/cubic.h"
#include "lib/color/oklab_matrices.h"
#include "lib/core/math.h"

namespace tristim {
namespace {

using detail::Cubic;

// The published matrices leave greys 4e-8 off, so white would be outside.
constexpr double kWhite = 1 + 1e-7;

Eigen::Matrix3d matrix(const double (&m)[3][3]) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(&m[0][0]);
}

// The colours of one Oklab lightness and hue: at 0 the grey, at 1 the colour itself. The roots of
// the cone responses are linear in between, so each channel is a cubic.
struct ChromaLine {
  double lightness = 0;
  std::array<Cubic, 3> channels;
};

ChromaLine chroma_line(Rgb rgb, const GamutSpace& space) noexcept {
  static const Eigen::Vector3d grey_roots = matrix(detail::kLabFromRoots).inverse().col(0);
  const Eigen::Vector3d lms = space.lms_from_rgb * Eigen::Vector3d(rgb.r, rgb.g, rgb.b);
  const Eigen::Vector3d roots = lms.unaryExpr([](double x) { return detail::cbrt(x); });
  ChromaLine line;
  for (int i = 0; i < 3; ++i) line.lightness += detail::kLabFromRoots[0][i] * roots[i];
  const Eigen::Vector3d a = line.lightness * grey_roots;
  const Eigen::Vector3d k = roots - a;
  for (int j = 0; j < 3; ++j) {
    Cubic& p = line.channels[static_cast<std::size_t>(j)];
    for (int i = 0; i < 3; ++i) {
      const double m = space.rgb_from_lms(j, i);
      p.c[0] += m * (a[i] * a[i] * a[i]);
      p.c[1] += 3 * m * (a[i] * a[i] * k[i]);
      p.c[2] += 3 * m * (a[i] * k[i] * k[i]);
      p.c[3] += m * (k[i] * k[i] * k[i]);
    }
  }
  return line;
}

Rgb clipped(Rgb rgb) noexcept {
  const auto clip = [](double x) { return x < 0 ? 0 : x > 1 ? 1 : x; };  // NaN stays
  return {clip(rgb.r), clip(rgb.g), clip(rgb.b)};
}

// The clip takes roundings away.
Rgb color_at(const ChromaLine& line, double t) noexcept {
  return clipped({line.channels[0](t), line.channels[1](t), line.channels[2](t)});
}

// How far a channel is inside: from black and from white. Black gives way by a thousandth of the
// sum of the channels, and the clip takes it away: next to blue the gamuts of sRGB and BT.2020 have
// bays of that depth, at whose mouths neighbouring colours would part.
std::array<Cubic, 6> margins(const ChromaLine& line) noexcept {
  constexpr double kBay = 1e-3;  // .0007 in sRGB; turns hues by less than .6 degrees
  std::array<Cubic, 6> all;
  for (std::size_t k = 0; k < 4; ++k) {
    double sum = 0;
    for (const Cubic& channel : line.channels) sum += channel.c[k];
    for (std::size_t j = 0; j < 3; ++j) {
      all[j].c[k] = line.channels[j].c[k] + kBay * sum;
      all[3 + j].c[k] = (k == 0 ? kWhite : 0) - line.channels[j].c[k];
    }
  }
  return all;
}

// The largest part of the chroma, at most 1, at which the colour is inside.
double last_inside(const ChromaLine& line) noexcept {
  constexpr double kRounding = 1e-14;
  const std::array<Cubic, 6> all = margins(line);
  double t = 1;
  for (int round = 0; round < 8; ++round) {  // 1 is enough but for gamuts with bays
    const double before = t;
    for (const Cubic& margin : all) {
      if (margin(t) < -kRounding * std::fabs(margin.c[0])) t = first_inside(margin, t, 0);
    }
    if (t == before) break;
  }
  return t;
}

// The smallest part of the chroma, at most `most`, at which the colour goes outside.
double first_outside(const ChromaLine& line, double most) noexcept {
  double t = most;
  for (const Cubic& margin : margins(line)) {
    if (!margin.surely_positive(t)) t = detail::first_outside(margin, 0, t);
  }
  return t;
}

}  // namespace

GamutSpace gamut_space(const Eigen::Matrix3d& srgb_from_rgb) {
  const Eigen::Matrix3d lms = matrix(detail::kLmsFromSrgb) * srgb_from_rgb;
  return {lms, lms.inverse()};
}

GamutSpace gamut_space(const Primaries& primaries) {
  return gamut_space(rgb_from_rgb(Primaries{}, primaries, Adaptation::kBradford));
}

Rgb gamut_clip(Rgb rgb, const GamutSpace&) noexcept { return clipped(rgb); }

Rgb gamut_desaturate(Rgb rgb, const GamutSpace& space) noexcept {
  if (in_gamut(rgb)) return rgb;
  const ChromaLine line = chroma_line(rgb, space);
  if (line.lightness >= 1) return {1, 1, 1};
  if (line.lightness <= 0) return {};
  return color_at(line, last_inside(line));
}

Rgb gamut_compress(Rgb rgb, const GamutSpace& space) noexcept {
  const ChromaLine line = chroma_line(rgb, space);
  if (line.lightness >= 1) return {1, 1, 1};
  if (line.lightness <= 0) return {};
  const double largest = first_outside(line, 1 / kCompressKnee);
  if (largest >= 1 / kCompressKnee) return clipped(rgb);
  const double z = (1 / largest - kCompressKnee) / (1 - kCompressKnee);
  return color_at(line, largest * (kCompressKnee + (1 - kCompressKnee) / (1 + 1 / z)));
}

}  // namespace tristim
