// Rays through the pixels' centres by a library of its own.
#ifdef TRISTIM_EMBREE
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/render/embree_mesh.h"
#include "tests/render/scenes.h"

namespace tristim {
namespace {

Mesh random_triangles(int count) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(-1, 1);
  std::uniform_real_distribution<double> away(-0.4, 0.4);
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const Eigen::Vector3d middle(place(random), place(random), place(random));
    MeshTriangle triangle;
    for (MeshCorner& corner : triangle.corners) {
      corner.position = static_cast<std::uint32_t>(mesh.positions.size());
      const Eigen::Vector3d p = middle + Eigen::Vector3d(away(random), away(random), away(random));
      mesh.positions.push_back(p.cast<float>().cast<double>());  // as Embree has them
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

class Rays {
 public:
  explicit Rays(const Mesh& mesh) : mesh_(mesh, RTC_SCENE_FLAG_ROBUST) {}

  // The number of the first triangle, from 1; 0 for none.
  unsigned first_hit(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(from.x());
    ray.ray.org_y = static_cast<float>(from.y());
    ray.ray.org_z = static_cast<float>(from.z());
    ray.ray.dir_x = static_cast<float>(along.x());
    ray.ray.dir_y = static_cast<float>(along.y());
    ray.ray.dir_z = static_cast<float>(along.z());
    ray.ray.tfar = INFINITY;
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(mesh_.scene(), &context, &ray);
    return ray.hit.geomID == RTC_INVALID_GEOMETRY_ID ? 0 : ray.hit.primID + 1;
  }

 private:
  EmbreeMesh mesh_;
};

TEST(RenderScene, SeesWhatEmbreesRaysMeet) {
  constexpr int kSide = 300;
  Scene scene = test_scene(random_triangles(200));
  scene.materials[0].two_sided = true;
  scene.camera = {.eye = {0, 0, 4}, .fov_deg = 90};
  scene.picture = {.width = kSide, .height = kSide};
  const Rendered picture = rendered(scene, {.layers = {kIdLayer}});
  const Rays rays(scene.meshes[0]);
  int different = 0;
  int hit = 0;
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const Eigen::Vector3d along((2 * x + 1.0) / kSide - 1, 1 - (2 * y + 1.0) / kSide, -1);
      const unsigned expected = rays.first_hit(scene.camera.eye, along);
      hit += expected != 0 ? 1 : 0;
      different += picture.at(x, y, 0) != static_cast<float>(expected) ? 1 : 0;
    }
  }
  EXPECT_GT(hit, 5000);
  EXPECT_LE(different, 3);  // its rays are in single precision
}

}  // namespace
}  // namespace tristim
#endif
