#include <array>

#include "lib/render/shape_makers.h"

namespace tristim::detail {
namespace {

using Eigen::Vector3d;

void add_quad(PolygonModel& model, std::array<std::uint32_t, 4> positions) {
  std::array<MeshCorner, 4> corners;
  for (std::size_t i = 0; i < 4; ++i) corners[i].position = positions[i];
  add_face(model, corners);
}

// Six faces on eight corners: those of the bottom, then those of the top, each from the left back
// round over the front.
PolygonModel hexahedron(const Vector3d& bottom_half, const Vector3d& top_half) {
  PolygonModel model;
  for (const Vector3d& half : {bottom_half, top_half}) {
    model.positions.insert(model.positions.end(), {{-half.x(), half.y(), -half.z()},
                                                   {-half.x(), half.y(), half.z()},
                                                   {half.x(), half.y(), half.z()},
                                                   {half.x(), half.y(), -half.z()}});
  }
  add_quad(model, {4, 5, 6, 7});
  for (std::uint32_t side = 0; side < 4; ++side) {
    const std::uint32_t next = (side + 1) % 4;
    add_quad(model, {side, next, next + 4, side + 4});
  }
  add_quad(model, {3, 2, 1, 0});
  return model;
}

// A grid of quads over the x-z plane, whose rows run to the front.
PolygonModel grid(double width, double depth, int columns, int rows,
                  double (*height)(int column, double most), double most) {
  PolygonModel model;
  for (int row = 0; row <= rows; ++row) {
    for (int column = 0; column <= columns; ++column) {
      const double u = static_cast<double>(column) / columns;
      const double v = static_cast<double>(row) / rows;
      model.positions.emplace_back((u - 0.5) * width, height(column, most), (v - 0.5) * depth);
      model.uvs.push_back({static_cast<float>(u), static_cast<float>(1 - v)});
    }
  }
  const auto corner = [&](int column, int row) {
    const auto place = static_cast<std::uint32_t>(row * (columns + 1) + column);
    return MeshCorner{place, kNoIndex, place};
  };
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      add_face(model, std::array{corner(column, row), corner(column, row + 1),
                                 corner(column + 1, row + 1), corner(column + 1, row)});
    }
  }
  return model;
}

}  // namespace

PolygonModel box(ShapeValues values) {
  const Vector3d half(values[0] / 2, values[1] / 2, values[2] / 2);
  return hexahedron({half.x(), -half.y(), half.z()}, half);
}

PolygonModel plane(ShapeValues values) {
  return grid(
      values[0], values[1], static_cast<int>(values[2]), static_cast<int>(values[3]),
      [](int, double) { return 0.0; }, 0);
}

// The truncated pyramid of [Shoaff 4.3] with its top upwards. Its planes have the lengths that the
// notes give them: (0, 1, 0) for the top, one more beside 1 for the sides.
PolygonModel pyramid(ShapeValues values) {
  const double bottom = values[0] / 2;
  const double top = values[1] / 2;
  const double height = values[2];
  PolygonModel model = hexahedron({bottom, 0, bottom}, {top, height, top});
  const double rise = (bottom - top) / height;  // of a side's normal, its way outwards being 1
  model.planes = {{0, 1, 0}, {-1, rise, 0}, {0, rise, 1}, {1, rise, 0}, {0, rise, -1}, {0, -1, 0}};
  return model;
}

// Folds whose averaged normals are all upright [Shoaff 4.3].
PolygonModel corrugation(ShapeValues values) {
  return grid(
      values[0], values[1], 2 * static_cast<int>(values[3]), 1,
      [](int column, double most) { return column % 2 == 0 ? 0.0 : most; }, values[2]);
}

}  // namespace tristim::detail
