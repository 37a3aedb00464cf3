#include "tristim/render/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>

#include "tests/render/scenes.h"
#include "tristim/light/gooch.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

RenderOptions all_layers() { return {.layers = {kRenderLayers.begin(), kRenderLayers.end()}}; }

TEST(RenderScene, IsTheSameForAnyThreadsAndTiles) {
  for (const Shading& shading : kShadings) {
    for (const int samples : {1, 4}) {
      SCOPED_TRACE(shading.name);
      Scene scene = test_scene(test_sphere(24, 12));
      add_lights(scene);
      scene.objects.push_back({.name = "behind", .mesh = 0, .material = 1});
      scene.objects[1].world_from_object.topRightCorner<3, 1>() = Vector3d(0.6, 0.1, 0.3);
      scene.materials.push_back({.name = "glass",
                                 .model = kBlinnReflection,
                                 .surface = {.kd = 0.4, .ks = 1, .n = 40},
                                 .transparency = Transparency::kFiltered,
                                 .transparent = {.kt = 0.5, .tint = {0.2, 0.9, 0.5}},
                                 .two_sided = true});
      scene.picture.shading = shading;
      scene.picture.samples = samples;
      scene.picture.filter = kGaussianFilter;
      const SceneRenderer renderer(std::move(scene));
      RenderOptions options = all_layers();
      options.threads = 1;
      const Rendered one = rendered(renderer, options);
      for (const auto& [threads, tile] : {std::pair{2, 64}, {3, 16}, {1, 256}, {7, 48}}) {
        options.threads = threads;
        options.tile = tile;
        const Rendered other = rendered(renderer, options);
        EXPECT_TRUE(one.samples == other.samples) << threads << " threads, tiles of " << tile;
      }
    }
  }
}

// The same equations in double: ray by ray, the nearest triangle, the models of light.
struct Oracle {
  const Scene& scene;

  Vector3d ray(double x, double y) const {
    const Camera& c = scene.camera;
    const Vector3d back = normalize(c.eye - c.target);
    const auto cross = [](const Vector3d& a, const Vector3d& b) {
      return Vector3d(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                      a.x() * b.y() - a.y() * b.x());
    };
    const Vector3d right = normalize(cross(c.up, back));
    const Vector3d up = cross(back, right);
    const double half = std::tan(c.fov_deg / 2 * 3.14159265358979323846 / 180);
    const double h = scene.picture.height;
    return (2 * x - scene.picture.width) / h * half * right + (h - 2 * y) / h * half * up - back;
  }

  struct Hit {
    double distance = 0;  // along the view axis
    std::size_t triangle = 0;
    Vector3d parts{0, 0, 0};
  };

  // Cramer's rule; front faces only.
  Hit hit(const Vector3d& along) const {
    Hit best;
    const Mesh& mesh = scene.meshes[0];
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto p = [&](std::size_t i) -> Vector3d {
        return mesh.positions[mesh.triangles[t].corners[i].position] - scene.camera.eye;
      };
      const auto volume = [](const Vector3d& a, const Vector3d& b, const Vector3d& c) {
        return a.x() * (b.y() * c.z() - b.z() * c.y()) + a.y() * (b.z() * c.x() - b.x() * c.z()) +
               a.z() * (b.x() * c.y() - b.y() * c.x());
      };
      const Vector3d parts(volume(along, p(1), p(2)), volume(p(0), along, p(2)),
                           volume(p(0), p(1), along));
      const double whole = volume(p(0), p(1), p(2));
      if (whole >= 0 || parts.maxCoeff() > 0) continue;  // seen from behind, or missed
      const double distance = whole / parts.sum();
      if (best.distance == 0 || distance < best.distance) {
        best = {distance, t, parts / parts.sum()};
      }
    }
    return best;
  }

  Rgb model(const Vector3d& point, const Vector3d& normal) const {
    std::vector<Light> lights;
    for (const SceneLight& light : scene.lights) {
      if (const auto* sun = std::get_if<DirectionalLight>(&light.source)) lights.emplace_back(*sun);
      if (const auto* lamp = std::get_if<PointLight>(&light.source)) lights.emplace_back(*lamp);
      if (const auto* spot = std::get_if<SpotLight>(&light.source)) lights.emplace_back(*spot);
    }
    return shade(scene.materials[0].surface, kPhong, normal, view_vector(point, scene.camera.eye),
                 point, scene.ambient, lights);
  }

  Rgb color(const Vector3d& along) const {
    const Hit seen = hit(along);
    if (seen.distance == 0) return {};
    const Mesh& mesh = scene.meshes[0];
    const auto& corners = mesh.triangles[seen.triangle].corners;
    const auto p = [&](std::size_t i) { return mesh.positions[corners[i].position]; };
    const auto n = [&](std::size_t i) { return mesh.normals[corners[i].normal]; };
    const Vector3d& parts = seen.parts;
    if (scene.picture.shading.name == kFlatShading.name) {
      const Vector3d a = p(1) - p(0);
      const Vector3d b = p(2) - p(0);
      return model((p(0) + p(1) + p(2)) / 3,
                   normalize(Vector3d(a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
                                      a.x() * b.y() - a.y() * b.x())));
    }
    if (scene.picture.shading.name == kGouraudShading.name) {
      Rgb sum;
      for (std::size_t i = 0; i < 3; ++i) {
        const Rgb at = model(p(i), normalize(n(i)));
        const double part = parts[static_cast<Eigen::Index>(i)];
        sum = {sum.r + part * at.r, sum.g + part * at.g, sum.b + part * at.b};
      }
      return sum;
    }
    return model(scene.camera.eye + seen.distance * along,
                 normalize(Vector3d(parts[0] * n(0) + parts[1] * n(1) + parts[2] * n(2))));
  }
};

