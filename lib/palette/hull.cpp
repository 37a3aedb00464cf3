#include "tristim/palette/hull.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "lib/palette/hull_rows.h"

namespace tristim {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double kFlat = 1e-7;  // thinner than any device's step of light
constexpr float kThin =
    1e-4F;  // a palette thinner than this has no volume: greys off the axis by rounding
constexpr float kRounding = 5e-7F;  // of the height of a colour in floats above a face

const Vector3d kLuminance(0.2126, 0.7152, 0.0722);

struct Face {
  Vector3d normal = Vector3d::Zero();  // unit, outwards
  double distance = 0;
};

bool same(const Face& a, const Face& b) {
  return (a.normal - b.normal).norm() < kFlat && std::abs(a.distance - b.distance) < kFlat;
}

// Adds the face with this normal through `point`, on whichever side all points are; nothing where
// they are on both.
void add_face(const std::vector<Vector3d>& points, const Vector3d& point, const Vector3d& along,
              std::vector<Face>& faces) {
  if (along.norm() < kFlat * kFlat) return;
  const Vector3d normal = along.normalized();
  double low = 0;
  double high = 0;
  for (const Vector3d& p : points) {
    const double height = normal.dot(p - point);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (high >= kFlat && low <= -kFlat) return;
  const double sign = high < kFlat ? 1 : -1;
  const Face face{sign * normal, sign * normal.dot(point)};
  const bool known =
      std::any_of(faces.begin(), faces.end(), [&](const Face& f) { return same(f, face); });
  if (!known) faces.push_back(face);
}

// Orthonormal directions that the points span about their mean: 0 to 3 of them. By the farthest
// point each time, so that it is the same on every processor.
std::vector<Vector3d> span_of(const std::vector<Vector3d>& points, const Vector3d& mean) {
  std::vector<Vector3d> basis;
  while (basis.size() < 3) {
    Vector3d farthest = Vector3d::Zero();
    for (const Vector3d& p : points) {
      Vector3d rest = p - mean;
      for (const Vector3d& b : basis) rest -= b.dot(rest) * b;
      if (rest.norm() > farthest.norm()) farthest = rest;
    }
    if (farthest.norm() < kThin) break;
    basis.push_back(farthest.normalized());
  }
  return basis;
}

// Faces of the hull within what its points span. All pairs or triples: palettes of this size are
// small.
std::vector<Face> faces_of(const std::vector<Vector3d>& points,
                           const std::vector<Vector3d>& basis) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (basis.size() == 1) add_face(points, points[i], basis[0], faces);
    for (std::size_t j = i + 1; basis.size() >= 2 && j < points.size(); ++j) {
      const Vector3d edge = points[j] - points[i];
      if (basis.size() == 2)
        add_face(points, points[i], basis[0].cross(basis[1]).cross(edge), faces);
      for (std::size_t k = j + 1; basis.size() == 3 && k < points.size(); ++k) {
        add_face(points, points[i], edge.cross(points[k] - points[i]), faces);
      }
    }
  }
  return faces;
}

// To the nearest point of what the basis spans.
Matrix3d projection(const std::vector<Vector3d>& basis) {
  Matrix3d nearest = Matrix3d::Zero();
  for (const Vector3d& b : basis) nearest += b * b.transpose();
  return nearest;
}

// To the nearest point of what the basis spans that has the same luminance: of p - c, B t with t =
// B'(p - c) - lambda a, a = B'w, w.B t = w.(p - c). Where the span has one luminance only, to the
// nearest point.
Matrix3d flattening(const Matrix3d& nearest) {
  const Vector3d slope = nearest * kLuminance;
  const double slope2 = slope.squaredNorm();
  if (slope2 < kThin) return nearest;
  return nearest + slope * (kLuminance - nearest * kLuminance).transpose() / slope2;
}

