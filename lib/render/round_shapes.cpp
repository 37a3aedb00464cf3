#include <array>
#include <map>
#include <utility>

#include "lib/core/trigonometry.h"
#include "lib/render/lathe.h"
#include "lib/render/shape_makers.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

int whole(double value) noexcept { return static_cast<int>(value); }

// A flat disc: facing up it runs outwards, facing down inwards.
ProfileStrip disc_up(double radius, double y) { return {{0, y, 0, 1}, {radius, y, 0, 1}}; }
ProfileStrip disc_down(double radius, double y) { return {{radius, y, 0, -1}, {0, y, 0, -1}}; }

// A line from one point of a profile to another.
ProfileStrip line(const ProfilePoint& from, const ProfilePoint& to, int steps) {
  ProfileStrip strip;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    const bool end = i == steps;  // exactly, so that the next strip finds it
    strip.push_back({end ? to.r : (1 - t) * from.r + t * to.r,
                     end ? to.y : (1 - t) * from.y + t * to.y, to.normal_r, to.normal_y});
  }
  return strip;
}

// y = top - drop (r/radius)^2, from the top to the rim.
ProfileStrip parabola(double radius, double top, double drop, int rows) {
  ProfileStrip strip;
  for (int i = 0; i <= rows; ++i) {
    const double r = i == rows ? radius : radius * i / rows;
    const double part = static_cast<double>(i) / rows;
    strip.push_back({r, top - drop * part * part, 2 * drop * part / radius, 1});
  }
  return strip;
}

// A vertex in the middle of an edge of the icosahedron, made once.
class Icosphere {
 public:
  Icosphere() {
    const double kGolden = (1 + std::sqrt(5.0)) / 2;
    for (const double a : {-1.0, 1.0}) {
      for (const double b : {-kGolden, kGolden}) {
        add(Vector3d(0, a, b));
        add(Vector3d(a, b, 0));
        add(Vector3d(b, 0, a));
      }
    }
    const double kEdge = 1.1;  // squares of edges of the unit icosahedron are 1.106
    for (std::uint32_t a = 0; a < 12; ++a) {
      for (std::uint32_t b = a + 1; b < 12; ++b) {
        for (std::uint32_t c = b + 1; c < 12; ++c) {
          if (near(a, b, kEdge) && near(b, c, kEdge) && near(c, a, kEdge)) add_outward({a, b, c});
        }
      }
    }
  }

  void divide() {
    std::vector<std::array<std::uint32_t, 3>> finer;
    for (const auto& [a, b, c] : triangles_) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    triangles_ = std::move(finer);
  }

  PolygonModel model(double radius) const {
    PolygonModel model;
    model.normals = points_;
    for (const Vector3d& p : points_) model.positions.push_back(radius * p);
    for (const auto& triangle : triangles_) {
      std::array<MeshCorner, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) corners[i] = {triangle[i], triangle[i], kNoIndex};
      add_face(model, corners);
    }
    return model;
  }

 private:
  void add(const Vector3d& direction) { points_.push_back(normalize(direction)); }

  bool near(std::uint32_t a, std::uint32_t b, double squared) const {
    const Vector3d way = points_[a] - points_[b];
    return dot(way, way) < squared + 0.1;
  }

  void add_outward(std::array<std::uint32_t, 3> triangle) {
    const Vector3d& a = points_[triangle[0]];
    if (dot(three_point_normal(a, points_[triangle[1]], points_[triangle[2]]), a) < 0) {
      std::swap(triangle[1], triangle[2]);
    }
    triangles_.push_back(triangle);
  }

  std::uint32_t middle(std::uint32_t a, std::uint32_t b) {
    const auto [found, is_new] =
        middles_.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(points_.size()));
    if (is_new) add(points_[a] + points_[b]);
    return found->second;
  }

  std::vector<Vector3d> points_;
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles_;
};

}  // namespace

PolygonModel sphere(ShapeValues values) {
  const double radius = values[0];
  const int rows = whole(values[2]);
  ProfileStrip strip;
  for (int i = 0; i <= rows; ++i) {
    const SineCosine angle = sine_cosine_deg(180.0 * i / rows);
    strip.push_back({radius * angle.sine, radius * angle.cosine, angle.sine, angle.cosine});
  }
  return lathe(std::array{strip}, whole(values[1]));
}

PolygonModel icosphere(ShapeValues values) {
  Icosphere work;
  for (int i = 0; i < whole(values[1]); ++i) work.divide();
  return work.model(values[0]);
}

PolygonModel cylinder(ShapeValues values) {
  const double radius = values[0];
  const double half = values[1] / 2;
  const ProfileStrip side = line({radius, half}, {radius, -half, 1, 0}, whole(values[3]));
  return lathe(std::array{disc_up(radius, half), side, disc_down(radius, -half)}, whole(values[2]));
}

PolygonModel cone(ShapeValues values) {
  const double radius = values[0];
  const double half = values[1] / 2;
  const ProfileStrip side = line({0, half}, {radius, -half, values[1], radius}, whole(values[3]));
  return lathe(std::array{side, disc_down(radius, -half)}, whole(values[2]));
}

PolygonModel paraboloid(ShapeValues values) {
  const double half = values[1] / 2;
  const ProfileStrip side = parabola(values[0], half, values[1], whole(values[3]));
  ProfileStrip bottom = disc_down(values[0], side.back().y);
  return lathe(std::array{side, bottom}, whole(values[2]));
}

PolygonModel torus(ShapeValues values) {
  const double tube = values[1];
  const int rows = whole(values[3]);
  ProfileStrip strip;
  for (int i = 0; i <= rows; ++i) {
    const SineCosine angle = sine_cosine_deg(360.0 * (i % rows) / rows);
    strip.push_back({values[0] + tube * angle.sine, tube * angle.cosine, angle.sine, angle.cosine});
  }
  return lathe(std::array{strip}, whole(values[2]));
}

// The quadric of the third figure: y = -(x^2 + z^2)/(2 a^2), so that the normal is along
// (x/a^2, 1, z/a^2); its rim goes down as a skirt.
PolygonModel cap(ShapeValues values) {
  const double radius = values[0];
  const ProfileStrip dome = parabola(radius, 0, 0.5, whole(values[3]));
  if (values[1] == 0) return lathe(std::array{dome}, whole(values[2]));
  const ProfileStrip skirt =
      line({radius, dome.back().y}, {radius, dome.back().y - values[1], 1, 0}, 1);
  return lathe(std::array{dome, skirt}, whole(values[2]));
}

}  // namespace tristim::detail
