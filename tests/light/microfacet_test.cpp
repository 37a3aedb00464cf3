#include "tristim/light/microfacet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using Eigen::Vector3d;

constexpr double kDegree = 0.017453292519943295;
constexpr double kPi = 3.14159265358979324;
const Vector3d kUp(0, 0, 1);
const Reflector kMirror = Conductor{.eta = 1, .k = 1e100};  // F = 1

Vector3d at(double theta_deg, double phi_deg = 0) {
  const double sine = std::sin(theta_deg * kDegree);
  return {sine * std::cos(phi_deg * kDegree), sine * std::sin(phi_deg * kDegree),
          std::cos(theta_deg * kDegree)};
}

TEST(MicrofacetDistribution, DensitiesAreThePrintedOnes) {
  // cos beta, m, then Gauss, Beckmann and Blinn from mpmath with 40 digits.
  constexpr double kRows[][5] = {
      {1, 0.1, 1.0, 99.9999999999999889, 31.8309886183790636},
      {0.99, 0.1, 0.134883713814517959, 13.6667581059625807, 4.35129630190583394},
      {0.9, 0.3, 0.104321288143477781, 1.24991763552811516, 0.420038864157228662},
      {0.5, 1, 0.333997185986131785, 0.796593093885823088, 0.318309886183790672},
      {0.2, 0.5, 0.000552285082410471061, 5.07773165683708256e-39, 0.0000814873308630504391},
      {0.9999999, 0.05, 0.999920003198623547, 399.968161262423471, 127.313794426837867},
      {0, 1, 0.0848049724711137766, 0, 0}};
  for (const auto& row : kRows) {
    for (std::size_t i = 0; i < 3; ++i) {
      SCOPED_TRACE(testing::Message() << kMicrofacetDistributions[i].name << ' ' << row[0]);
      // largest relative error measured: 1.6e-16
      EXPECT_NEAR(microfacet_density(kMicrofacetDistributions[i], row[0], row[1]), row[2 + i],
                  3e-16 * row[2 + i]);
    }
  }
}

TEST(MicrofacetDistribution, GaussIsNormalisedByATable) {
  // 1/(2 pi int e^-(b/m)^2 cos b sin b db) from mpmath.
  constexpr double kRows[][2] = {{0.05, 127.536302569038324}, {0.1, 32.0437616316269748},
                                 {0.3, 3.75411917792699318},  {0.6, 1.11734621337323684},
                                 {1, 0.581188446952098311},   {3, 0.34470731336275788}};
  for (const auto& [m, c1] : kRows) {
    SCOPED_TRACE(m);
    EXPECT_NEAR(microfacet_normaliser(kGauss, m), c1, 1e-14 * c1);
  }
}

TEST(MicrofacetDistribution, NormalisedAreaIsOne) {
  constexpr int kSteps = 20000;
  for (const MicrofacetDistribution& distribution : kMicrofacetDistributions) {
    for (double m : {0.05, 0.1, 0.5, 1.0, 2.0}) {
      SCOPED_TRACE(testing::Message() << distribution.name << ' ' << m);
      double sum = 0;
      for (int i = 0; i < kSteps; ++i) {
        const double beta = (i + 0.5) / kSteps * kPi / 2;
        sum +=
            microfacet_density(distribution, std::cos(beta), m) * std::cos(beta) * std::sin(beta);
      }
      const double area = sum / kSteps * kPi * kPi;
      EXPECT_NEAR(area * microfacet_normaliser(distribution, m), 1, 1e-6);  // the midpoint rule's
    }
  }
}

TEST(TorranceSparrow, IsDarkWhereLightOrEyeIsBehind) {
  const Microfacets surface;
  EXPECT_EQ(torrance_sparrow(surface, kMirror, kUp, at(91), at(10)), 0);
  EXPECT_EQ(torrance_sparrow(surface, kMirror, kUp, at(10), at(-91)), 0);
  EXPECT_EQ(torrance_sparrow(surface, kMirror, kUp, kUp, -kUp), 0);
  EXPECT_EQ(geometric_attenuation(kUp, at(10), at(-91)).factor, 0);
}

TEST(TorranceSparrow, NormalizationsDifferByTheFactorsOfTheirFormulas) {
  const Vector3d light = at(30);
  const Vector3d eye = at(20, 130);
  const Microfacets seed{kBeckmann, kSeedNormalization, 0.4};
  const Microfacets energy{kBeckmann, kEnergyNormalization, 0.4};
  EXPECT_NEAR(torrance_sparrow(seed, kMirror, kUp, light, eye) /
                  torrance_sparrow(energy, kMirror, kUp, light, eye),
              4, 2e-15);
}