TEST(RenderScene, IsWithin2e5OfTheDoubleEquations) {
  for (const double exponent : {1.0, 20.0, 100.0, 120.0, 2000.0}) {
    for (const Shading& shading : kShadings) {
      SCOPED_TRACE(shading.name);
      Scene scene = test_scene(test_sphere(20, 10));
      add_lights(scene);
      scene.materials[0].surface.n = exponent;
      scene.picture.shading = shading;
      const Rendered picture = rendered(scene);
      const Oracle oracle{scene};
      double worst = 0;
      int outside = 0;
      for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
          const Rgb expected = oracle.color(oracle.ray(x + 0.5, y + 0.5));
          const double difference = std::max({std::fabs(picture.at(x, y, 0) - expected.r),
                                              std::fabs(picture.at(x, y, 1) - expected.g),
                                              std::fabs(picture.at(x, y, 2) - expected.b)});
          // A sample within 2^-17 of a pixel of an edge may be on its other side.
          if (difference > 0.01) ++outside;
          if (difference <= 0.01) worst = std::max(worst, difference);
        }
      }
      EXPECT_EQ(outside, 0);
      EXPECT_LT(worst, 2e-5);
    }
  }
}

TEST(RenderScene, AClosedMeshHasNoHolesAtAnyDistance) {
  for (const double distance : {1.02, 1.5, 3.0, 40.0}) {
    Scene scene = test_scene(test_sphere(40, 20));
    scene.camera = {.eye = {0.2, 0.1, distance}, .near = 1e-3};
    scene.picture = {.width = 200, .height = 160};
    const Rendered picture = rendered(scene, {.layers = {kIdLayer}});
    // Rows of the outline are without gaps.
    for (int y = 0; y < picture.height; ++y) {
      int changes = 0;
      for (int x = 1; x < picture.width; ++x) {
        changes += (picture.at(x, y, 0) != 0) != (picture.at(x - 1, y, 0) != 0) ? 1 : 0;
      }
      EXPECT_LE(changes, 2) << "row " << y << " from " << distance;
    }
  }
}

TEST(RenderScene, LayersAddUpToBeauty) {
  Scene scene = test_scene(test_sphere(24, 12));
  add_lights(scene);
  scene.lights.push_back({.name = "panel",
                          .source = PolygonLight{.polygon = {{-1, 2, 2}, {1, 2, 2}, {1, 2, -1}},
                                                 .intensity = {2, 3, 4}}});
  scene.picture.samples = 4;
  scene.picture.filter = kTentFilter;
  const Rendered picture = rendered(scene, all_layers());
  const std::string rgb = "RGB";
  double most = 0;
  for (int y = 0; y < picture.height; ++y) {
    for (int x = 0; x < picture.width; ++x) {
      for (const char c : rgb) {
        double sum = picture.at(x, y, std::string("ambient.") + c);
        for (const SceneLight& light : scene.lights) {
          sum += picture.at(x, y, "diffuse." + light.name + "." + c);
          sum += picture.at(x, y, "specular." + light.name + "." + c);
        }
        EXPECT_NEAR(picture.at(x, y, std::string(1, c)), sum, 1e-6);
        most = std::max(most, sum);
      }
    }
  }
  EXPECT_GT(most, 0.5);
}

