#include "tristim/light/fisher_woo.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/light/phong.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = 0.017453292519943295;

class Directions {
 public:
  Vector3d any() { return {component_(random_), component_(random_), component_(random_)}; }
  Vector3d unit() { return normalize(any()); }

 private:
  std::mt19937 random_{4};
  std::uniform_real_distribution<double> component_{-1, 1};
};

double true_r_dot_e(const Vector3d& n, const Vector3d& l, const Vector3d& e) {
  return dot(reflect(l, n), e);
}

TEST(HighlightFrame, IsThatOfFigure4) {
  const HighlightFrame frame = highlight_frame(90, 0, 90);
  EXPECT_EQ(frame.to_light, Vector3d(-1, 0, 0));
  EXPECT_EQ(frame.to_eye, Vector3d(0, 0, 1));
  EXPECT_EQ(frame.normal, Vector3d(-1, 0, 0));
  EXPECT_EQ(highlight_frame(0, 77, 0).normal, Vector3d(0, 1, 0));
  EXPECT_EQ(highlight_frame(90, 90, 0).normal, Vector3d(0, 0, 1));
  EXPECT_EQ(highlight_frame(90, 180, 180).normal, Vector3d(1, 0, 0));
  EXPECT_EQ(highlight_frame(90, 180, 180).to_light, Vector3d(0, 0, -1));
}

TEST(FisherWoo, RDotEFollowsFromNDotHForAnyDirections) {
  Directions directions;
  for (int i = 0; i < 10000; ++i) {
    const Vector3d n = directions.unit();
    const Vector3d l = directions.unit();
    const Vector3d e = directions.unit();
    const double expected = true_r_dot_e(n, l, e);
    EXPECT_NEAR(r_dot_e_from_half(n, l, e), expected, 1e-14);  // largest error measured: 1.4e-15
    // 1 + L.E loses digits near L = -E.
    EXPECT_NEAR(r_dot_e_from_eye(n, l, e), expected, 1e-14 / (1 + dot(l, e)));
  }
}

TEST(FisherWoo, CoplanarDirectionsHaveTwiceTheAngle) {
  for (const double alpha : {-30.0, 0.0, 12.0, 45.0}) {
    for (const double beta : {5.0, 20.0, 40.0}) {
      const auto at = [](double degrees) {
        return Vector3d(std::sin(degrees * kDegree), 0, std::cos(degrees * kDegree));
      };
      const Vector3d l = at(alpha);
      const Vector3d e = at(alpha + 2 * beta);
      const double n_dot_h = dot(at(0), half_vector(l, e));
      EXPECT_NEAR(coplanar_r_dot_e(n_dot_h), true_r_dot_e(at(0), l, e), 1e-15);
      EXPECT_NEAR(r_dot_e(alpha + beta, beta, 90), std::cos(2 * (alpha + beta) * kDegree), 1e-15);
    }
  }
}

TEST(FisherWoo, EquationSevenHoldsInTheFrame) {
  for (const double theta : {0.0, 25.0, 90.0, 140.0}) {
    for (const double phi : {0.0, 33.0, 90.0, 170.0}) {
      for (const double le : {0.0, 45.0, 90.0, 160.0}) {
        const auto [l, e, n] = highlight_frame(theta, phi, le);
        const double nu = std::acos(dot(n, half_vector(l, e))) / kDegree;
        EXPECT_NEAR(r_dot_e(nu, le / 2, theta), true_r_dot_e(n, l, e), 1e-7 * kDegree);
      }
    }
  }
}

TEST(FisherWoo, OppositeDirectionsHaveNoHalfVector) {
  const Vector3d l(0.6, 0, 0.8);
  const Vector3d n(0, 1, 0);
  EXPECT_EQ(r_dot_e_from_half(n, l, -l), -1);
  EXPECT_EQ(r_dot_e_from_eye(n, l, -l), -1);
}

TEST(FisherWoo, GramIdentityHoldsForAnyLengths) {
  Directions directions;
  for (int i = 0; i < 10000; ++i) {
    const Vector3d a = directions.any();
    const Vector3d b = 100 * directions.any();
    const Vector3d c = 0.1 * directions.any();
    const double volume = triple_product(a, b, c);
    const double scale = dot(a, a) * dot(b, b) * dot(c, c);
    EXPECT_NEAR(gram_determinant(a, b, c), volume * volume, 1e-14 * scale);
    EXPECT_NEAR(unit_gram_identity(normalize(a), normalize(b), normalize(c)), 0, 3e-15);
  }
  EXPECT_EQ(triple_product(Vector3d(1, 0, 0), Vector3d(0, 2, 0), Vector3d(0, 0, 3)), 6);
  EXPECT_EQ(gram_determinant(Vector3d(1, 0, 0), Vector3d(0, 2, 0), Vector3d(0, 0, 3)), 36);
}

