#include "tristim/light/rows.h"

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "tristim/core/find.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979323846;

// Points with normals about +z, before an eye at (0, 0, 5).
struct Surface {
  std::array<std::vector<float>, 6> rows;

  explicit Surface(std::size_t size) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-1, 1);
    for (auto& row : rows) row.resize(size);
    for (std::size_t i = 0; i < size; ++i) {
      const Vector3d normal =
          normalize(Vector3d(place(random), place(random), place(random) + 0.7));
      for (std::size_t k = 0; k < 3; ++k) {
        rows[k][i] = static_cast<float>(place(random));
        rows[3 + k][i] = static_cast<float>(normal[static_cast<Eigen::Index>(k)]);
      }
    }
  }

  SurfaceRows view(std::size_t size) const {
    const auto row = [&](std::size_t k) { return std::span(rows[k]).first(size); };
    return {row(0), row(1), row(2), row(3), row(4), row(5)};
  }
  Vector3d point(std::size_t i) const { return {rows[0][i], rows[1][i], rows[2][i]}; }
  Vector3d normal(std::size_t i) const { return {rows[3][i], rows[4][i], rows[5][i]}; }
};

struct Lit {
  std::array<std::vector<float>, 3> rows;

  explicit Lit(std::size_t size) {
    for (auto& row : rows) row.resize(size, -1);
  }
  LightRows view() { return {rows[0], rows[1], rows[2]}; }
};

const std::vector<Light>& some_lights() {
  static const std::vector<Light> lights{
      PointLight{.position = {2, 1, 3}, .intensity = {1, 0.5, 0.25}},
      DirectionalLight{.to_light = {-1, 2, 1}, .intensity = {0.25, 0.5, 1}},
      PointLight{.position = {-2, 0, 1},
                 .intensity = {8, 8, 8},
                 .attenuation = {.kind = *find_by_name(kAttenuations, "inverse_square")}},
      PointLight{.position = {0, -3, 2},
                 .intensity = {3, 2, 1},
                 .attenuation = {.kind = *find_by_name(kAttenuations, "beer_lambert"), .c1 = 0.5}},
      SpotLight{.position = {1, -1, 4},
                .direction = {-1, 2, -8},
                .cutoff_deg = 15,
                .exponent = 2.5,
                .intensity = {2, 1, 1}}};
  return lights;
}

RowShading shading_of(const RowModel& model) {
  return {.model = model,
          .material = {.ka = 0.125, .kd = 0.5, .ks = 0.5, .n = 37.5, .od = {1, 0.5, 0.25}},
          .m = 0.3,
          .eta = 1.5,
          .ambient = {0.5, 0.25, 0.125},
          .eye = {0, 0, 5},
          .lights = some_lights()};
}

// Every instruction set that this processor has, then its own choice again.
class ShadeRows : public testing::Test {
 protected:
  ~ShadeRows() override { hwy::SetSupportedTargetsForTest(0); }

  static std::vector<std::int64_t> targets() {
    hwy::SetSupportedTargetsForTest(0);
    return hwy::SupportedAndGeneratedTargets();
  }
};

TEST_F(ShadeRows, SameBitsOnEveryInstructionSet) {
  constexpr std::size_t kMost = 1003;
  const Surface surface(kMost);
  for (const std::int64_t target : targets()) {
    hwy::SetSupportedTargetsForTest(target);
    for (const RowModel& model : kRowModels) {
      SCOPED_TRACE(testing::Message() << model.name << " on " << hwy::TargetName(target));
      for (const std::size_t size :
           {0UL, 1UL, 3UL, 7UL, 8UL, 9UL, 15UL, 16UL, 17UL, 63UL, 64UL, 65UL, kMost}) {
        Lit fast(size);
        Lit scalar(size);
        shade_rows(shading_of(model), surface.view(size), fast.view());
        detail::shade_rows_scalar(shading_of(model), surface.view(size), scalar.view());
        for (std::size_t c = 0; c < 3; ++c) {
          ASSERT_EQ(std::memcmp(fast.rows[c].data(), scalar.rows[c].data(), size * sizeof(float)),
                    0)
              << size;
        }
      }
    }
  }
}

// F D G / (4 pi N.V) N.L of [Cook82] with Beckmann's distribution, term by term.
double cook_torrance(const Vector3d& n, const Vector3d& l, const Vector3d& v, double m,
                     double eta) {
  const double nl = dot(n, l);
  const double nv = dot(n, v);
  if (!(nl > 0 && nv > 0)) return 0;
  const Vector3d h = half_vector(l, v);
  const double nh = dot(n, h);
  const double vh = dot(v, h);
  const double tan2 = (1 - nh * nh) / (nh * nh);
  const double d = std::exp(-tan2 / (m * m)) / (m * m * nh * nh * nh * nh);
  const double g = std::min({1.0, 2 * nh * nv / vh, 2 * nh * nl / vh});
  const double k = std::sqrt(eta * eta - 1 + vh * vh);
  const double a = (k - vh) / (k + vh);
  const double b = (vh * (k + vh) - 1) / (vh * (k - vh) + 1);
  return 0.5 * a * a * (1 + b * b) * d * g / (4 * kPi * nv);
}

