#include "tristim/color/macadam.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lib/color/envelope.h"
#include "tristim/color/observer.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kParallel = 1e-14;   // sine of an angle that is rounding
constexpr double kWider = 1 + 1e-12;  // so that spectral lights, rounded, are on the locus

Vector3d vector(Xyz xyz) { return {xyz.x, xyz.y, xyz.z}; }

PlanePoint point(const Vector3d& v) { return {v.x() / v.sum(), v.y() / v.sum()}; }

// A face of the body: the bands in front of the plane that i and j span with black are full, those
// behind it empty; i and j have any share.
struct Facet {
  Vector3d normal;  // outwards
  Vector3d corner;  // with i and j empty
  std::size_t i, j;
};

Facet facet_of(std::span<const Xyz> bands, const Vector3d& normal, std::size_t i, std::size_t j) {
  Facet facet{normal, Vector3d::Zero(), i, j};
  for (std::size_t k = 0; k < bands.size(); ++k) {
    if (k == i || k == j) continue;
    const Vector3d band = vector(bands[k]);
    const double height = normal.dot(band);
    const double rounding = kParallel * kParallel * normal.squaredNorm() * band.squaredNorm();
    if (height > 0 && height * height > rounding) facet.corner += band;
  }
  return facet;
}

// Both faces of every pair of bands. Two in one direction have none: they lengthen those of others.
template <typename Use>
void for_each_facet(std::span<const Xyz> bands, Use&& use) {
  for (std::size_t i = 0; i < bands.size(); ++i) {
    for (std::size_t j = i + 1; j < bands.size(); ++j) {
      const Vector3d a = vector(bands[i]);
      const Vector3d b = vector(bands[j]);
      const Vector3d normal = a.cross(b);
      if (!(normal.norm() > kParallel * a.norm() * b.norm())) continue;
      use(facet_of(bands, normal, i, j));
      use(facet_of(bands, -normal, i, j));
    }
  }
}

// How many times a colour of the plane x + y + z = 1 could be darker: 1 on the surface of the body,
// so the inverse of the limit is the greatest over all faces. Linear in x and y.
std::vector<detail::LinearFunction> face_functions(std::span<const Xyz> bands) {
  std::vector<detail::LinearFunction> functions;
  for_each_facet(bands, [&](const Facet& f) {
    const double distance = f.normal.dot(f.corner);
    if (!(distance > 0)) return;  // it bounds the cone of all lights, as the locus does
    const Vector3d n = f.normal / distance;
    functions.push_back({n.x() - n.z(), n.y() - n.z(), n.z()});
  });
  return functions;
}

// Adds the chromaticity at which the edge from p to q crosses a luminance.
void add_crossing(const Vector3d& p, const Vector3d& q, double luminance, Polygon& points) {
  const double at_p = p.y() - luminance;
  const double at_q = q.y() - luminance;
  if ((at_p < 0) == (at_q < 0)) return;
  points.push_back(point(p + (q - p) * (at_p / (at_p - at_q))));
}

// The hull of the bands' chromaticities, a little wider.
Polygon locus_of(std::span<const Xyz> bands) {
  Polygon points;
  Vector3d white = Vector3d::Zero();
  for (const Xyz& band : bands) {
    points.push_back(point(vector(band)));
    white += vector(band);
  }
  const PlanePoint centre = point(white);
  for (PlanePoint& p : points) {
    p = {centre.x + kWider * (p.x - centre.x), centre.y + kWider * (p.y - centre.y)};
  }
  return convex_hull(std::move(points));
}

std::vector<Xyz> with_white_1(std::span<const Xyz> bands) {
  double y = 0;
  for (const Xyz& band : bands) y += band.y;
  if (!(y > 0) || !std::isfinite(y)) {
    throw std::invalid_argument("bands: their luminance must be above 0 and finite");
  }
  std::vector<Xyz> relative;
  for (const Xyz& band : bands) {
    if (band.x + band.y + band.z > 0) relative.push_back({band.x / y, band.y / y, band.z / y});
  }
  return relative;
}

}  // namespace

OptimalColors::OptimalColors(std::span<const Xyz> bands)
    : bands_(with_white_1(bands)),
      faces_(std::make_unique<detail::Envelope>(face_functions(bands_), locus_of(bands_))) {}

OptimalColors::~OptimalColors() = default;
OptimalColors::OptimalColors(OptimalColors&&) noexcept = default;
OptimalColors& OptimalColors::operator=(OptimalColors&&) noexcept = default;

double OptimalColors::limit(Chromaticity c) const noexcept {
  if (std::isnan(c.x) || std::isnan(c.y)) return std::numeric_limits<double>::quiet_NaN();
  return std::min(c.y / faces_->at(c.x, c.y), 1.0);
}

bool OptimalColors::contains(Xyy color) const noexcept {
  if (color.luminance == 0) return true;
  return color.luminance > 0 && color.luminance <= limit({color.x, color.y});
}

std::vector<Chromaticity> OptimalColors::boundary(double luminance) const {
  Polygon points;
  if (luminance == 0) points = faces_->domain();
  if (luminance > 0 && luminance < 1) {
    for_each_facet(bands_, [&](const Facet& f) {
      const Vector3d i = f.corner + vector(bands_[f.i]);
      const Vector3d j = f.corner + vector(bands_[f.j]);
      const Vector3d both = i + vector(bands_[f.j]);
      add_crossing(f.corner, i, luminance, points);
      add_crossing(f.corner, j, luminance, points);
      add_crossing(i, both, luminance, points);
      add_crossing(j, both, luminance, points);
    });
  }
  std::vector<Chromaticity> boundary;
  for (const PlanePoint& p : convex_hull(std::move(points))) boundary.push_back({p.x, p.y});
  return boundary;
}

Chromaticity OptimalColors::white() const noexcept {
  Vector3d sum = Vector3d::Zero();
  for (const Xyz& band : bands_) sum += vector(band);
  return kCie1931Plane.chromaticity(point(sum));
}

OptimalColors optimal_colors(const Illuminant& illuminant) {
  const Observer& observer = observers().front();
  const std::vector<double> power = sampled(illuminant_spectrum(illuminant), kSum5nm);
  std::vector<Xyz> bands;
  for (std::size_t i = 0; i < power.size(); ++i) {
    const Xyz match = matching_functions(observer, kSum5nm.lambda_nm(i));
    bands.push_back({power[i] * match.x, power[i] * match.y, power[i] * match.z});
  }
  return OptimalColors(bands);
}

}  // namespace tristim
