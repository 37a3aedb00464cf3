#include "tristim/light/phong.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/core/find.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = 0.017453292519943295;
const Vector3d kUp(0, 0, 1);

// In the plane of x and z, `degrees` from the normal kUp.
Vector3d at(double degrees) {
  return {std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree)};
}

struct LobeRow {
  double light_deg, eye_deg, n;
  double phong, blinn;
};

// With N, L and V in one plane [R,V] is light_deg + eye_deg and [N,H] half of it [FisherWoo, eq.
// 1]; the powers of their cosines from mpmath with 40 digits.
// clang-format off
constexpr LobeRow kLobes[] = {
    {60, 0, 2, 0.25, 0.75},
    {30, 30, 1, 0.5, 0.86602540378443865},
    {45, -45, 300, 1.0, 1.0},
    {20, -50, 8, 0.31640625, 0.75779236415569191},
    {10, 5, 200, 0.00097444116098816334, 0.17935489574559143},
    {10, 5, 0.5, 0.9828152554214186, 0.99571324254215401},
    {80, -70, 37.5, 0.56322213090787863, 0.86677918921798796},
    {5, -8, 1000, 0.25375014129603693, 0.70982717721801911},
    {75, 0, 4, 0.0044872981077806766, 0.39615634707820555},
    {70, 60, 0, 0.0, 1.0},
    {40, 30, 0, 1.0, 1.0},
};
// clang-format on

TEST(SpecularModel, LobesAreTheCosinesPowers) {
  for (const LobeRow& row : kLobes) {
    SCOPED_TRACE(testing::Message() << row.light_deg << ' ' << row.eye_deg << ' ' << row.n);
    // A rounding of the cosine is amplified n times.
    const double tolerance = 1e-15 * (2 + row.n);
    EXPECT_NEAR(phong_lobe(kUp, at(row.light_deg), at(row.eye_deg), row.n), row.phong,
                tolerance * row.phong);
    EXPECT_NEAR(blinn_phong_lobe(kUp, at(row.light_deg), at(row.eye_deg), row.n), row.blinn,
                tolerance * row.blinn);
  }
}

// E = z, L = -x, N in the plane of x and y: [R,E] is 90 degrees everywhere, [N,H] 45 at N = L.
TEST(SpecularModel, DiffersMostWhereFisherAndWooSay) {
  const Vector3d left(-1, 0, 0);
  EXPECT_EQ(phong_lobe(left, left, kUp, 10), 0);
  EXPECT_NEAR(255 * blinn_phong_lobe(left, left, kUp, 10), 7.97, 0.005);  // [FisherWoo], p. 397
}

TEST(SpecularModel, LightBehindTheSurfaceHasNoLobe) {
  for (const SpecularModel& model : kSpecularModels) {
    SCOPED_TRACE(model.name);
    for (double n : {0.0, 1.0, 8.0, 0.5}) {
      EXPECT_EQ(model.lobe(kUp, at(91), at(-89), n), 0);
      EXPECT_EQ(model.lobe(kUp, Vector3d(1, 0, 0), Vector3d(-1, 0, 0), n), 0);  // N.L = 0
    }
  }
}

TEST(SpecularModel, ExponentZeroIsOneInsideTheLobeOnly) {
  EXPECT_EQ(phong_lobe(kUp, at(40), at(49), 0), 1);  // R.V > 0
  EXPECT_EQ(phong_lobe(kUp, at(40), at(51), 0), 0);  // R.V < 0
  EXPECT_EQ(blinn_phong_lobe(kUp, at(40), at(51), 0), 1);
}

TEST(SpecularModel, SurfaceSeenFromBehindKeepsItsHighlight) {
  EXPECT_GT(phong_lobe(kUp, at(85), at(-95), 3), 0);  // N.V < 0
  EXPECT_GT(blinn_phong_lobe(kUp, at(85), at(-91), 3), 0);
}

TEST(SpecularModel, OppositeLightAndEyeHaveNoHalfVector) {
  EXPECT_EQ(blinn_phong_lobe(kUp, at(30), -at(30), 5), 0);
  EXPECT_EQ(blinn_phong_lobe(kUp, at(30), -at(30), 0), 0);
}

TEST(SpecularModel, HighlightIsWholeAndAtOnePlace) {
  for (const SpecularModel& model : kSpecularModels) {
    SCOPED_TRACE(model.name);
    EXPECT_NEAR(model.lobe(kUp, at(35), at(-35), 100), 1, 1e-13);
    EXPECT_LT(model.lobe(kUp, at(35), at(-30), 100), 1);
    EXPECT_LT(model.lobe(kUp, at(35), at(-40), 100), 1);
  }
}

