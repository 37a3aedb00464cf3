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

using Locus = std::array<Chromaticity, kPoints>;

Locus make_locus() {
  Locus locus;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const Xyz bar = matching_functions(observers()[0], kLocusFirstNm + static_cast<int>(i));
    const double total = bar.x + bar.y + bar.z;
    locus[i] = {bar.x / total, bar.y / total};
  }
  return locus;
}

const Locus& locus_points() {
  static const Locus locus = make_locus();
  return locus;
}

// Where a ray from the white leaves the diagram: the point relative to the white, and its
// wavelength, or nothing on the purple line.
struct Exit {
  Vector point;
  std::optional<double> lambda_nm;
};

// Where the ray from the origin along `ray` crosses the segment from a to b, which follow one
// another clockwise: the share of b, [0, 1]. Nothing elsewhere.
std::optional<double> crossing(Vector ray, Vector a, Vector b) {
  const double before = cross(a, ray);
  const double behind = cross(b, ray);
  if (!(before <= 0 && behind >= 0 && before < behind)) return std::nullopt;
  return before / (before - behind);
}

Vector between(Vector a, Vector b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

std::optional<Exit> exit_of(Chromaticity white, Vector ray) {
  const Locus& locus = locus_points();
  Vector a = locus[0] - white;
  for (std::size_t i = 0; i + 1 < kPoints; ++i) {
    const Vector b = locus[i + 1] - white;
    if (const auto t = crossing(ray, a, b)) {
      return Exit{between(a, b, *t), kLocusFirstNm + static_cast<double>(i) + *t};
    }
    a = b;
  }
  const Vector violet = locus[0] - white;
  if (const auto t = crossing(ray, a, violet)) return Exit{between(a, violet, *t), {}};
  return std::nullopt;
}

}  // namespace

DominantWavelength dominant_wavelength(Chromaticity color, Chromaticity white) noexcept {
  const Vector ray = color - white;
  if (std::fabs(ray.x) <= kSameColor && std::fabs(ray.y) <= kSameColor) return {kNaN, kNaN, 0, 0};
  const auto exit = exit_of(white, ray);
  const auto opposite = exit_of(white, {-ray.x, -ray.y});
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
    const auto purple = exit_of(white, {-end.x, -end.y});
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