// The double functions at a sample, with the diffuse or the specular part alone.
double defined(const RowShading& shading, const Surface& surface, std::size_t i) {
  const Vector3d n = surface.normal(i);
  const Vector3d v = normalize(shading.eye - surface.point(i));
  const Incident arriving = incident(shading.lights[0], surface.point(i));
  if (same_name(shading.model.name, "cook-torrance")) {
    const double diffuse = lambert(n, arriving.to_light) / kPi;
    const double specular = cook_torrance(n, arriving.to_light, v, shading.m, shading.eta);
    return arriving.intensity.r * (shading.material.kd * diffuse + shading.material.ks * specular);
  }
  const SpecularModel* lobe = find_by_name(kSpecularModels, shading.model.name);
  Material material = shading.material;
  if (lobe == nullptr) material.ks = 0;
  return direct_reflection(material, lobe == nullptr ? kPhong : *lobe, n, v, arriving).r;
}

double largest_relative_error(const RowShading& shading, const Surface& surface, std::size_t size) {
  Lit lit(size);
  shade_rows(shading, surface.view(size), lit.view());
  double largest = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const double expected = defined(shading, surface, i);
    if (expected < 1e-35) {
      EXPECT_LT(lit.rows[0][i], 1.1e-35);
      continue;
    }
    largest = std::max(largest, std::fabs(lit.rows[0][i] - expected) / expected);
  }
  return largest;
}

TEST_F(ShadeRows, KeepToTheDoubleFunctions) {
  constexpr std::size_t kSize = 4000;
  const Surface surface(kSize);
  for (const RowModel& model : kRowModels) {
    for (const Light& light : some_lights()) {
      RowShading shading = shading_of(model);
      shading.lights = {&light, 1};
      shading.material = {.kd = 1};
      EXPECT_LT(largest_relative_error(shading, surface, kSize), 6e-7)
          << model.name;  // measured: 4.9e-7
      shading.material = {.ks = 1};
      if (same_name(model.name, "lambert")) continue;
      for (const double n : {0.0, 1.0, 2.5, 10.0, 200.0, 1000.0}) {
        SCOPED_TRACE(testing::Message() << model.name << ", n " << n);
        shading.material.n = n;
        shading.m = std::sqrt(2 / (n + 2));
        EXPECT_LT(largest_relative_error(shading, surface, kSize), 2e-6 + 1.1e-7 * n);
      }
    }
  }
}

TEST_F(ShadeRows, SumTheLightsAndTheAmbient) {
  const Surface surface(100);
  for (const RowModel& model : kRowModels) {
    const SpecularModel* lobe = find_by_name(kSpecularModels, model.name);
    if (lobe == nullptr) continue;
    const RowShading shading = shading_of(model);
    Lit lit(100);
    shade_rows(shading, surface.view(100), lit.view());
    for (std::size_t i = 0; i < 100; ++i) {
      const Vector3d v = normalize(shading.eye - surface.point(i));
      const Rgb expected = shade(shading.material, *lobe, surface.normal(i), v, surface.point(i),
                                 shading.ambient, shading.lights);
      EXPECT_NEAR(lit.rows[0][i], expected.r, 3e-6 * expected.r) << model.name;
      EXPECT_NEAR(lit.rows[1][i], expected.g, 3e-6 * expected.g) << model.name;
      EXPECT_NEAR(lit.rows[2][i], expected.b, 3e-6 * expected.b) << model.name;
    }
  }
}

TEST_F(ShadeRows, SpotsEndAtTheirEdge) {
  // At 45 degrees on either side of the edge, on it, behind the light, and on the axis.
  const std::vector<float> x{0.999999F, 1, 1.000001F, 0, 0};
  const std::vector<float> z{0, 0, 0, 2, 0};
  const std::vector<float> zeros(5, 0);
  const std::vector<float> ones(5, 1);
  for (const double cutoff : {45.0, 90.0, 180.0}) {
    const Light light = SpotLight{
        .position = {0, 0, 1}, .cutoff_deg = cutoff, .exponent = 3, .intensity = {1, 1, 1}};
    RowShading shading = shading_of(kLambertRows);
    shading.ambient = {};
    shading.material = {.kd = 1};
    shading.lights = {&light, 1};
    Lit lit(5);
    shade_rows(shading, {x, zeros, z, zeros, zeros, ones}, lit.view());
    for (std::size_t i = 0; i < 5; ++i) {
      const Incident arriving = incident(light, Vector3d(x[i], 0, z[i]));
      const double expected = arriving.intensity.r * std::max(0.0, arriving.to_light.z());
      EXPECT_NEAR(lit.rows[0][i], expected, 1e-6 * expected) << cutoff << ", " << x[i];
    }
  }
}

