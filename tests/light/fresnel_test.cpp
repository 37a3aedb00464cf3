#include "tristim/light/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tristim {
namespace {

struct DielectricRow {
  double cos_i, eta_i, eta_t, reflectance;
};

// From mpmath with 40 digits.
// clang-format off
constexpr DielectricRow kDielectrics[] = {
    {1, 1, 1.5, 0.04},
    {0.5, 1, 1.5, 0.0891867128022127831},
    {0.0001, 1, 1.333, 0.999370114649357333},
    {0.8, 1.5, 1, 0.114141100221353853},
    {0.74535599249993, 1.5, 1, 0.999999888212221204},  // the critical angle
    {0.3, 1, 1.0000001, 2.58085826277158711e-13},
    {0.9, 2.417, 1.52, 0.0617127963869128429},
    {0.7, 1.5, 1, 1},  // beyond the critical angle
    {0, 1, 1.5, 1},
    {0, 1.5, 1.5, 1},
    {1e-300, 1.5, 1.5, 0},
    {0.6, 1.5, 1.5, 0},
};
// clang-format on

TEST(Fresnel, BothFormsAreTheDielectric) {
  for (const FresnelForm& form : kFresnelForms) {
    for (const DielectricRow& row : kDielectrics) {
      SCOPED_TRACE(testing::Message() << form.name << ' ' << row.cos_i << ' ' << row.eta_t);
      const double f = form.reflectance(row.cos_i, row.eta_i, row.eta_t);
      // largest relative error measured: 1.9e-16
      EXPECT_NEAR(f, row.reflectance, 4e-16 * row.reflectance);
      EXPECT_EQ(form.reflectance(-row.cos_i, row.eta_t, row.eta_i), row.cos_i > 0 ? f : 1);
      EXPECT_EQ(form.reflectance(3, row.eta_i, row.eta_t),
                form.reflectance(1, row.eta_i, row.eta_t));
    }
  }
}

TEST(Fresnel, ConductorHasAComplexIndex) {
  // From mpmath: ((c - q)/(c + q))^2 and ((n^2 c - q)/(n^2 c + q))^2, q = sqrt(n^2 - s^2).
  constexpr double kRows[][4] = {{1, 0.18, 3.42, 0.944991137461035389},
                                 {0.5, 0.18, 3.42, 0.939539840933417466},
                                 {0.01, 1.02, 6.85, 0.97949274201483689},
                                 {0.3, 1.5, 0, 0.207756343070897761},
                                 {0.6, 0.5, 0, 1},
                                 {0.5, 0.2, 0.1, 0.930488716766488649}};
  for (const auto& [cos_i, eta, k, expected] : kRows) {
    SCOPED_TRACE(testing::Message() << cos_i << ' ' << eta << ' ' << k);
    EXPECT_NEAR(fresnel_conductor(cos_i, eta, k), expected, 4e-16);
    EXPECT_EQ(fresnel(Conductor{eta, k}, cos_i), fresnel_conductor(cos_i, eta, k));
  }
  // Without absorption a conductor is a dielectric.
  for (double cos_i = 0; cos_i <= 1; cos_i += 0.0625) {
    EXPECT_NEAR(fresnel_conductor(cos_i, 1.5, 0), fresnel_dielectric(cos_i, 1, 1.5), 4e-16);
  }
}

TEST(Fresnel, NanStaysNan) {
  const double nan = std::nan("");
  EXPECT_TRUE(std::isnan(fresnel_dielectric(nan, 1, 1.5)));
  EXPECT_TRUE(std::isnan(fresnel_dielectric(0.5, nan, 1.5)));
  EXPECT_TRUE(std::isnan(fresnel_dielectric(0.5, 1, nan)));
}

TEST(Fresnel, IndexComesBackFromTheReflectance) {
  EXPECT_EQ(f0_from_eta(1.5), 0.04);
  EXPECT_EQ(eta_from_f0(0.04), 1.5);
  EXPECT_EQ(f0_from_eta(1), 0);
  EXPECT_EQ(eta_from_f0(0), 1);
  EXPECT_EQ(eta_from_f0(1), std::numeric_limits<double>::infinity());
  EXPECT_NEAR(eta_from_f0(f0_from_eta(0.5)), 2, 1e-15);
  EXPECT_NEAR(fresnel_dielectric(1, 1, 2.417), f0_from_eta(2.417), 1e-16);
}

TEST(Fresnel, IsBetweenZeroAndOneForAnyFiniteInput) {
  const double large = std::numeric_limits<double>::max();
  const double least = std::numeric_limits<double>::denorm_min();
  for (double cos_i : {-large, -1.0, -0.3, -least, 0.0, least, 1e-200, 0.5, 1.0, large}) {
    for (double a : {least, 1e-200, 0.5, 1.5, 1e200, large}) {
      for (double b : {least, 1e-200, 0.5, 1.5, 1e200, large}) {
        SCOPED_TRACE(testing::Message() << cos_i << ' ' << a << ' ' << b);
        for (const FresnelForm& form : kFresnelForms) {
          const double f = form.reflectance(cos_i, a, b);
          EXPECT_TRUE(f >= 0 && f <= 1) << form.name << ' ' << f;
        }
        for (const double k : {0.0, b}) {
          const double f = fresnel_conductor(cos_i, a, k);
          EXPECT_TRUE(f >= 0 && f <= 1) << f;
        }
      }
    }
  }
}

}  // namespace
}  // namespace tristim
