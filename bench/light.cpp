// Illumination of rows, beside the loop over the double functions that everybody writes first.
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include "tristim/core/find.h"
#include "tristim/light/rows.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kSize = 4096;  // a row of a picture; stays in the cache

struct Scene {
  std::array<std::vector<float>, 9> rows;
  std::vector<Light> lights;

  explicit Scene(std::int64_t light_count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> place(-1, 1);
    for (auto& row : rows) row.resize(kSize);
    for (std::size_t i = 0; i < kSize; ++i) {
      const Vector3d n = normalize(Vector3d(place(random), place(random), place(random) + 1.2));
      for (std::size_t k = 0; k < 3; ++k) {
        rows[k][i] = static_cast<float>(place(random));
        rows[3 + k][i] = static_cast<float>(n[static_cast<Eigen::Index>(k)]);
      }
    }
    for (std::int64_t k = 0; k < light_count; ++k) {
      lights.push_back(PointLight{.position = {double(k) - 2, 1.5, 3}, .intensity = {1, 0.9, 0.8}});
    }
  }

  SurfaceRows surface() const { return {rows[0], rows[1], rows[2], rows[3], rows[4], rows[5]}; }
  LightRows light() { return {rows[6], rows[7], rows[8]}; }
  RowShading shading(const RowModel& model) const {
    return {.model = model,
            .material = {.ka = 0.1, .kd = 0.6, .ks = 0.4, .n = 37.5},
            .ambient = {0.1, 0.1, 0.1},
            .eye = {0, 0, 5},
            .lights = lights};
  }
};

void count_samples(benchmark::State& state) {
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kSize));
}

void rows(benchmark::State& state, const RowModel& model) {
  Scene scene(state.range(0));
  const RowShading shading = scene.shading(model);
  for (auto _ : state) {
    shade_rows(shading, scene.surface(), scene.light());
    benchmark::DoNotOptimize(scene.rows[6].data());
  }
  count_samples(state);
}
BENCHMARK_CAPTURE(rows, lambert, kLambertRows)->Arg(1);
BENCHMARK_CAPTURE(rows, phong, kPhongRows)->Arg(1)->Arg(4);
BENCHMARK_CAPTURE(rows, blinn_phong, kBlinnPhongRows)->Arg(1)->Arg(4);
BENCHMARK_CAPTURE(rows, cook_torrance, kCookTorranceRows)->Arg(1)->Arg(4);

// One sample after the other, in double, with the C library's pow.
void double_loop(benchmark::State& state) {
  Scene scene(state.range(0));
  const RowShading shading = scene.shading(kPhongRows);
  const Material& material = shading.material;
  for (auto _ : state) {
    for (std::size_t i = 0; i < kSize; ++i) {
      const Vector3d p(scene.rows[0][i], scene.rows[1][i], scene.rows[2][i]);
      const Vector3d n(scene.rows[3][i], scene.rows[4][i], scene.rows[5][i]);
      const Vector3d v = (shading.eye - p).normalized();
      Vector3d sum = Vector3d::Constant(material.ka * 0.1);
      for (const Light& each : scene.lights) {
        const auto& light = *std::get_if<PointLight>(&each);
        const Vector3d l = (light.position - p).normalized();
        const double nl = n.dot(l);
        if (nl <= 0) continue;
        const double rv = 2 * nl * n.dot(v) - l.dot(v);
        const double lobe = rv > 0 ? std::pow(rv, material.n) : 0;
        sum += (material.kd * nl + material.ks * lobe) *
               Vector3d(light.intensity.r, light.intensity.g, light.intensity.b);
      }
      for (std::size_t k = 0; k < 3; ++k) {
        scene.rows[6 + k][i] = static_cast<float>(sum[static_cast<Eigen::Index>(k)]);
      }
    }
    benchmark::DoNotOptimize(scene.rows[6].data());
  }
  count_samples(state);
}
BENCHMARK(double_loop)->Arg(1)->Arg(4);

void powers(benchmark::State& state) {
  Scene scene(0);
  for (float& x : scene.rows[0]) x = (x + 1) / 2;
  for (auto _ : state) {
    power_row(scene.rows[0], 37.5F, scene.rows[6]);
    benchmark::DoNotOptimize(scene.rows[6].data());
  }
  count_samples(state);
}
BENCHMARK(powers);

}  // namespace
}  // namespace tristim
