#include <gtest/gtest.h>

#include <algorithm>

#include "lib/render/fresnel_table.h"
#include "tests/render/scenes.h"
#include "tristim/color/illuminant.h"
#include "tristim/core/find.h"
#include "tristim/light/spectral.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

SpectralColor shape(double lo, double hi, double mu, double sd) {
  SpectralColor color;
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    color.at[i] = kReflectanceShapes[0].at(sample_nm(i), lo, hi, mu, 0, sd);
  }
  return color;
}

// A square of one normal under two spectral lights.
Scene spectral_scene() {
  Scene scene = test_scene(test_square());
  scene.white = sampled_illuminant(*find_by_name(illuminants(), "A"));
  scene.ambient_spectrum = sampled_illuminant(*find_by_name(illuminants(), "A"));
  scene.lights = {{.name = "day",
                   .source = DirectionalLight{.to_light = {0.2, 0.5, 1}},
                   .spectrum = sampled_illuminant(*find_by_name(illuminants(), "D65"))},
                  {.name = "lamp",
                   .source = PointLight{.position = {1, -1, 2}},
                   .spectrum = sampled_illuminant(*find_by_name(illuminants(), "F2"))}};
  scene.materials[0].spectral =
      SpectralSurface{.od = shape(0.05, 0.9, 610, 40), .os = shape(0.2, 1, 450, 60)};
  scene.picture = {.width = 24, .height = 24};
  return scene;
}

Vector3d xyz_at(const Rendered& picture, int x, int y) {
  return {picture.at(x, y, "R"), picture.at(x, y, "G"), picture.at(x, y, "B")};
}

// Light at 81 wavelengths by the definition at each pixel, summed up there.
template <class Light81>
void expect_brute_force(const Scene& scene, Light81&& light) {
  const Rendered picture = rendered(scene, {.layers = {kBeautyLayer, kPositionLayer}, .xyz = true});
  double most = 0;
  for (int y = 0; y < 24; ++y) {
    for (int x = 0; x < 24; ++x) {
      if (picture.at(x, y, "A") == 0) continue;
      const Vector3d p(picture.at(x, y, "P.X"), picture.at(x, y, "P.Y"), picture.at(x, y, "P.Z"));
      const Xyz expected = xyz_of_samples(light(p), *scene.white);
      const Vector3d got = xyz_at(picture, x, y);
      EXPECT_NEAR(got.x(), expected.x, 1e-6);
      EXPECT_NEAR(got.y(), expected.y, 1e-6);
      EXPECT_NEAR(got.z(), expected.z, 1e-6);
      most = std::max(most, expected.y);
    }
  }
  EXPECT_GT(most, 0.1);
}

SpectralMaterial spectral_material(const Scene& scene) {
  const SceneMaterial& m = scene.materials[0];
  return {m.surface.ka, m.surface.kd, m.surface.ks, m.surface.n, m.spectral->od, m.spectral->os};
}

std::vector<SpectralLight> spectral_lights(const Scene& scene) {
  return {
      DirectionalLightOf<SpectralColor>{.to_light = {0.2, 0.5, 1},
                                        .intensity = *scene.lights[0].spectrum},
      PointLightOf<SpectralColor>{.position = {1, -1, 2}, .intensity = *scene.lights[1].spectrum}};
}

TEST(SpectralScene, IsWithin1e6OfBruteForce) {
  const Scene scene = spectral_scene();
  const auto lights = spectral_lights(scene);
  expect_brute_force(scene, [&](const Vector3d& p) {
    return shade(spectral_material(scene), kPhong, {0, 0, 1}, view_vector(p, scene.camera.eye), p,
                 *scene.ambient_spectrum, lights);
  });
}

