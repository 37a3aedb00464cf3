#include "tristim/light/refraction.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

const Vector3d kUp(0, 0, 1);

TEST(Refraction, BendsTowardsTheNormalInTheDenserMedium) {
  for (const RefractionForm& form : kRefractionForms) {
    SCOPED_TRACE(form.name);
    const Refraction glass = form.refract(Vector3d(0.6, 0, 0.8), kUp, 1, 1.5);
    EXPECT_NEAR(glass.transmitted.x(), -0.4, 1e-16);  // sin_t = .6/1.5
    EXPECT_NEAR(glass.transmitted.z(), -0.91651513899116801, 2e-16);
    EXPECT_NEAR(glass.cos_t, 0.91651513899116801, 2e-16);
    EXPECT_FALSE(glass.total_internal);
    // From below the normal turns round and the indices change places.
    const Refraction water = form.refract(Vector3d(0.6, 0, -0.8), kUp, 1, 1.25);
    EXPECT_NEAR(water.transmitted.x(), -0.75, 2e-16);
    EXPECT_NEAR(water.transmitted.z(), 0.66143782776614765, 2e-16);
    const Refraction straight = form.refract(kUp, kUp, 1, 1.5);
    EXPECT_EQ(straight.transmitted, Vector3d(0, 0, -1));
    EXPECT_EQ(straight.cos_t, 1);
  }
}

TEST(Refraction, NothingPassesBeyondTheCriticalAngle) {
  for (const RefractionForm& form : kRefractionForms) {
    SCOPED_TRACE(form.name);
    const Refraction beyond = form.refract(Vector3d(0.8, 0, 0.6), kUp, 1.5, 1);
    EXPECT_TRUE(beyond.total_internal);
    EXPECT_EQ(beyond.cos_t, 0);
    EXPECT_EQ(beyond.transmitted, Vector3d(0, 0, 0));
    // Equal indices, grazing: sin_t is 1.
    EXPECT_TRUE(form.refract(Vector3d(1, 0, 0), kUp, 1.5, 1.5).total_internal);
    EXPECT_FALSE(form.refract(Vector3d(1, 0, 1e-12), kUp, 1.5, 1.5).total_internal);
  }
}

// A hair inside the critical angle: sqrt(1 - 2.25 (1 - c^2)) of the rounded c from mpmath.
TEST(Refraction, KeepsItsDigitsAtTheCriticalAngle) {
  const double c = 0.7453559925;
  const Vector3d to_light(0.66666666666655484, 0, c);
  for (const RefractionForm& form : kRefractionForms) {
    SCOPED_TRACE(form.name);
    EXPECT_NEAR(form.refract(to_light, kUp, 1.5, 1).cos_t / 4.84736213507690706e-7, 1, 1e-11);
  }
}

TEST(Refraction, FiniteInputIsNeverNan) {
  const double large = std::numeric_limits<double>::max();
  const Vector3d vectors[] = {{0, 0, 0}, {0, 0, 1}, {1e-320, 0, 0}, {large, -large, 1}, {0, 1, 0}};
  for (const RefractionForm& form : kRefractionForms) {
    for (const Vector3d& to_light : vectors) {
      for (const Vector3d& normal : vectors) {
        for (double eta_i : {1e-320, 1.0, large}) {
          for (double eta_t : {1e-320, 1.5, large}) {
            const Refraction r = form.refract(to_light, normal, eta_i, eta_t);
            ASSERT_FALSE(std::isnan(r.cos_t) || r.transmitted.hasNaN())
                << form.name << ' ' << to_light.transpose() << ", " << normal.transpose() << ' '
                << eta_i << ' ' << eta_t;
          }
        }
      }
    }
  }
}

TEST(Refraction, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared_dir() / "spec/shade-examples/refraction.csv")) {
    const auto vector = [&](const std::string& name) {
      return Vector3d(row.number(name + "x"), row.number(name + "y"), row.number(name + "z"));
    };
    for (const RefractionForm& form : kRefractionForms) {
      SCOPED_TRACE(row.text("id") + std::string(form.name));
      const Refraction r = form.refract(vector("in_L"), vector("in_N"), row.number("in_eta_i"),
                                        row.number("in_eta_t"));
      EXPECT_EQ(r.total_internal, row.number("out_tir") != 0);
      EXPECT_DOUBLE_EQ(r.cos_t, row.number("out_cos_t"));
      for (int i = 0; i < 3; ++i) EXPECT_DOUBLE_EQ(r.transmitted[i], vector("out_T")[i]);
    }
  }
}

}  // namespace
}  // namespace tristim
