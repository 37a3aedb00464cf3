#include "tristim/color/wavelength.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

#include "tristim/color/observer.h"

namespace tristim {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPoints = kLocusLastNm - kLocusFirstNm + 1;

// The white itself, but for the rounding of a matrix and a division.
constexpr double kSameColor = 4e-15;

struct Vector {
  double x, y;
};

Vector operator-(Chromaticity a, Chromaticity b) { return {a.x - b.x, a.y - b.y}; }
double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }

using Locus = std::array<Chromaticity, kPoints + 1>;  // ends where it begins: the purple line

Locus make_locus() {
  Locus locus;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Xyz bar = matching_functions(observers()[0], kLocusFirstNm + static_cast<int>(i));
    const double total = bar.x + bar.y + bar.z;
    locus[i] = {bar.x / total, bar.y / total};
  }
  locus[kPoints] = locus[0];
  return locus;
}

const Locus& locus_points() {
  static const Locus locus = make_locus();
  return locus;
}

// Where a line through the white leaves the diagram: the point relative to the white, and its
// wavelength, or nothing on the purple line.
struct Exit {
  Vector point;
  std::optional<double> lambda_nm;
};

// The exits along a ray from the white and against it; nothing where a white outside the diagram
// has none.
struct Exits {
  std::optional<Exit> ahead, behind;
};

// The point at share t of the way from a, the locus' point i, to b.
Exit exit_at(std::size_t i, Vector a, Vector b, double t) {
  const Vector point{a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
  if (i + 1 == kPoints) return {point, {}};
  return {point, kLocusFirstNm + static_cast<double>(i) + t};
}

Exits exits_of(Chromaticity white, Vector ray) {
  const Locus& locus = locus_points();
  Exits exits;
  Vector a = locus[0] - white;
  double from = cross(a, ray);
  // The locus and the purple line run clockwise: they cross the ray from its left to its right.
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Vector b = locus[i + 1] - white;
    const double to = cross(b, ray);
    if (!(from * to > 0) && from != to) {
      auto& exit = from < to ? exits.ahead : exits.behind;
      if (!exit) exit = exit_at(i, a, b, from / (from - to));
    }
    a = b;
    from = to;
  }
  return exits;
}

}  // namespace

DominantWavelength dominant_wavelength(Chromaticity color, Chromaticity white) noexcept {
  const Vector ray = color - white;
  if (std::fabs(ray.x) <= kSameColor && std::fabs(ray.y) <= kSameColor) return {kNaN, kNaN, 0, 0};
  const auto [exit, opposite] = exits_of(white, ray);
  // A white outside the diagram sees parts of the locus run backwards, and cross behind it.
  if (!exit || !(dot(ray, exit->point) > 0)) return {kNaN, kNaN, kNaN, kNaN};
  const double complementary = opposite && opposite->lambda_nm ? *opposite->lambda_nm : kNaN;
  const double purity = dot(ray, ray) / dot(ray, exit->point);
  if (!exit->lambda_nm) return {-complementary, kNaN, purity, kNaN};
  const double locus_y = white.y + exit->point.y;
  return {*exit->lambda_nm, complementary, purity, purity * locus_y / color.y};
}

Chromaticity chromaticity_of_wavelength(double dominant_nm, double excitation_purity,
                                        Chromaticity white) noexcept {
  if (excitation_purity == 0) return white;
  Vector end = spectral_locus(std::fabs(dominant_nm)) - white;
  if (dominant_nm < 0) {
    const auto purple = exits_of(white, end).behind;
    if (!purple || purple->lambda_nm) return {kNaN, kNaN};
    end = purple->point;
  }
  return {white.x + excitation_purity * end.x, white.y + excitation_purity * end.y};
}

Chromaticity spectral_locus(double lambda_nm) noexcept {
  if (!(lambda_nm >= kLocusFirstNm && lambda_nm <= kLocusLastNm)) return {kNaN, kNaN};
  const double place = lambda_nm - kLocusFirstNm;
  const auto i = std::min(static_cast<std::size_t>(place), kPoints - 2);
  const double t = place - static_cast<double>(i);
  const Locus& locus = locus_points();
  return {(1 - t) * locus[i].x + t * locus[i + 1].x, (1 - t) * locus[i].y + t * locus[i + 1].y};
}

}  // namespace tristim
