#include "lib/render/world.h"

#include <Eigen/LU>
#include <stdexcept>
#include <string>
#include <utility>

#include "lib/render/cross.h"
#include "tristim/light/normals.h"
#include "tristim/light/vector.h"

namespace tristim::detail {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

[[noreturn]] void refuse(const SceneObject& object, const std::string& what) {
  throw std::invalid_argument("object '" + object.name + "': " + what);
}

std::uint32_t moved(std::uint32_t index, std::size_t by) {
  return index == kNoIndex ? kNoIndex : static_cast<std::uint32_t>(index + by);
}

// One object on its way into the world.
class Placing {
 public:
  Placing(const Scene& scene, const SceneObject& object, World& world)
      : scene_(scene), object_(object), world_(world) {
    if (object.mesh >= scene.meshes.size()) refuse(object, "names a mesh that does not exist");
    if (!object.world_from_object.allFinite()) refuse(object, "its transformation is not finite");
    first_position_ = world.positions.size();
    first_normal_ = world.normals.size();
    first_uv_ = world.uvs.size();
    linear_ = object.world_from_object.topLeftCorner<3, 3>();
    mirrored_ = linear_.determinant() < 0;
  }

  void place(const Mesh& mesh, RenderReport& report) {
    add_positions(mesh);
    add_normals(mesh);
    world_.uvs.insert(world_.uvs.end(), mesh.uvs.begin(), mesh.uvs.end());
    if (world_.positions.size() >= kNoIndex || world_.normals.size() >= kNoIndex ||
        world_.uvs.size() >= kNoIndex) {
      refuse(object_, "more than 4 billion corners");
    }
    for (const MeshTriangle& triangle : mesh.triangles) add(mesh, triangle, report);
  }

 private:
  void add_positions(const Mesh& mesh) {
    const Vector3d origin = object_.world_from_object.topRightCorner<3, 1>();
    for (const Vector3d& p : mesh.positions) {
      const Vector3d at = linear_ * p + origin;
      if (!at.allFinite()) refuse(object_, "a corner is not at a finite place");
      world_.positions.push_back(at);
    }
  }

  // Normals turn as the planes do: by the inverse's transpose, here its multiple that needs no
  // division.
  void add_normals(const Mesh& mesh) {
    Matrix3d cofactors;
    for (int i = 0; i < 3; ++i) {
      cofactors.col(i) = cross(linear_.col((i + 1) % 3), linear_.col((i + 2) % 3));
    }
    if (mirrored_) cofactors = -cofactors;
    for (const Vector3d& n : mesh.normals) {
      if (!n.allFinite()) refuse(object_, "a normal is not finite");
      world_.normals.push_back(normalize(cofactors * n));
    }
  }

  void add(const Mesh& mesh, const MeshTriangle& triangle, RenderReport& report) {
    WorldTriangle out;
    out.number = static_cast<std::uint32_t>(++report.triangles);
    out.material = object_.material.value_or(triangle.material);
    if (out.material >= scene_.materials.size()) {
      refuse(object_, "names a material that does not exist");
    }
    for (std::size_t i = 0; i < 3; ++i) set_corner(mesh, triangle.corners[i], out, i);
    if (mirrored_) {
      std::swap(out.position[1], out.position[2]);
      std::swap(out.normal[1], out.normal[2]);
      std::swap(out.uv[1], out.uv[2]);
    }
    if (face_normal(world_, out).isZero(0)) {
      ++report.degenerate;
    } else {
      world_.triangles.push_back(out);
    }
  }

  void set_corner(const Mesh& mesh, const MeshCorner& corner, WorldTriangle& out, std::size_t i) {
    const auto inside = [](std::uint32_t index, std::size_t size) {
      return index == kNoIndex || index < size;
    };
    if (corner.position >= mesh.positions.size() || !inside(corner.normal, mesh.normals.size()) ||
        !inside(corner.uv, mesh.uvs.size())) {
      refuse(object_, "a triangle names a corner that does not exist");
    }
    out.position[i] = moved(corner.position, first_position_);
    out.normal[i] = moved(corner.normal, first_normal_);
    out.uv[i] = moved(corner.uv, first_uv_);
    const bool no_direction = out.normal[i] != kNoIndex && world_.normals[out.normal[i]].isZero(0);
    if (no_direction) out.normal[i] = kNoIndex;
  }

  const Scene& scene_;
  const SceneObject& object_;
  World& world_;
  std::size_t first_position_, first_normal_, first_uv_;
  Matrix3d linear_;
  bool mirrored_;
};

}  // namespace

World world_of(const Scene& scene, RenderReport& report) {
  World world;
  for (const SceneObject& object : scene.objects) {
    Placing(scene, object, world).place(scene.meshes[object.mesh], report);
  }
  return world;
}

Vector3d face_normal(const World& world, const WorldTriangle& triangle) noexcept {
  const Vector3d& p0 = world.positions[triangle.position[0]];
  const Vector3d& p1 = world.positions[triangle.position[1]];
  const Vector3d& p2 = world.positions[triangle.position[2]];
  const Vector3d a = p1 - p0;
  const Vector3d b = p2 - p0;
  const Vector3d across = cross(a, b);
  // Rounding alone may leave a direction where the corners lie on a line.
  if (dot(across, across) > 1e-20 * dot(a, a) * dot(b, b)) return normalize(across);
  return three_point_normal(p0, p1, p2);
}

}  // namespace tristim::detail
