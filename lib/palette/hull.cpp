#include "tristim/palette/hull.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cstddef>

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kFlat = 1e-7;  // thinner than any device's step of light

struct Face {
  Vector3d normal = Vector3d::Zero();  // unit, outwards
  double distance = 0;
};

bool same(const Face& a, const Face& b) {
  return (a.normal - b.normal).norm() < kFlat && std::abs(a.distance - b.distance) < kFlat;
}

// The plane of three entries where all others lie on one side of it.
enum class Side { kNone, kFace, kFlatHull };

Side face_through(const std::vector<Vector3d>& points, std::size_t i, std::size_t j, std::size_t k,
                  Face& face) {
  const Vector3d cross = (points[j] - points[i]).cross(points[k] - points[i]);
  if (cross.norm() < kFlat * kFlat) return Side::kNone;
  const Vector3d normal = cross.normalized();
  double low = 0;
  double high = 0;
  for (const Vector3d& p : points) {
    const double height = normal.dot(p - points[i]);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  if (high < kFlat && low > -kFlat) return Side::kFlatHull;
  if (high >= kFlat && low <= -kFlat) return Side::kNone;
  const double sign = high < kFlat ? 1 : -1;
  face = {sign * normal, sign * normal.dot(points[i])};
  return Side::kFace;
}

// Every face once; none where the hull has no volume. All triples: palettes of this size are small.
std::vector<Face> faces_of(const std::vector<Vector3d>& points) {
  std::vector<Face> faces;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      for (std::size_t k = j + 1; k < points.size(); ++k) {
        Face face;
        const Side side = face_through(points, i, j, k, face);
        if (side == Side::kFlatHull) return {};
        const bool known =
            std::any_of(faces.begin(), faces.end(), [&](const Face& f) { return same(f, face); });
        if (side == Side::kFace && !known) faces.push_back(face);
      }
    }
  }
  return faces;
}

}  // namespace

PaletteHull::PaletteHull(std::span<const Color> entries) {
  if (entries.size() > kMost) return;
  std::vector<Vector3d> points;
  Vector3d sum = Vector3d::Zero();
  for (const Color& c : entries) {
    points.emplace_back(c[0], c[1], c[2]);
    sum += points.back();
  }
  for (const Face& face : faces_of(points)) {
    faces_.push_back({{static_cast<float>(face.normal.x()), static_cast<float>(face.normal.y()),
                       static_cast<float>(face.normal.z())},
                      static_cast<float>(face.distance)});
  }
  const Vector3d mean = sum / static_cast<double>(entries.size());
  centre_ = {static_cast<float>(mean.x()), static_cast<float>(mean.y()),
             static_cast<float>(mean.z())};
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
    if (outside > 0) part = std::max(part, outside / (outside - at_anchor));
  }
  if (part == 0) return color;
  Color moved{};
  for (std::size_t c = 0; c < 3; ++c) moved[c] = color[c] + part * (anchor[c] - color[c]);
  return moved;
}

PaletteHull::Color PaletteHull::inside(const Color& color) const noexcept {
  if (faces_.empty()) return color;
  const float grey = 0.2126F * color[0] + 0.7152F * color[1] + 0.0722F * color[2];
  return towards(color, towards({grey, grey, grey}, centre_));
}

}  // namespace tristim
