#include "tristim/render/spheres.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <vector>

#include "tristim/image/memory.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

std::vector<float> rendered(const SphereScene& scene, const SpheresOptions& options) {
  ImageSink sink(options.width, options.height, spheres_info(options).channels);
  render_spheres(scene, options, sink);
  sink.finish();
  std::vector<float> samples;
  const ImageView<const float> image = sink.image().view();
  for (int y = 0; y < image.height; ++y) {
    const auto row = image.row(y);
    samples.insert(samples.end(), row.begin(), row.end());
  }
  return samples;
}

double luminance(const float* rgb) {
  return 0.2126 * double{rgb[0]} + 0.7152 * double{rgb[1]} + 0.0722 * double{rgb[2]};
}

// One sphere on the ground's origin, seen from the front; nothing but what the test adds gives
// light.
SphereScene lone_sphere() {
  SphereScene scene;
  scene.camera = {.eye = {0, 1, 8}, .target = {0, 1, 0}, .view_width = 0.5, .view_height = 0.5};
  scene.spheres = {{.centre = {0, 1, 0},
                    .radius = 1,
                    .material = {.kd = 0.5, .ks = 0.25, .n = 7, .od = {1, 0.5, 0.25}}}};
  return scene;
}

TEST(RenderSpheres, ThreadsDoNotCount) {
  for (int height : {1, 37, 64, 131}) {
    SCOPED_TRACE(height);
    const SphereScene scene = default_scene();
    const auto one = rendered(scene, {.width = 9, .height = height, .samples = 3, .threads = 1});
    for (int threads : {0, 2, 7}) {
      SCOPED_TRACE(threads);
      EXPECT_EQ(one,
                rendered(scene, {.width = 9, .height = height, .samples = 3, .threads = threads}));
    }
  }
}

// The picture is a part of every result that is made from it: its bits are the same everywhere. A
// change of the scene or of the shading changes the number.
TEST(RenderSpheres, BitsArePinned) {
  std::uint64_t hash = 14695981039346656037u;  // FNV-1a over the samples
  for (float sample : rendered(default_scene(), {.width = 64, .height = 36, .samples = 4})) {
    hash = (hash ^ std::bit_cast<std::uint32_t>(sample)) * 1099511628211u;
  }
  EXPECT_EQ(hash, 14093776724883428946u);
}

TEST(RenderSpheres, NeedsToneMapping) {
  const auto samples = rendered(default_scene(), {.width = 160, .height = 90, .samples = 4});
  std::vector<double> luminances;
  for (std::size_t i = 0; i < samples.size(); i += 3) {
    for (std::size_t c = 0; c < 3; ++c) {
      ASSERT_TRUE(std::isfinite(samples[i + c]));
      ASSERT_GE(samples[i + c], 0);
    }
    luminances.push_back(luminance(&samples[i]));
  }
  std::sort(luminances.begin(), luminances.end());
  EXPECT_GT(luminances.back(), 8);
  EXPECT_LT(luminances.back(), 20);
  EXPECT_LT(luminances.front(), 0.01);
  const double median = luminances[luminances.size() / 2];
  EXPECT_GT(median, 0.1);
  EXPECT_LT(median, 0.5);
}

TEST(RenderSpheres, ShadesByTheModel) {
  SphereScene scene = lone_sphere();
  const DirectionalLight light{.to_light = {1, 2, 3}, .intensity = {4, 8, 2}};
  scene.lights = {{light, 0.1}};
  const std::vector<Light> lights{light};
  for (const SpecularModel& model : kSpecularModels) {
    SCOPED_TRACE(model.name);
    scene.spheres[0].model = model;
    const auto samples = rendered(scene, {.width = 1, .height = 1, .samples = 1});
    const Vector3d front(0, 0, 1);  // normal and direction to the eye, in the middle of the picture
    const Rgb expected =
        shade(scene.spheres[0].material, model, front, front, Vector3d(0, 1, 1), {}, lights);
    EXPECT_FLOAT_EQ(samples[0], static_cast<float>(expected.r));
    EXPECT_FLOAT_EQ(samples[1], static_cast<float>(expected.g));
    EXPECT_FLOAT_EQ(samples[2], static_cast<float>(expected.b));
  }
}

TEST(RenderSpheres, MirroredLightsMirrorThePicture) {
  constexpr int kSide = 32;
  SphereScene scene = lone_sphere();
  scene.camera.eye.y() = 2;
  scene.ground = {
      .material = {.ka = 1, .kd = 0.2, .ks = 0.1, .n = 5}, .mirror = 0.1, .fade_distance = 20};
  scene.ambient = {0.1, 0.1, 0.1};
  scene.spheres.push_back({.centre = {2, 0.5, 0}, .radius = 0.5, .material = {.kd = 1}});
  scene.lights = {{PointLight{.position = {-3, 4, 2}, .intensity = {1, 2, 3}}, 0.2}};
  const SpheresOptions options{.width = kSide, .height = kSide, .samples = 1};
  const auto left = rendered(scene, options);
  scene.spheres[1].centre.x() *= -1;
  scene.lights = {{PointLight{.position = {3, 4, 2}, .intensity = {1, 2, 3}}, 0.2}};
  const auto right = rendered(scene, options);
  EXPECT_NE(left, right);
  for (std::size_t y = 0; y < kSide; ++y) {
    for (std::size_t x = 0; x < kSide; ++x) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_EQ(left[3 * (y * kSide + x) + c], right[3 * (y * kSide + kSide - 1 - x) + c]);
      }
    }
  }
}

