#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <map>
#include <tuple>

#include "lib/render/shape_makers.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

constexpr double kPatches[] = {
#include "luts/teapot_patches.csv"
};
constexpr std::size_t kPatchNumbers = 48;  // 16 points
constexpr std::size_t kPatchCount = std::size(kPatches) / kPatchNumbers;
constexpr std::size_t kQuarters = 6;  // patches that are mirrored in x too

using Patch = std::array<std::array<Vector3d, 4>, 4>;

// The control points of a patch, mirrored or not. A mirrored patch is turned inside out, so its
// rows run the other way.
Patch patch_of(std::size_t number, bool mirror_x, bool mirror_y) {
  const double* at = kPatches + number * kPatchNumbers;
  Patch patch;
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t i = 0; i < 4; ++i, at += 3) {
      const std::size_t column = mirror_x != mirror_y ? 3 - i : i;
      patch[row][column] = {mirror_x ? -at[0] : at[0], mirror_y ? -at[1] : at[1], at[2]};
    }
  }
  return patch;
}

// de Casteljau's construction: the point at t and, times 1/3, the derivative.
struct CurvePoint {
  Vector3d at, along;
};
CurvePoint curve(std::array<Vector3d, 4> p, double t) {
  for (std::size_t left = 3; left > 1; --left) {
    for (std::size_t i = 0; i < left; ++i) p[i] = (1 - t) * p[i] + t * p[i + 1];
  }
  return {(1 - t) * p[0] + t * p[1], p[1] - p[0]};
}

struct SurfacePoint {
  Vector3d at, normal;
};

SurfacePoint surface(const Patch& patch, double u, double v) {
  std::array<Vector3d, 4> points;
  std::array<Vector3d, 4> along_rows;
  for (std::size_t row = 0; row < 4; ++row) {
    const CurvePoint p = curve(patch[row], u);
    points[row] = p.at;
    along_rows[row] = p.along;
  }
  const CurvePoint across = curve(points, v);
  return {across.at, normalize(curve(along_rows, v).at.cross(across.along))};
}

// Where a row of control points is one point, as on the lid and the bottom, the patch has no
// tangents: the normal a little way inwards is taken, which is upright by symmetry.
Vector3d normal_at(const Patch& patch, double u, double v) {
  const Vector3d normal = surface(patch, u, v).normal;
  if (normal != Vector3d(0, 0, 0)) return normal;
  const Vector3d inwards = surface(patch, u, 1e-6).normal;
  return {0, 0, inwards.z() < 0 ? -1.0 : 1.0};
}

class Builder {
 public:
  explicit Builder(int steps) : steps_(steps) {}

  void add(const Patch& patch) {
    std::vector<MeshCorner> grid;
    for (int row = 0; row <= steps_; ++row) {
      for (int column = 0; column <= steps_; ++column) {
        grid.push_back(
            corner(patch, static_cast<double>(column) / steps_, static_cast<double>(row) / steps_));
      }
    }
    const auto place = [&](int column, int row) {
      return grid[static_cast<std::size_t>(row * (steps_ + 1) + column)];
    };
    for (int row = 0; row < steps_; ++row) {
      for (int column = 0; column < steps_; ++column) {
        add_quad({place(column, row), place(column + 1, row), place(column + 1, row + 1),
                  place(column, row + 1)});
      }
    }
  }

  PolygonModel take() { return std::move(model_); }

 private:
  // Neighbouring patches have the same points on their common edge but for rounding: equal to 1e-9,
  // they are one vertex.
  std::uint32_t position(const Vector3d& p) {
    const auto near = [](double x) { return std::lround(x * 1e9); };
    const auto [found, is_new] =
        positions_.try_emplace({near(p.x()), near(p.y()), near(p.z())},
                               static_cast<std::uint32_t>(model_.positions.size()));
    if (is_new) model_.positions.push_back({p.x(), p.z(), -p.y()});  // y up
    return found->second;
  }

  MeshCorner corner(const Patch& patch, double u, double v) {
    const auto number = static_cast<std::uint32_t>(model_.normals.size());
    const Vector3d normal = normal_at(patch, u, v);
    model_.normals.emplace_back(normal.x(), normal.z(), -normal.y());
    model_.uvs.push_back({static_cast<float>(u), static_cast<float>(v)});
    return {position(surface(patch, u, v).at), number, number};
  }

  // Without the side that is one point.
  void add_quad(std::array<MeshCorner, 4> quad) {
    std::vector<MeshCorner> corners;
    for (std::size_t i = 0; i < 4; ++i) {
      if (quad[i].position != quad[(i + 1) % 4].position) corners.push_back(quad[i]);
    }
    if (corners.size() > 2) add_face(model_, corners);
  }

  int steps_;
  PolygonModel model_;
  std::map<std::tuple<long, long, long>, std::uint32_t> positions_;
};

}  // namespace

PolygonModel teapot(ShapeValues steps) {
  Builder builder(static_cast<int>(steps[0]));
  for (std::size_t number = 0; number < kPatchCount; ++number) {
    for (const bool mirror_x : {false, true}) {
      if (mirror_x && number >= kQuarters) continue;
      for (const bool mirror_y : {false, true}) {
        builder.add(patch_of(number, mirror_x, mirror_y));
      }
    }
  }
  return builder.take();
}

}  // namespace tristim::detail