TEST(Shade, AddsAmbientAndEveryLight) {
  const Material material{
      .ka = 0.5, .kd = 0.25, .ks = 0.125, .n = 3, .od = {1, 0.5, 0}, .os = {1, 1, 2}};
  const Rgb ambient{0.5, 1, 4};
  const DirectionalLight above{.to_light = {0, 0, 2}, .intensity = {8, 16, 32}};
  const PointLight lamp{.position = {0, 0, 2},
                        .intensity = {32, 32, 32},
                        .attenuation = {.kind = *find_by_name(kAttenuations, "inverse_square")}};
  const DirectionalLight below{.to_light = {0, 0, -1}, .intensity = {100, 100, 100}};
  const std::vector<Light> lights{above, lamp, below};
  for (const SpecularModel& model : kSpecularModels) {
    SCOPED_TRACE(model.name);
    // Exact in binary: ka Ia Od + (Ip + Ip/d^2) (kd Od + ks Os), straight above.
    EXPECT_EQ(shade(material, model, kUp, kUp, Vector3d(0, 0, 0), ambient, lights),
              (Rgb{0.25 + 16 * 0.375, 0.25 + 24 * 0.25, 0 + 40 * 0.25}));
    EXPECT_EQ(shade(material, model, kUp, kUp, Vector3d(0, 0, 0), ambient, {}),
              (Rgb{0.25, 0.25, 0}));
  }
}

TEST(Shade, BlackSurfaceStaysBlackAtTheLight) {
  const PointLight lamp{.position = {0, 0, 1e-200},
                        .intensity = {1, 1, 0},
                        .attenuation = {.kind = *find_by_name(kAttenuations, "inverse_square")}};
  const std::vector<Light> lights{lamp};
  const Material red{.kd = 1, .od = {1, 0, 1}};
  const Rgb radiance = shade(red, kPhong, kUp, kUp, Vector3d(0, 0, 0), {}, lights);
  EXPECT_EQ(radiance, (Rgb{std::numeric_limits<double>::infinity(), 0, 0}));
}

TEST(Shade, FiniteInputIsNeverNan) {
  const double large = std::numeric_limits<double>::max();
  const Vector3d vectors[] = {{0, 0, 0},     {0, 0, 1},          {0, 0, -1},        {1e-320, 0, 0},
                              {1e200, 0, 1}, {large, -large, 1}, {-large, large, 0}};
  const Rgb colours[] = {{0, 1, large}, {1e-320, 0, 0}};
  for (const SpecularModel& model : kSpecularModels) {
    for (const AttenuationKind& kind : kAttenuations) {
      SCOPED_TRACE(testing::Message() << model.name << ' ' << kind.name);
      for (const Vector3d& normal : vectors) {
        for (const Vector3d& to_eye : vectors) {
          for (const Vector3d& place : vectors) {
            for (const Rgb& colour : colours) {
              for (double n : {0.0, 0.5, 3.0, large}) {
                const std::vector<Light> lights{
                    DirectionalLight{place, colour},
                    PointLight{place, colour, {.kind = kind, .c1 = 0, .c2 = large, .c3 = 1}}};
                const Material material{
                    .ka = 0, .kd = 0, .ks = large, .n = n, .od = colour, .os = colour};
                const Rgb radiance =
                    shade(material, model, normal, to_eye, Vector3d(0, 0, -large), colour, lights);
                ASSERT_FALSE(std::isnan(radiance.r + radiance.g + radiance.b));
              }
            }
          }
        }
      }
    }
  }
}

TEST(Shade, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row :
       example_rows(*shared_dir() / "spec/shade-examples/local_illumination.csv")) {
    SCOPED_TRACE(row.text("id"));
    const auto vector = [&](const std::string& name) {
      return Vector3d(row.number(name + "x"), row.number(name + "y"), row.number(name + "z"));
    };
    const auto colour = [&](const std::string& name) {
      return Rgb{row.number(name + "r"), row.number(name + "g"), row.number(name + "b")};
    };
    const Vector3d to_light = vector("in_L");
    const Vector3d normal = vector("in_N");
    const Vector3d to_eye = vector("in_V");
    const Material material{.ka = row.number("in_ka"),
                            .kd = row.number("in_kd"),
                            .ks = row.number("in_ks"),
                            .n = row.number("in_n"),
                            .od = colour("in_Od"),
                            .os = colour("in_Os")};
    const Rgb source = colour("in_Ip");
    const double f_att = row.number("in_fatt");
    const Incident arriving{to_light, {f_att * source.r, f_att * source.g, f_att * source.b}};
    // The cosine's rounding is amplified n times; largest relative error measured: 2.2e-14.
    const double tolerance = 1e-12;
    const auto expect = [&](double value, const std::string& column) {
      EXPECT_NEAR(value, row.number(column), tolerance * row.number(column)) << column;
    };
    expect(lambert(normal, to_light), "out_lambert");
    expect(phong_lobe(normal, to_light, to_eye, material.n), "out_spec_phong");
    expect(blinn_phong_lobe(normal, to_light, to_eye, material.n), "out_spec_blinn");
    for (const SpecularModel& model : kSpecularModels) {
      const Rgb ambient = ambient_reflection(material, colour("in_Ia"));
      const Rgb direct = direct_reflection(material, model, normal, to_eye, arriving);
      const std::string column = model.name == "phong" ? "out_I_phong" : "out_I_blinn";
      expect(ambient.r + direct.r, column + "r");
      expect(ambient.g + direct.g, column + "g");
      expect(ambient.b + direct.b, column + "b");
    }
  }
}

}  // namespace
}  // namespace tristim
