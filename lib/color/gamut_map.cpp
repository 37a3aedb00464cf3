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

// How far each channel is inside: from black and from white.
using Margins = std::array<Cubic, 6>;

Margins margins(const ChromaLine& line) noexcept {
  Margins all;
  for (std::size_t j = 0; j < 3; ++j) {
    all[j] = line.channels[j];
    for (std::size_t k = 0; k < 4; ++k) all[3 + j].c[k] = -line.channels[j].c[k];
    all[3 + j].c[0] += kWhite;
  }
  return all;
}

// The smallest part of the chroma, at most `most`, at which the colour goes outside.
double first_outside(const Margins& all, double most) noexcept {
  double t = most;
  for (const Cubic& margin : all) {
    if (!margin.surely_positive(t)) t = detail::first_outside(margin, 0, t);
  }
  return t;
}

// How far the colour at t is outside, over the sum of its channels; no colour has a sum of 0.
double depth(const ChromaLine& line, const Margins& all, double t) noexcept {
  double least = 0;
  for (const Cubic& margin : all) least = std::fmin(least, margin(t));
  double sum = 0;
  for (const Cubic& channel : line.channels) sum += channel(t);
  return least < 0 ? (sum > 0 ? -least / sum : 1) : 0;
}

// The part of the chroma, at most `most`, that stays.
//
// Next to blue the gamuts of sRGB and BT.2020 have bays: on some lines the colour goes outside,
// comes back and leaves again. Neither the first way out nor the last is continuous from line to
// line, since bays close and what lies beyond them vanishes. So places beyond the first way out
// count in proportion to how little outside they are; the clip takes that little away. The colour's
// own place counts likewise, but only in so far as there is something beyond.
double inside_part(const ChromaLine& line, double most) noexcept {
  constexpr double kBay = 1e-3;  // bays are .0007 deep in sRGB; turns hues by less than .6 degrees
  constexpr double kFar = 16;    // no bay is that wide
  const Margins all = margins(line);
  const double first = first_outside(all, most);
  if (first >= most) return most;
  const auto reach = [&](double t) {
    const double weight = 1 - depth(line, all, t) / kBay;
    return first + std::fmax(weight, 0) * (t - first);
  };
  double before = first;
  double farthest = first;
  for (const Cubic& margin : all) {
    const detail::Places places = detail::roots_and_turns(margin, first, kFar * first);
    for (int i = 0; i < places.count; ++i) {
      const double t = places.at[static_cast<std::size_t>(i)];
      farthest = std::fmax(farthest, reach(t));
      if (t < most) before = std::fmax(before, reach(t));
    }
  }
  return farthest > first ? std::fmax(before, std::fmin(reach(most), farthest)) : first;
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
  return color_at(line, inside_part(line, 1));
}

Rgb gamut_compress(Rgb rgb, const GamutSpace& space) noexcept {
  const ChromaLine line = chroma_line(rgb, space);
  if (line.lightness >= 1) return {1, 1, 1};
  if (line.lightness <= 0) return {};
  const double largest = inside_part(line, 1 / kCompressKnee);
  if (largest >= 1 / kCompressKnee) return clipped(rgb);
  const double z = (1 / largest - kCompressKnee) / (1 - kCompressKnee);
  return color_at(line, largest * (kCompressKnee + (1 - kCompressKnee) / (1 + 1 / z)));
}

}  // namespace tristim