TEST(RenderScene, BeautyIsThatOfItsLayers) {
  Scene scene = test_scene(test_sphere(24, 12));
  add_lights(scene);
  const SceneRenderer renderer(std::move(scene));
  const Rendered alone = rendered(renderer);
  const Rendered split = rendered(renderer, {.layers = {kBeautyLayer, kAmbientLayer}});
  for (int y = 0; y < alone.height; ++y) {
    for (int x = 0; x < alone.width; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_NEAR(alone.at(x, y, c), split.at(x, y, c), 1e-6);
      }
    }
  }
}

TEST(RenderScene, GeometryLayersAreThoseOfTheSurface) {
  Scene scene = test_scene(test_square());
  scene.camera = {.eye = {0, 0, 3}, .fov_deg = 60};
  scene.picture = {.width = 40, .height = 40};
  const Rendered picture = rendered(scene, {.layers = {kNormalLayer, kPositionLayer, kDepthLayer,
                                                       kIdLayer, kUvLayer, kAlbedoLayer}});
  // The view is 2 * 3 tan 30 = 3.4641 high.
  const int x = 26;
  const int y = 17;
  const double scale = 3.4641016151377544 / 40;
  const double px = (x + 0.5 - 20) * scale;
  const double py = (20 - y - 0.5) * scale;
  EXPECT_EQ(picture.at(x, y, "N.Z"), 1);
  EXPECT_NEAR(picture.at(x, y, "P.X"), px, 1e-6);
  EXPECT_NEAR(picture.at(x, y, "P.Y"), py, 1e-6);
  EXPECT_NEAR(picture.at(x, y, "P.Z"), 0, 1e-6);
  EXPECT_NEAR(picture.at(x, y, "Z"), 3, 1e-6);
  EXPECT_EQ(picture.at(x, y, "id"), px > py ? 1 : 2);
  EXPECT_NEAR(picture.at(x, y, "uv.U"), (px + 1) / 2, 1e-6);
  EXPECT_NEAR(picture.at(x, y, "uv.V"), (py + 1) / 2, 1e-6);
  EXPECT_NEAR(picture.at(x, y, "albedo.R"), 0.6 * 0.9, 1e-6);
  for (const std::string& name : picture.names) EXPECT_EQ(picture.at(0, 0, name), 0) << name;
}

TEST(RenderScene, CoverageIsThePartOfThePixel) {
  Scene scene = test_scene(test_square());
  // 10 pixels for a length of 1: the square is 5.25 to 25.25, whose edges cut quarters off.
  scene.camera = {.eye = {-0.025, 0.025, 3}, .target = {-0.025, 0.025, 0}, .orthographic = true};
  scene.camera.height = 3;
  scene.picture = {.width = 30, .height = 30, .samples = 16};
  const Rendered picture = rendered(scene);
  const auto alpha = picture.channel("A");
  EXPECT_EQ(picture.at(15, 15, alpha), 1);
  EXPECT_EQ(picture.at(2, 15, alpha), 0);
  EXPECT_EQ(picture.at(5, 15, alpha), 0.75F);
  EXPECT_EQ(picture.at(25, 15, alpha), 0.25F);
  EXPECT_EQ(picture.at(15, 5, alpha), 0.75F);
  EXPECT_EQ(picture.at(25, 25, alpha), 0.0625F);
}

TEST(RenderScene, FiltersKeepTheSumOfLight) {
  for (const PixelFilter& filter : kPixelFilters) {
    for (const int samples : {1, 4, 16, 64}) {
      Scene scene = test_scene(test_square());
      scene.materials[0].model = kFlatColor;
      scene.materials[0].surface.od = {1, 1, 1};
      scene.camera = {.eye = {0.01, 0.02, 3}, .target = {0.01, 0.02, 0}, .orthographic = true};
      scene.camera.height = 4;
      scene.picture = {.width = 40, .height = 40, .samples = samples, .filter = filter};
      const Rendered picture = rendered(scene);
      double sum = 0;
      for (int y = 0; y < 40; ++y) {
        for (int x = 0; x < 40; ++x) sum += picture.at(x, y, 0);
      }
      EXPECT_NEAR(sum, 400, samples == 1 ? 1e-3 : 0.5) << filter.name << " " << samples;
      EXPECT_NEAR(picture.at(20, 20, 0), 1, 1e-6);
    }
  }
}