std::array<std::array<float, 3>, 3> floats(const Matrix3d& matrix) {
  std::array<std::array<float, 3>, 3> rows{};
  for (std::size_t row = 0; row < 3; ++row) {
    for (std::size_t column = 0; column < 3; ++column) {
      rows[row][column] = static_cast<float>(
          matrix(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)));
    }
  }
  return rows;
}

}  // namespace

PaletteHull::PaletteHull(std::span<const Color> entries) {
  if (entries.size() > kMost || entries.empty()) return;
  std::vector<Vector3d> points;
  Vector3d sum = Vector3d::Zero();
  for (const Color& c : entries) {
    points.emplace_back(c[0], c[1], c[2]);
    sum += points.back();
  }
  const Vector3d mean = sum / static_cast<double>(entries.size());
  centre_ = {static_cast<float>(mean.x()), static_cast<float>(mean.y()),
             static_cast<float>(mean.z())};
  const std::vector<Vector3d> basis = span_of(points, mean);
  flat_ = basis.size() < 3;
  nearest_ = floats(projection(basis));
  flatten_ = floats(flattening(projection(basis)));
  for (const Face& face : faces_of(points, basis)) {
    faces_.push_back({{static_cast<float>(face.normal.x()), static_cast<float>(face.normal.y()),
                       static_cast<float>(face.normal.z())},
                      static_cast<float>(face.distance)});
  }
}

PaletteHull::Color PaletteHull::flattened(const Color& color) const noexcept {
  if (!flat_) return color;
  Color moved = centre_;
  float off2 = 0;  // squared distance from the line or plane; what entries mix is within kThin
  for (std::size_t row = 0; row < 3; ++row) {
    float off = color[row] - centre_[row];
    for (std::size_t c = 0; c < 3; ++c) {
      const float from_centre = color[c] - centre_[c];
      off -= nearest_[row][c] * from_centre;
      moved[row] += flatten_[row][c] * from_centre;
    }
    off2 += off * off;
  }
  return off2 <= kThin * kThin ? color : moved;
}

// The first point inside on the straight way from `color` to `anchor`, which is inside.
PaletteHull::Color PaletteHull::towards(const Color& color, const Color& anchor) const noexcept {
  const auto height = [](const HalfSpace& face, const Color& c) {
    return face.n[0] * c[0] + face.n[1] * c[1] + face.n[2] * c[2] - face.d;
  };
  float part = 0;  // of the way
  for (const HalfSpace& face : faces_) {
    const float outside = height(face, color);
    const float at_anchor = std::min(height(face, anchor), 0.0F);
    // Within rounding it is inside: beside a thin edge of the hull the way in may be long.
    if (outside > kRounding) part = std::max(part, outside / (outside - at_anchor));
  }
  if (part == 0) return color;
  Color moved{};
  for (std::size_t c = 0; c < 3; ++c) moved[c] = color[c] + part * (anchor[c] - color[c]);
  return moved;
}

PaletteHull::Color PaletteHull::inside(const Color& color) const noexcept {
  if (faces_.empty()) return color;
  const Color flat = flattened(color);
  const bool mixable = std::all_of(faces_.begin(), faces_.end(), [&flat](const HalfSpace& face) {
    return face.n[0] * flat[0] + face.n[1] * flat[1] + face.n[2] * flat[2] - face.d <= kRounding;
  });
  if (mixable) return flat;
  const float grey = 0.2126F * color[0] + 0.7152F * color[1] + 0.0722F * color[2];
  return towards(flat, towards(flattened({grey, grey, grey}), centre_));
}

void PaletteHull::inside_row(const std::array<float*, 3>& planes,
                             std::size_t count) const noexcept {
  if (faces_.empty()) return;
  if (!flat_) return detail::hull_inside_row(faces_, centre_, kRounding, planes, count);
  for (std::size_t i = 0; i < count; ++i) {
    const Color moved = inside({planes[0][i], planes[1][i], planes[2][i]});
    for (std::size_t c = 0; c < 3; ++c) planes[c][i] = moved[c];
  }
}

}  // namespace tristim