TEST(SpectralScene, FresnelOfEachWavelengthIsWithin1e6OfBruteForce) {
  Scene scene = spectral_scene();
  scene.materials[0].model = kMicrofacetReflection;
  std::array<Reflector, kSpectralSamples> metal;
  for (std::size_t i = 0; i < kSpectralSamples; ++i) {
    metal[i] = Conductor{0.2 + 0.01 * static_cast<double>(i), 4 - 0.03 * static_cast<double>(i)};
  }
  scene.materials[0].rough.spectral = metal;
  const auto lights = spectral_lights(scene);
  const SpectralMaterial material = spectral_material(scene);
  expect_brute_force(scene, [&](const Vector3d& p) {
    SpectralColor sum = ambient_reflection(material, *scene.ambient_spectrum);
    const Vector3d v = view_vector(p, scene.camera.eye);
    for (const SpectralLight& light : lights) {
      const SpectralIncident arriving = incident(light, p);
      const double cosine = arriving.to_light.z();
      const SpectralColor rho =
          torrance_sparrow(scene.materials[0].rough.facets, metal, {0, 0, 1}, arriving.to_light, v);
      for (std::size_t i = 0; i < kSpectralSamples; ++i) {
        sum.at[i] += arriving.intensity.at[i] * cosine *
                     (material.kd * material.od.at[i] / 3.14159265358979323846 +
                      material.ks * material.os.at[i] * rho.at[i]);
      }
    }
    return sum;
  });
}

TEST(SpectralScene, ALightOfTheWhiteOnWhiteHasY1) {
  Scene scene = spectral_scene();
  scene.lights = {{.name = "white", .source = DirectionalLight{.to_light = {0, 0, 1}}}};
  scene.lights[0].spectrum = scene.white;
  scene.ambient_spectrum.reset();
  scene.materials[0].surface = {.kd = 1};
  scene.materials[0].spectral = SpectralSurface{};
  EXPECT_NEAR(rendered(scene, {.xyz = true}).at(12, 12, "G"), 1, 1e-6);
}

TEST(FresnelTable, IsThatOfTheDefinition) {
  for (const Reflector& reflector :
       {Reflector(Dielectric{1, 1.01}), Reflector(Dielectric{1, 1.5}), Reflector(Dielectric{1, 4}),
        Reflector(Conductor{0.2, 3.9}), Reflector(Conductor{3, 0.1})}) {
    const detail::FresnelTable table([&](double cosine) {
      const double f = fresnel(reflector, cosine);
      return Rgb{f, 2 * f, -f};
    });
    for (int i = 0; i <= 3333; ++i) {
      const double cosine = i / 3333.0;
      const double f = fresnel(reflector, cosine);
      const Rgb got = table.at(cosine);
      ASSERT_NEAR(got.r, f, 1e-6) << cosine;
      ASSERT_NEAR(got.g, 2 * f, 2e-6);
      ASSERT_NEAR(got.b, -f, 1e-6);
    }
  }
}

// Each of the microfacet models against the double function.
TEST(RoughScene, IsThatOfTheDefinition) {
  for (const MicrofacetDistribution& distribution : kMicrofacetDistributions) {
    for (const MicrofacetNormalization& normalization : kMicrofacetNormalizations) {
      for (const bool colored : {false, true}) {
        SCOPED_TRACE(distribution.name);
        Scene scene = test_scene(test_square());
        SceneMaterial& material = scene.materials[0];
        material.model = kMicrofacetReflection;
        material.rough.facets = {distribution, normalization, 0.3};
        if (colored) {
          material.rough.reflectors = {Conductor{0.2, 4}, Conductor{0.9, 2.4}, Dielectric{1, 1.8}};
        }
        const DirectionalLight light{.to_light = {0.3, 0.4, 1}, .intensity = {1, 0.5, 0.8}};
        scene.lights = {{.name = "sun", .source = light}};
        scene.picture = {.width = 24, .height = 24};
        const Rendered picture = rendered(scene, {.layers = {kBeautyLayer, kPositionLayer}});
        const Vector3d p(picture.at(12, 12, "P.X"), picture.at(12, 12, "P.Y"), 0);
        const Incident arriving = incident(Light(light), p);
        const Rgb rho =
            torrance_sparrow(material.rough.facets, material.rough.reflectors, {0, 0, 1},
                             arriving.to_light, view_vector(p, scene.camera.eye));
        const Material& m = material.surface;
        const double cosine = arriving.to_light.z();
        const double pi = 3.14159265358979323846;
        EXPECT_NEAR(picture.at(12, 12, 0), cosine * (m.kd * m.od.r / pi + m.ks * rho.r), 2e-6);
        EXPECT_NEAR(picture.at(12, 12, 1), 0.5 * cosine * (m.kd * m.od.g / pi + m.ks * rho.g),
                    2e-6);
        EXPECT_NEAR(picture.at(12, 12, 2), 0.8 * cosine * (m.kd * m.od.b / pi + m.ks * rho.b),
                    2e-6);
      }
    }
  }
}

}  // namespace
}  // namespace tristim