TEST_F(ShadeRows, DistantEyeIsADirection) {
  const Surface surface(50);
  RowShading shading = shading_of(kPhongRows);
  shading.local_viewer = false;
  shading.eye = {0, 3, 4};
  Lit lit(50);
  shade_rows(shading, surface.view(50), lit.view());
  for (std::size_t i = 0; i < 50; ++i) {
    const Rgb expected = shade(shading.material, kPhong, surface.normal(i), Vector3d(0, 0.6, 0.8),
                               surface.point(i), shading.ambient, shading.lights);
    EXPECT_NEAR(lit.rows[1][i], expected.g, 3e-6 * expected.g);
  }
}

TEST_F(ShadeRows, AreFiniteWhereDirectionsVanish) {
  // At the light, at the eye, without a normal, with the light opposite to the eye, and grazing.
  const std::vector<float> x{2, 0, 0, 1, 0.5F};
  const std::vector<float> y{1, 0, 0, 0.5F, 0};
  const std::vector<float> z{3, 5, 0, 4, 0};
  const std::vector<float> nx{0, 0, 0, 0, 1};
  const std::vector<float> ny{0, 0, 0, 0, 0};
  const std::vector<float> nz{1, 1, 0, 1, 0};
  for (const RowModel& model : kRowModels) {
    for (const AttenuationKind& kind : kAttenuations) {
      for (const double n : {0.0, 1.0, 1e6}) {
        RowShading shading = shading_of(model);
        const Light light = PointLight{.position = {2, 1, 3},
                                       .intensity = {1, 1, 1},
                                       .attenuation = {.kind = kind, .c1 = 0, .c2 = 0, .c3 = 0}};
        shading.lights = {&light, 1};
        shading.material.n = n;
        shading.m = 1e-4;
        Lit lit(5);
        shade_rows(shading, {x, y, z, nx, ny, nz}, lit.view());
        for (const auto& row : lit.rows) {
          for (const float value : row) EXPECT_TRUE(std::isfinite(value)) << model.name;
        }
      }
    }
  }
}

TEST_F(ShadeRows, RefuseWhatTheyCannotShade) {
  const Surface surface(8);
  Lit lit(7);
  EXPECT_THROW(shade_rows(shading_of(kPhongRows), surface.view(8), lit.view()),
               std::invalid_argument);
  Lit fits(8);
  RowShading shading = shading_of(kPhongRows);
  shading.material.n = -1;
  EXPECT_THROW(shade_rows(shading, surface.view(8), fits.view()), std::invalid_argument);
  shading = shading_of(kCookTorranceRows);
  shading.m = 0;
  EXPECT_THROW(shade_rows(shading, surface.view(8), fits.view()), std::invalid_argument);
  const Light wide = SpotLight{.cutoff_deg = 181};
  RowShading spot = shading_of(kPhongRows);
  spot.lights = {&wide, 1};
  EXPECT_THROW(shade_rows(spot, surface.view(8), fits.view()), std::invalid_argument);
  shading.m = 0.3;
  shading.eta = 0;
  EXPECT_THROW(shade_rows(shading, surface.view(8), fits.view()), std::invalid_argument);
}

TEST_F(ShadeRows, PowersAreWithinTwoUlp) {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> base(0, 1);
  std::vector<float> x(20001);
  for (float& value : x) value = base(random);
  x[0] = 1;
  std::vector<float> fast(x.size());
  std::vector<float> scalar(x.size());
  double largest = 0;
  for (const float n : {0.0F, 0.3F, 1.0F, 2.0F, 8.0F, 77.7F, 1000.0F, 1e6F, -1.5F}) {
    power_row(x, n, fast);
    detail::power_row_scalar(x, n, scalar);
    EXPECT_EQ(fast, scalar);
    EXPECT_EQ(fast[0], 1);
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double expected = std::pow(double{x[i]}, double{n});
      if (x[i] > 0 && expected > 1.2e-38) {
        const float rounded = static_cast<float>(expected);
        const double ulp =
            std::nextafter(rounded, std::numeric_limits<float>::infinity()) - rounded;
        largest = std::max(largest, std::fabs(fast[i] - expected) / ulp);
      } else {
        EXPECT_LT(fast[i], 1.3e-38F);
      }
    }
  }
  EXPECT_LT(largest, 1.5);  // measured: 1.38
}

TEST_F(ShadeRows, PowersOfNothingAreNothing) {
  const std::vector<float> x{0, -1, -0.0F};
  std::vector<float> out(3, 7);
  for (const float n : {0.0F, 1.0F, 2.5F}) {
    power_row(x, n, out);
    EXPECT_EQ(out, std::vector<float>(3, 0.0F));
  }
}

}  // namespace
}  // namespace tristim
