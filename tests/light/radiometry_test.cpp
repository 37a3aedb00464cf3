#include "tristim/light/radiometry.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "tests/error_text.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979324;
const Vector3d kUp(0, 0, 1);

TEST(Radiometry, Definitions) {
  EXPECT_EQ(cone_solid_angle_sr(90), 2 * kPi);
  EXPECT_EQ(cone_solid_angle_sr(180), 4 * kPi);
  EXPECT_NEAR(cone_solid_angle_sr(1e-6) / 9.5698384815740175e-16, 1, 3e-16);
  EXPECT_EQ(radiant_intensity(4 * kPi, cone_solid_angle_sr(180)), 1);
  EXPECT_EQ(foreshortened_area(2, kUp, Vector3d(0.6, 0, 0.8)), 1.6);
  EXPECT_EQ(foreshortened_area(2, kUp, -kUp), 0);
  EXPECT_EQ(radiance(8, 2, kUp, Vector3d(0.6, 0, 0.8)), 5);
  EXPECT_EQ(radiance(8, 2, kUp, Vector3d(1, 0, 0)), std::numeric_limits<double>::infinity());
  EXPECT_EQ(irradiance(10, kUp, Vector3d(0.6, 0, 0.8), 0.5), 4);
  EXPECT_NEAR(lambert_reflectivity(0.5), 0.5 / kPi, 3e-17);
}

TEST(ReflectivitySplit, PartsAddUpToOne) {
  EXPECT_EQ(reflectivity({0.25, 0.75}, 0.5, 1), 0.875);
  EXPECT_NO_THROW(check_split({0.3, 0.7}));
  EXPECT_EQ(error_text([] {
              check_split({0.5, 0.75});
            }),
            "invalid: kd 0.5 and ks 0.75 are not 0..1 and together 1");
  EXPECT_EQ(error_text([] {
              check_split({1.5, -0.5});
            }),
            "invalid: kd 1.5 and ks -0.5 are not 0..1 and together 1");
}

TEST(ReflectedRadiance, AddsAmbientAndSources) {
  const ReflectivitySplit split{0.5, 0.5};
  const std::array sources{RadiantSource{kUp, 8, 0.25, 1}, RadiantSource{-kUp, 100, 1, 1}};
  // rho_d Ia + I N.L dw (kd rho_d + ks rho_s); the second is behind.
  EXPECT_EQ(reflected_radiance(split, 0.5, 4, kUp, sources), 2 + 8 * 0.25 * 0.75);
  const std::array colored{RadiantSourceOf<Rgb>{kUp, {8, 4, 0}, 0.25, {1, 0, 1}}};
  EXPECT_EQ(reflected_radiance(split, Rgb{0.5, 1, 1}, Rgb{4, 0, 1}, kUp, colored),
            (Rgb{3.5, 0.5, 1}));
}

}  // namespace
}  // namespace tristim
