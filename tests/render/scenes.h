#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "tristim/image/memory.h"
#include "tristim/render/render.h"

namespace tristim {

/// A closed sphere of radius 1 about the origin with its own normals.
inline Mesh test_sphere(int around, int down) {
  constexpr double kPi = 3.14159265358979323846;
  Mesh mesh;
  for (int j = 0; j <= down; ++j) {
    for (int i = 0; i < around; ++i) {
      const double theta = kPi * j / down;
      const double phi = 2 * kPi * i / around;
      const double ring = j == 0 || j == down ? 0 : std::sin(theta);
      mesh.positions.emplace_back(ring * std::cos(phi), std::cos(theta), -ring * std::sin(phi));
      mesh.normals.push_back(mesh.positions.back());
      mesh.uvs.push_back({static_cast<float>(i) / static_cast<float>(around),
                          static_cast<float>(j) / static_cast<float>(down)});
    }
  }
  const auto corner = [&](int i, int j) {
    const auto index = static_cast<std::uint32_t>(j * around + i % around);
    return MeshCorner{index, index, index};
  };
  for (int j = 0; j < down; ++j) {
    for (int i = 0; i < around; ++i) {
      const MeshCorner a = corner(i, j);
      const MeshCorner b = corner(i, j + 1);
      const MeshCorner c = corner(i + 1, j + 1);
      const MeshCorner d = corner(i + 1, j);
      if (j + 1 < down) mesh.triangles.push_back({.corners = {a, b, c}});
      if (j > 0) mesh.triangles.push_back({.corners = {a, c, d}});
    }
  }
  return mesh;
}

/// The square from (-1, -1) to (1, 1) at z = 0, seen from +z.
inline Mesh test_square() {
  Mesh mesh;
  mesh.positions = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}};
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const auto corner = [](std::uint32_t i) { return MeshCorner{i, kNoIndex, i}; };
  mesh.triangles = {{.corners = {corner(0), corner(1), corner(2)}},
                    {.corners = {corner(0), corner(2), corner(3)}}};
  return mesh;
}

/// A mesh in a glossy red material, before the camera, with nothing to light it.
inline Scene test_scene(Mesh mesh) {
  Scene scene;
  scene.meshes.push_back(std::move(mesh));
  scene.materials.push_back(
      {.name = "red",
       .surface = {.ka = 0.1, .kd = 0.6, .ks = 0.4, .n = 20, .od = {0.9, 0.3, 0.2}}});
  scene.objects.push_back({.name = "thing"});
  scene.camera = {.eye = {0.3, 0.4, 4}, .fov_deg = 35};
  scene.picture.width = 93;
  scene.picture.height = 71;
  return scene;
}

/// The three kinds of light, and ambient light.
inline void add_lights(Scene& scene) {
  scene.ambient = {0.5, 0.6, 0.7};
  scene.lights = {
      {.name = "sun",
       .source = DirectionalLight{.to_light = {1, 2, 2}, .intensity = {0.5, 0.5, 0.4}}},
      {.name = "lamp",
       .source = PointLight{.position = {-2, 1, 3},
                            .intensity = {0.9, 0.8, 1.5},
                            .attenuation = {.kind = kAttenuations[2], .c1 = 0.5, .c2 = 0.1}}},
      {.name = "spot",
       .source = SpotLight{.position = {1, -1, 4},
                           .direction = {-1, 1, -4},
                           .cutoff_deg = 11,
                           .exponent = 3,
                           .intensity = {1, 2, 1}}}};
}

/// A rendered picture with all its channels.
struct Rendered {
  int width = 0, height = 0;
  std::vector<std::string> names;
  std::vector<float> samples;

  /// The place of a channel in a pixel.
  std::size_t channel(const std::string& name) const {
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i] == name) return i;
    }
    ADD_FAILURE() << "no channel " << name;
    return 0;
  }
  float at(int x, int y, std::size_t c) const {
    return samples[static_cast<std::size_t>(y * width + x) * names.size() + c];
  }
  float at(int x, int y, const std::string& name) const { return at(x, y, channel(name)); }
};

inline Rendered rendered(const SceneRenderer& renderer, const RenderOptions& options = {}) {
  const Scene& scene = renderer.scene();
  const PictureInfo info = render_info(scene, options);
  ImageSink sink(info.width, info.height, info.channels);
  renderer.render(scene.camera, options, sink);
  sink.finish();
  Rendered picture{info.width, info.height, render_channels(scene, options), {}};
  const ImageView<const float> view = sink.image().view();
  for (int y = 0; y < view.height; ++y) {
    const auto row = view.row(y);
    picture.samples.insert(picture.samples.end(), row.begin(), row.end());
  }
  return picture;
}

inline Rendered rendered(Scene scene, const RenderOptions& options = {}) {
  return rendered(SceneRenderer(std::move(scene)), options);
}

}  // namespace tristim