TEST(TorranceSparrow, LightAndEyeChangePlaces) {
  const Reflector glass = Dielectric{1, 1.5};
  for (const MicrofacetDistribution& distribution : kMicrofacetDistributions) {
    for (const MicrofacetNormalization& normalization : kMicrofacetNormalizations) {
      const Microfacets surface{distribution, normalization, 0.35};
      for (int i = 0; i < 400; ++i) {
        const Vector3d light = at(89.5 * std::fmod(i * 0.618034, 1), 360 * std::fmod(i * 0.71, 1));
        const Vector3d eye = at(89.9 * std::fmod(i * 0.414214, 1), 360 * std::fmod(i * 0.37, 1));
        const double there = torrance_sparrow(surface, glass, kUp, light, eye);
        EXPECT_NEAR(there, torrance_sparrow(surface, glass, kUp, eye, light), 1e-15 * there);
      }
    }
  }
}

TEST(TorranceSparrow, EnergyNeverReflectsMoreThanArrives) {
  for (double m : {0.05, 0.1, 0.3, 0.6, 1.0}) {
    for (double theta : {0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.0}) {
      SCOPED_TRACE(testing::Message() << m << ' ' << theta);
      const Microfacets surface{.m = m};
      const double albedo = directional_albedo(surface, kMirror, theta, 32);
      EXPECT_LE(albedo, 1 + 1e-4);  // the quadrature's error across the edge of G
      EXPECT_GT(albedo, m > 0.5 ? 0.1 : 0.5);
    }
  }
  const Microfacets seed{kBeckmann, kSeedNormalization, 0.1};
  EXPECT_NEAR(directional_albedo(seed, kMirror, 0), 4.00, 0.005);
  EXPECT_NEAR(directional_albedo({.m = 0.1}, kMirror, 0), 1.00, 0.005);
}

TEST(TorranceSparrow, HighlightIsTheLightsColourAtGrazingAngles) {
  // Copper at 650, 550 and 450 nm [Palik85].
  const std::vector<Reflector> copper{Conductor{0.214, 3.670}, Conductor{1.040, 2.590},
                                      Conductor{1.170, 2.400}};
  const std::span<const Reflector, 3> reflectors(copper.data(), 3);
  const Microfacets surface{.m = 0.2};
  const Rgb steep = torrance_sparrow(surface, reflectors, kUp, at(5), at(-5));
  const Rgb flat = torrance_sparrow(surface, reflectors, kUp, at(89.9), at(-89.9));
  EXPECT_GT(steep.r / steep.b, 1.6);
  EXPECT_NEAR(flat.r / flat.b, 1, 0.01);
  EXPECT_EQ(steep.g, torrance_sparrow(surface, copper[1], kUp, at(5), at(-5)));
}

TEST(TorranceSparrow, FiniteInputIsNeverNan) {
  const double large = std::numeric_limits<double>::max();
  const Vector3d vectors[] = {{0, 0, 0},     {0, 0, 1},          {1e-320, 0, 0}, {0, 1e-160, 1},
                              {1e200, 0, 1}, {large, -large, 1}, {0.6, 0, 0.8},  {1, 0, 1e-300}};
  for (const MicrofacetDistribution& distribution : kMicrofacetDistributions) {
    for (const MicrofacetNormalization& normalization : kMicrofacetNormalizations) {
      for (double m : {0.0, 1e-320, 0.3, large}) {
        const Microfacets surface{distribution, normalization, m};
        for (const Vector3d& n : vectors) {
          for (const Vector3d& l : vectors) {
            for (const Vector3d& v : vectors) {
              ASSERT_FALSE(std::isnan(torrance_sparrow(surface, kMirror, n, l, v)))
                  << distribution.name << ' ' << m << ' ' << n.transpose() << ", " << l.transpose()
                  << ", " << v.transpose();
            }
          }
        }
      }
    }
  }
}

TEST(TorranceSparrow, AgreesWithTheExamples) {
  if (!shared_dir()) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row :
       example_rows(*shared_dir() / "spec/shade-examples/torrance_sparrow.csv")) {
    SCOPED_TRACE(row.text("id"));
    const auto vector = [&](const std::string& name) {
      return Vector3d(row.number(name + "x"), row.number(name + "y"), row.number(name + "z"));
    };
    const Vector3d n = vector("in_N");
    const Vector3d l = vector("in_L");
    const Vector3d v = vector("in_V");
    const auto expect = [&](double value, const std::string& column) {
      // V.H of the example, which is not quite symmetric, is small: 1.3e-15 measured.
      EXPECT_NEAR(value, row.number(column), 2e-15 * row.number(column)) << column;
    };
    const GeometricAttenuation g = geometric_attenuation(n, l, v);
    expect(g.blocked, "out_G_b");
    expect(g.shadowed, "out_G_s");
    expect(g.factor, "out_G");
    const Reflector glass = Dielectric{row.number("in_eta_i"), row.number("in_eta_t")};
    const double m = row.number("in_m");
    expect(torrance_sparrow({kGauss, kSeedNormalization, m}, glass, n, l, v),
           "out_rho_s_gauss_seed");
    expect(torrance_sparrow({kBeckmann, kSeedNormalization, m}, glass, n, l, v),
           "out_rho_s_beckmann_seed");
    expect(torrance_sparrow({kBeckmann, kEnergyNormalization, m}, glass, n, l, v),
           "out_rho_s_beckmann_energy");
  }
}

}  // namespace
}  // namespace tristim
