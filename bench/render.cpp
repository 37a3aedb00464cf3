// Pictures of a sphere, beside Embree's rays where it is installed.
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "tristim/color/illuminant.h"
#include "tristim/core/find.h"
#include "tristim/light/spectral.h"
#include "tristim/render/render.h"
#ifdef TRISTIM_EMBREE
#include "tests/render/embree_mesh.h"
#endif

namespace tristim {
namespace {

constexpr int kSide = 1024;

Mesh sphere(int around, int down) {
  constexpr double kPi = 3.14159265358979323846;
  Mesh mesh;
  for (int j = 0; j <= down; ++j) {
    for (int i = 0; i < around; ++i) {
      const double theta = kPi * j / down;
      const double phi = 2 * kPi * i / around;
      mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::cos(theta),
                                  -std::sin(theta) * std::sin(phi));
    }
  }
  mesh.normals = mesh.positions;
  const auto corner = [&](int i, int j) {
    const auto index = static_cast<std::uint32_t>(j * around + i % around);
    return MeshCorner{index, index};
  };
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < around; ++i) {
      const MeshCorner a = corner(i, j);
      const MeshCorner c = corner(i + 1, j + 1);
      if (j + 1 < down) mesh.triangles.push_back({.corners = {a, corner(i, j + 1), c}});
      if (j > 0) mesh.triangles.push_back({.corners = {a, c, corner(i + 1, j)}});
    }
  }
  return mesh;
}

// 65 024 triangles, or 1 001 472: about two thirds of the picture.
Scene scene_of(bool large) {
  Scene scene;
  scene.meshes.push_back(large ? sphere(1024, 490) : sphere(256, 128));
  scene.materials.push_back({.surface = {.ka = 0.1, .kd = 0.6, .ks = 0.4, .n = 30}});
  scene.objects.emplace_back();
  scene.lights.push_back(
      {.name = "sun", .source = DirectionalLight{.to_light = {1, 1, 1}, .intensity = {1, 1, 1}}});
  scene.camera = {.eye = {0, 0, 4}, .fov_deg = 32};
  scene.picture = {.width = kSide, .height = kSide};
  return scene;
}

// The same under spectral light.
void make_spectral(Scene& scene) {
  const SpectralColor day = sampled_illuminant(*find_by_name(illuminants(), "D65"));
  scene.lights[0].spectrum = day;
  scene.ambient_spectrum = day;
  scene.materials[0].spectral = SpectralSurface{};
}

class Nowhere final : public RowSink {
 public:
  void write(ImageView<const float> rows) override { benchmark::DoNotOptimize(rows.data); }
  void finish() override {}
};

void draw(benchmark::State& state, Scene scene, const RenderOptions& options) {
  const SceneRenderer renderer(std::move(scene));
  Nowhere sink;
  for (auto _ : state) renderer.render(renderer.scene().camera, options, sink);
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
}

RenderOptions layers(std::vector<RenderLayer> names, int threads) {
  return {.layers = std::move(names), .threads = threads};
}

void depth_normals_phong(benchmark::State& state) {
  draw(state, scene_of(false),
       layers({kBeautyLayer, kNormalLayer, kDepthLayer}, static_cast<int>(state.range(0))));
}
BENCHMARK(depth_normals_phong)->Arg(1)->Arg(2)->UseRealTime()->MeasureProcessCPUTime();

void beauty(benchmark::State& state) { draw(state, scene_of(false), layers({kBeautyLayer}, 1)); }
BENCHMARK(beauty);

void spectral(benchmark::State& state) {
  Scene scene = scene_of(false);
  make_spectral(scene);
  draw(state, std::move(scene), layers({kBeautyLayer}, 1));
}
BENCHMARK(spectral);

// What is seen where, and nothing else.
void visibility(benchmark::State& state) {
  draw(state, scene_of(state.range(0) != 0), layers({kIdLayer}, 1));
}
BENCHMARK(visibility)->Arg(0)->Arg(1);

#ifdef TRISTIM_EMBREE
// One ray for each pixel, sixteen at a time; the mesh is sorted into a tree beforehand.
void embree(benchmark::State& state) {
  const Scene scene = scene_of(state.range(0) != 0);
  const EmbreeMesh tree(scene.meshes[0]);
  const float half = std::tan(16 * 3.14159265F / 180);
  alignas(64) RTCRayHit16 rays;
  alignas(64) int valid[16];
  std::fill(std::begin(valid), std::end(valid), -1);
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
  for (auto _ : state) {
    for (int y = 0; y < kSide; y += 4) {
      for (int x = 0; x < kSide; x += 4) {
        for (int k = 0; k < 16; ++k) {
          const float px = static_cast<float>(x + k % 4) + 0.5F;
          const float py = static_cast<float>(y + k / 4) + 0.5F;
          rays.ray.org_x[k] = rays.ray.org_y[k] = 0;
          rays.ray.org_z[k] = 4;
          rays.ray.dir_x[k] = (2 * px / kSide - 1) * half;
          rays.ray.dir_y[k] = (1 - 2 * py / kSide) * half;
          rays.ray.dir_z[k] = -1;
          rays.ray.tnear[k] = rays.ray.time[k] = 0;
          rays.ray.tfar[k] = INFINITY;
          rays.ray.mask[k] = ~0U;
          rays.ray.flags[k] = 0;
          rays.hit.geomID[k] = RTC_INVALID_GEOMETRY_ID;
        }
        rtcIntersect16(valid, tree.scene(), &context, &rays);
        benchmark::DoNotOptimize(rays.hit.primID[0]);
      }
    }
  }
  state.SetItemsProcessed(state.iterations() * kSide * kSide);
}
BENCHMARK(embree)->Arg(0)->Arg(1);
#endif

}  // namespace
}  // namespace tristim