TEST(RenderSpheres, SphereShadowsTheGround) {
  SphereScene scene = lone_sphere();
  scene.spheres[0].centre.y() = 3;
  scene.camera = {.eye = {0, 5, 10}, .target = {0, 0, 0}, .view_width = 0.01, .view_height = 0.01};
  scene.ground = {.material = {.kd = 0.5}, .fade_distance = 1e9};
  scene.lights = {{DirectionalLight{.to_light = {0, 1, 0}, .intensity = {2, 2, 2}}, 0}};
  const SpheresOptions options{.width = 1, .height = 1, .samples = 1};
  EXPECT_EQ(rendered(scene, options)[0], 0);
  scene.spheres[0].centre.x() = 3;
  EXPECT_FLOAT_EQ(rendered(scene, options)[0], 1);  // kd Ip N.L
}

TEST(RenderSpheres, EdgeOfASphereIsTheMeanOfItsSamples) {
  SphereScene scene = lone_sphere();
  scene.camera.eye.y() = scene.camera.target.y() = 2;  // level with the sphere's top
  scene.backdrop.horizon = scene.backdrop.zenith = {1, 1, 1};
  scene.backdrop.glow = {0, 0, 0};
  scene.camera.view_width = scene.camera.view_height = 0.02;
  const float value = rendered(scene, {.width = 1, .height = 1, .samples = 16})[0];
  EXPECT_GT(value, 0.3F);  // sky above, an unlit sphere below
  EXPECT_LT(value, 0.7F);
  EXPECT_EQ(value * 16, std::round(value * 16));
}

TEST(RenderSpheres, RefusesOptionsOutOfRange) {
  ImageSink sink(1, 1, 3);
  const SphereScene scene;
  EXPECT_THROW(render_spheres(scene, {.width = 0, .height = 1}, sink), std::invalid_argument);
  EXPECT_THROW(render_spheres(scene, {.width = 1, .height = 65537}, sink), std::invalid_argument);
  EXPECT_THROW(render_spheres(scene, {.width = 1, .height = 1, .samples = 0}, sink),
               std::invalid_argument);
  EXPECT_THROW(render_spheres(scene, {.width = 1, .height = 1, .shaded = 0}, sink),
               std::invalid_argument);
}

TEST(RenderSpheres, StopsWhenTheSinkFails) {
  struct FullDisk : RowSink {
    int rows = 0;
    void write(ImageView<const float> band) override {
      rows += band.height;
      throw std::runtime_error("full");
    }
    void finish() override {}
  };
  FullDisk sink;
  EXPECT_THROW(render_spheres(default_scene(), {.width = 2, .height = 60000}, sink),
               std::runtime_error);
  EXPECT_LT(sink.rows, 1000);
}

TEST(DefaultScene, SpheresStandOnTheGroundAndTouchTheNext) {
  const SphereScene scene = default_scene();
  ASSERT_GT(scene.spheres.size(), 7u);
  for (std::size_t i = 0; i < scene.spheres.size(); ++i) {
    const Sphere& sphere = scene.spheres[i];
    EXPECT_EQ(sphere.centre.y(), sphere.radius);
    if (i == 0) continue;
    const Sphere& before = scene.spheres[i - 1];
    EXPECT_NEAR(length(sphere.centre - before.centre), sphere.radius + before.radius, 1e-12);
  }
}

TEST(DefaultScene, HasBothModelsBothKindsOfLightAndANeutralSphere) {
  const SphereScene scene = default_scene();
  for (const SpecularModel& model : kSpecularModels) {
    EXPECT_TRUE(std::any_of(scene.spheres.begin(), scene.spheres.end(),
                            [&](const Sphere& sphere) { return sphere.model.name == model.name; }));
  }
  const auto holds = [&](auto kind) {
    return std::any_of(scene.lights.begin(), scene.lights.end(), [](const SoftLight& light) {
      return std::holds_alternative<decltype(kind)>(light.light);
    });
  };
  EXPECT_TRUE(holds(DirectionalLight{}));
  EXPECT_TRUE(holds(PointLight{}));
  const Rgb grey = scene.spheres[0].material.od;
  EXPECT_EQ(grey, (Rgb{grey.r, grey.r, grey.r}));
}

}  // namespace
}  // namespace tristim