TEST(RenderScene, TransparentSurfacesAreSortedAndMixed) {
  Scene scene = test_scene(test_square());
  scene.camera = {.eye = {0, 0, 5}, .orthographic = true};
  scene.picture = {.width = 4, .height = 4};
  const auto glass = [](const Rgb& color, Transparency kind, double kt, const Rgb& tint) {
    return SceneMaterial{.model = kFlatColor,
                         .surface = {.od = color},
                         .transparency = kind,
                         .transparent = {kt, tint}};
  };
  scene.materials = {{.model = kFlatColor, .surface = {.od = {1, 0.5, 0.25}}},
                     glass({0.2, 0.4, 0.6}, Transparency::kInterpolated, 0.25, {1, 1, 1}),
                     glass({0.1, 0.1, 0.1}, Transparency::kFiltered, 0.5, {0.5, 1, 0.2})};
  // In an order that is neither from behind nor from the front; one is hidden.
  scene.objects.clear();
  for (const auto& [z, material] : {std::pair{1.0, 2U}, {0.0, 0U}, {2.0, 1U}, {-1.0, 1U}}) {
    scene.objects.push_back({.material = material});
    scene.objects.back().world_from_object(2, 3) = z;
  }
  const Rendered picture = rendered(scene);
  const auto expected = [](double behind, double front, double tint, double over) {
    return 0.75 * over + 0.25 * (front + 0.5 * tint * behind);
  };
  EXPECT_NEAR(picture.at(1, 1, 0), expected(1, 0.1, 0.5, 0.2), 1e-6);
  EXPECT_NEAR(picture.at(1, 1, 1), expected(0.5, 0.1, 1, 0.4), 1e-6);
  EXPECT_NEAR(picture.at(1, 1, 2), expected(0.25, 0.1, 0.2, 0.6), 1e-6);
  EXPECT_EQ(picture.at(1, 1, 3), 1);
}

TEST(RenderScene, BackFacesAreCulledUnlessTwoSided) {
  Scene scene = test_scene(test_square());
  add_lights(scene);
  scene.camera.eye = {0, 0, -4};
  EXPECT_EQ(rendered(scene).at(46, 35, "A"), 0);
  scene.materials[0].two_sided = true;
  const Rendered picture = rendered(scene, {.layers = {kBeautyLayer, kNormalLayer}});
  EXPECT_EQ(picture.at(46, 35, "A"), 1);
  EXPECT_EQ(picture.at(46, 35, "N.Z"), -1);
}

TEST(RenderScene, AMirroredObjectKeepsItsOutside) {
  Scene scene = test_scene(test_sphere(24, 12));
  scene.objects[0].world_from_object(0, 0) = -1;
  const Rendered picture = rendered(scene, {.layers = {kNormalLayer}});
  EXPECT_GT(picture.at(46, 35, "N.Z"), 0.9);
}

// The near plane cuts a floor that reaches behind the camera.
TEST(RenderScene, ClipsAtTheNearPlane) {
  Scene scene = test_scene(test_square());
  scene.objects[0].world_from_object << 100, 0, 0, 0, 0, 0, 1, -1, 0, -100, 0, 0, 0, 0, 0, 1;
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_deg = 90};
  scene.picture = {.width = 20, .height = 20};
  const Rendered picture = rendered(scene, {.layers = {kDepthLayer, kPositionLayer}});
  for (int y = 0; y < 20; ++y) {
    // A ray meets the floor at distance 1 / tan of its angle below the horizon.
    const double slope = (y + 0.5 - 10) / 10;
    const double z = slope > 0 && 1 / slope <= 100 ? 1 / slope : 0;
    EXPECT_NEAR(picture.at(10, y, "Z"), z, 3e-6 * z);
    if (z > 0) EXPECT_NEAR(picture.at(10, y, "P.Y"), -1, 3e-6);
  }
}