TEST(ExponentFactor, IsFourAtTheHighlightAndInfiniteAtNinetyDegrees) {
  EXPECT_EQ(exponent_factor(0), 4);
  EXPECT_EQ(exponent_factor(1e-200), 4);
  // f = 4 + rho^2/2 + 5 rho^4/96 + ...
  const double rho = 0.001 * kDegree;
  EXPECT_NEAR(exponent_factor(0.001), 4 + rho * rho / 2, 1e-15);
  EXPECT_EQ(exponent_factor(-20), exponent_factor(20));
  EXPECT_TRUE(std::isinf(exponent_factor(90)));
  EXPECT_TRUE(std::isinf(exponent_factor(135)));
  EXPECT_TRUE(std::isnan(exponent_factor(std::nan(""))));
}

TEST(ExponentFactor, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row :
       example_rows(*shared_dir() / "spec/shade-examples/exponent_factor.csv")) {
    SCOPED_TRACE(row.text("id"));
    EXPECT_NEAR(exponent_factor(row.number("in_rho_deg")), row.number("out_f"), 2e-15);
  }
}

// The paper's first extreme: R stays at the eye while N turns by 90 degrees from H.
TEST(FisherWoo, LightAlmostBehindTheObjectHasOneRAndAnyNu) {
  constexpr double kEpsilon = 1e-6;
  const Vector3d e(0, 0, 1);
  const Vector3d l = normalize(Vector3d(-kEpsilon, 0, -1));
  const Vector3d h = half_vector(l, e);
  for (const double turn : {0.0, 45.0, 90.0}) {
    const Vector3d n(-std::cos(turn * kDegree), std::sin(turn * kDegree), 0);
    EXPECT_NEAR(true_r_dot_e(n, l, e), 1, 1e-11);                // rho ~ 0
    EXPECT_NEAR(dot(n, h), std::cos(turn * kDegree), kEpsilon);  // nu = turn
  }
}

// The second: rho is 90 degrees everywhere, and nu 90 to 45.
TEST(FisherWoo, LightFromTheSideKeepsRAtNinetyDegrees) {
  const Vector3d e(0, 0, 1);
  const Vector3d l(-1, 0, 0);
  for (const double turn : {0.0, 30.0, 90.0}) {
    const Vector3d n(-std::sin(turn * kDegree), std::cos(turn * kDegree), 0);
    EXPECT_NEAR(true_r_dot_e(n, l, e), 0, 1e-16);
    EXPECT_NEAR(dot(n, half_vector(l, e)), std::sin(turn * kDegree) / std::sqrt(2), 1e-15);
  }
  const HighlightFrame worst{l, e, l};
  EXPECT_NEAR(pixel_error(worst, 2.5, 4), -7.97, 0.005);  // 255 cos^10 45
}

TEST(PixelError, HasTheSignOfTable3AndEquation6TheOther) {
  const HighlightFrame coplanar = highlight_frame(90, 45 + 20, 90);  // nu = 20, rho = 40
  EXPECT_NEAR(pixel_error(coplanar, 10, 4), -coplanar_pixel_error(40, 10), 1e-12);
  EXPECT_GT(coplanar_pixel_error(40, 10), 0);
  EXPECT_EQ(coplanar_pixel_error(0, 10), 0);
  EXPECT_NEAR(coplanar_pixel_error(120, 1), 255 * std::pow(std::cos(60 * kDegree), 4), 1e-12);
}

// Light from behind, 135 degrees from the eye: at N.L = 0 the lobe (N.H)^8 is still 0.53.
TEST(PixelError, LobesDoNotVanishAtTheTerminator) {
  const auto [l, e, n] = highlight_frame(90, 45, 135);
  EXPECT_NEAR(dot(n, l), 0, 1e-16);
  EXPECT_NEAR(std::pow(dot(n, half_vector(l, e)), 8), 0.53, 0.005);
}

TEST(PixelError, BothModelsHaveTheirHighlightWhereNIsH) {
  for (const double le : {10.0, 60.0, 120.0, 170.0}) {
    const auto [l, e, n] = highlight_frame(90, 0 + (180 - le) / 2 + le / 2, le);
    const Vector3d h = half_vector(l, e);
    EXPECT_NEAR(true_r_dot_e(h, l, e), 1, 1e-14);
    Directions directions;
    for (int i = 0; i < 100; ++i) EXPECT_LT(true_r_dot_e(directions.unit(), l, e), 1 + 1e-14);
  }
}

TEST(PixelError, IsZeroOnAContourBetweenTheTwoGreatCircles) {
  const double n_dot_h = std::cos(15 * kDegree);
  const double cos_theta = zero_error_cos_theta(n_dot_h, 4, 90);
  ASSERT_GT(cos_theta, 0);
  // N from its components along H, across it, and along y.
  const auto [l, e, unused] = highlight_frame(90, 90, 90);
  const Vector3d h = half_vector(l, e);
  const Vector3d across(h.z(), 0, -h.x());
  const double rest = std::sqrt(1 - n_dot_h * n_dot_h - cos_theta * cos_theta);
  const Vector3d n = n_dot_h * h + cos_theta * Vector3d(0, 1, 0) + rest * across;
  EXPECT_NEAR(pixel_error({l, e, n}, 10, 4), 0, 1e-12);
  EXPECT_TRUE(std::isnan(zero_error_cos_theta(std::cos(40 * kDegree), 4, 10)));
}

}  // namespace
}  // namespace tristim