TEST(RenderScene, AffineInterpolationIsWrongInPerspective) {
  Scene scene = test_scene(test_square());
  scene.objects[0].world_from_object << 1, 0, 0, 0, 0, 0, 1, -0.5, 0, -3, 0, -4, 0, 0, 0, 1;
  scene.camera = {.eye = {0, 0, 0}, .target = {0, 0, -1}, .fov_deg = 90};
  scene.picture = {.width = 64, .height = 64};
  const Rendered right = rendered(scene, {.layers = {kUvLayer, kPositionLayer}});
  scene.picture.affine = true;
  const Rendered wrong = rendered(scene, {.layers = {kUvLayer}});
  int seen = 0;
  double most = 0;
  for (int y = 0; y < 64; ++y) {
    if (right.at(32, y, "P.Y") == 0) continue;
    ++seen;
    EXPECT_NEAR(right.at(32, y, "uv.V"), (-right.at(32, y, "P.Z") - 1) / 6, 1e-5);
    most = std::max<double>(most, std::fabs(right.at(32, y, "uv.V") - wrong.at(32, y, "uv.V")));
  }
  EXPECT_GT(seen, 5);
  EXPECT_GT(most, 0.2);
}

TEST(RenderScene, CountsAndLeavesOutTrianglesWithoutArea) {
  Scene scene = test_scene(test_square());
  Mesh& mesh = scene.meshes[0];
  mesh.positions.emplace_back(0.1, 0.1, 0);
  mesh.positions.emplace_back(0.3, 0.3, 0);
  mesh.positions.emplace_back(0.7, 0.7, 0);
  MeshTriangle line;
  for (std::uint32_t i = 0; i < 3; ++i) line.corners[i].position = 4 + i;
  mesh.triangles.insert(mesh.triangles.begin(), line);
  const SceneRenderer renderer(std::move(scene));
  EXPECT_EQ(renderer.report().triangles, 3U);
  EXPECT_EQ(renderer.report().degenerate, 1U);
  EXPECT_GE(rendered(renderer, {.layers = {kIdLayer}}).at(46, 35, 0), 2);
}

TEST(RenderScene, WithoutLightsIsBlack) {
  const Rendered picture = rendered(test_scene(test_sphere(12, 6)));
  for (std::size_t i = 0; i < picture.samples.size(); i += 4) EXPECT_EQ(picture.samples[i], 0);
  EXPECT_EQ(picture.at(46, 35, "A"), 1);
}

TEST(RenderScene, RefusesWhatIsNoScene) {
  const auto refuses = [](auto&& change) {
    Scene scene = test_scene(test_square());
    add_lights(scene);
    change(scene);
    EXPECT_THROW(rendered(scene), std::invalid_argument);
  };
  refuses([](Scene& s) { s.camera.near = 0; });
  refuses([](Scene& s) { s.camera.far = s.camera.near; });
  refuses([](Scene& s) { s.camera.fov_deg = 180; });
  refuses([](Scene& s) { s.camera.target = s.camera.eye; });
  refuses([](Scene& s) { s.camera.up = s.camera.eye; });
  refuses([](Scene& s) { s.picture.width = 0; });
  refuses([](Scene& s) { s.picture.height = 65537; });
  refuses([](Scene& s) { s.picture.samples = 3; });
  refuses([](Scene& s) { s.objects[0].mesh = 1; });
  refuses([](Scene& s) { s.objects[0].material = 1; });
  refuses([](Scene& s) { s.meshes[0].triangles[0].corners[1].position = 4; });
  refuses([](Scene& s) { s.meshes[0].positions[2].x() = std::nan(""); });
  refuses([](Scene& s) { s.materials[0].surface.n = -1; });
  refuses([](Scene& s) { s.lights[0].source = SpotLight{.cutoff_deg = 190}; });
}

TEST(Orbit, GoesRoundTheTargetInSteps) {
  Camera camera{.eye = {1, 2, 5}, .target = {1, 1, 1}};
  EXPECT_EQ(orbit(camera, 1, 24).eye, camera.eye);
  const Camera quarter = orbit(camera, 7, 24);
  EXPECT_LT((quarter.eye - Vector3d(5, 2, 1)).norm(), 1e-14);
  EXPECT_EQ(quarter.target, camera.target);
}

}  // namespace
}  // namespace tristim
