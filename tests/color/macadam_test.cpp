#include "tristim/color/macadam.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "tests/error_text.h"
#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/observer.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const OptimalColors& under(std::string_view illuminant) {
  static const OptimalColors a = optimal_colors(*find_by_name(illuminants(), "a"));
  static const OptimalColors c = optimal_colors(*find_by_name(illuminants(), "c"));
  static const OptimalColors d65 = optimal_colors(*find_by_name(illuminants(), "d65"));
  return same_name(illuminant, "a") ? a : same_name(illuminant, "c") ? c : d65;
}

// What a reflectance looks like under illuminant C, by the sums that define it.
Xyy colour_of(const std::vector<double>& reflectance) {
  const Spectrum light = illuminant_spectrum(*find_by_name(illuminants(), "c"));
  Spectrum spectrum;
  for (std::size_t i = 0; i < kSum5nm.count(); ++i)
    spectrum.lambda_nm.push_back(kSum5nm.lambda_nm(i));
  spectrum.value = reflectance;
  return xyz_to_xyy(xyz_of_object(spectrum, light, observers().front()));
}

TEST(OptimalColors, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/macadam_limits.csv")) {
    SCOPED_TRACE(row.text("id"));
    const double limit = under(row.text("illuminant")).limit({row.number("x"), row.number("y")});
    EXPECT_NEAR(100 * limit, row.number("Ymax"), 1e-4);  // the file allows .01: tables of A, D65
  }
}

// Solved as a linear programme by others; and the white, which alone reflects all.
TEST(OptimalColors, AgreesWithALinearProgramme) {
  EXPECT_NEAR(under("a").limit({0.0766, 0.512}), 0.1564512364483409, 1e-6);
  for (const char* name : {"a", "c", "d65"}) {
    EXPECT_NEAR(under(name).limit(under(name).white()), 1, 1e-12);
  }
  EXPECT_NEAR(under("c").white().x, 0.31006, 5e-6);
}

// Full within a band of wavelengths and empty outside, or the reverse, each transition anywhere in
// a band: nothing of that chromaticity is brighter, but for .01 of Y = 100, as the digits of the
// table leave the locus not quite convex. Its straight part, in the red, has many spectra that are
// as bright.
RC_GTEST_PROP(OptimalColors, AreSpectraWithTwoTransitions, ()) {
  const auto first = *rc::gen::inRange<std::size_t>(14, 23);  // 450 to 490 nm
  const auto last = *rc::gen::inRange<std::size_t>(30, 39);   // 530 to 570 nm
  const bool full = *rc::gen::arbitrary<bool>();
  std::vector<double> reflectance(kSum5nm.count(), full ? 0 : 1);
  std::fill(reflectance.begin() + static_cast<std::ptrdiff_t>(first),
            reflectance.begin() + static_cast<std::ptrdiff_t>(last), full ? 1 : 0);
  reflectance[first] = *rc::gen::inRange(0, 1000) / 1000.0;
  reflectance[last] = *rc::gen::inRange(0, 1000) / 1000.0;
  const Xyy colour = colour_of(reflectance);
  if (colour.luminance < 1e-6) return;
  const double limit = under("c").limit({colour.x, colour.y});
  RC_ASSERT(limit > colour.luminance - 1e-12);
  RC_ASSERT(limit < colour.luminance + 1e-4);
}

RC_GTEST_PROP(OptimalColors, AreAsBrightAsAnyReflectance, ()) {
  std::vector<double> reflectance;
  for (std::size_t i = 0; i < kSum5nm.count(); ++i) {
    reflectance.push_back(*rc::gen::inRange(0, 100) / 99.0);
  }
  const Xyy colour = colour_of(reflectance);
  if (colour.luminance == 0) return;
  RC_ASSERT(under("c").limit({colour.x, colour.y}) >= colour.luminance - 1e-12);
  RC_ASSERT(under("c").contains({colour.x, colour.y, colour.luminance * 0.999999}));
}

TEST(OptimalColors, IncludeSpectralLights) {
  for (std::size_t i = 0; i < kSum5nm.count(); ++i) {
    std::vector<double> band(kSum5nm.count(), 0.0);
    band[i] = 1;
    const Xyy colour = colour_of(band);
    const double limit = under("c").limit({colour.x, colour.y});
    EXPECT_GE(limit, colour.luminance * (1 - 1e-6)) << kSum5nm.lambda_nm(i);
    if (kSum5nm.lambda_nm(i) == 520) {  // where the locus bends most: no other bands mix it
      EXPECT_NEAR(limit, colour.luminance, 1e-12);
    }
  }
}

// By the definition, without the search: the nearest of all planes through a pair of bands.
double lowest_of_all_faces(const std::vector<Eigen::Vector3d>& bands, Chromaticity c) {
  const Eigen::Vector3d direction(c.x, c.y, 1 - c.x - c.y);
  double lowest = 1e9;
  for (std::size_t i = 0; i < bands.size(); ++i) {
    for (std::size_t j = 0; j < bands.size(); ++j) {
      const Eigen::Vector3d normal = bands[i].cross(bands[j]);
      const double towards = normal.dot(direction);
      if (!(towards > 0)) continue;
      double distance = 0;
      for (std::size_t k = 0; k < bands.size(); ++k) {
        if (k != i && k != j) distance += std::max(normal.dot(bands[k]), 0.0);
      }
      lowest = std::min(lowest, distance / towards);
    }
  }
  return lowest * c.y;
}

TEST(OptimalColors, AreTheNearestOfAllFaces) {
  std::vector<Eigen::Vector3d> bands;
  const std::vector<double> power =
      sampled(illuminant_spectrum(*find_by_name(illuminants(), "c")), kSum5nm);
  Eigen::Vector3d white = Eigen::Vector3d::Zero();
  for (std::size_t i = 0; i < power.size(); ++i) {
    const Xyz match = matching_functions(observers().front(), kSum5nm.lambda_nm(i));
    bands.emplace_back(power[i] * match.x, power[i] * match.y, power[i] * match.z);
    white += bands.back();
  }
  for (Eigen::Vector3d& band : bands) band /= white.y();
  const Chromaticity centre = under("c").white();
  for (int nm = 430; nm <= 650; nm += 20) {  // towards each wavelength, from the white to the rim
    const Xyz match = matching_functions(observers().front(), nm);
    const Xyy rim = xyz_to_xyy(match);
    for (const double part : {0.001, 0.03, 0.3, 0.7, 0.97, 0.9999}) {
      const Chromaticity c{centre.x + part * (rim.x - centre.x),
                           centre.y + part * (rim.y - centre.y)};
      EXPECT_NEAR(under("c").limit(c), lowest_of_all_faces(bands, c), 1e-11) << nm << " " << part;
    }
  }
}

TEST(OptimalColors, HaveNoLuminanceOutsideOfTheLocus) {
  const OptimalColors& c = under("c");
  for (const Chromaticity outside :
       {Chromaticity{0.1, 0.05}, {0.6, 0.5}, {0, 0}, {-1, 2}, {5, 5}, {0.45, 0.1}, {1e300, 0.3}}) {
    EXPECT_EQ(c.limit(outside), 0) << outside.x << " " << outside.y;
    EXPECT_FALSE(c.contains({outside.x, outside.y, 0.1}));
    EXPECT_TRUE(c.contains({outside.x, outside.y, 0}));  // black
  }
  EXPECT_TRUE(std::isnan(c.limit({std::nan(""), 0.3})));
  EXPECT_FALSE(c.contains({std::nan(""), 0.3, 0.1}));
  EXPECT_TRUE(c.contains({std::nan(""), std::nan(""), 0}));
  EXPECT_FALSE(c.contains({0.31, 0.316, -0.1}));
  EXPECT_FALSE(c.contains({0.31, 0.316, 1.01}));
}

TEST(OptimalColors, ReachTheirBoundary) {
  const OptimalColors& c = under("c");
  double area = 1;
  for (const double luminance : {0.0, 0.1, 0.2, 0.5, 0.8, 0.95}) {
    Polygon polygon;
    for (const Chromaticity corner : c.boundary(luminance)) {
      polygon.push_back({corner.x, corner.y});
      if (luminance > 0.1) {
        EXPECT_NEAR(c.limit(corner), luminance, 1e-10);
      }
    }
    EXPECT_LT(polygon_area(polygon), area);  // each within the one before
    area = polygon_area(polygon);
    EXPECT_GT(polygon.size(), 20U);
  }
  EXPECT_TRUE(c.boundary(1).empty());
  EXPECT_TRUE(c.boundary(-0.1).empty());
  EXPECT_TRUE(c.boundary(std::nan("")).empty());
}

// Three lights mix a cube of which the limits can be written down.
TEST(OptimalColors, AreThoseOfThreeLights) {
  const Xyz bands[] = {{0.2, 0.2, 0}, {0, 0.6, 0}, {0, 0.2, 0.2}};
  const OptimalColors colors(bands);
  const Xyy half = xyz_to_xyy({0.2, 0.2 + 0.3 + 0.1, 0.1});  // the first full
  EXPECT_NEAR(colors.limit({half.x, half.y}), 0.6, 1e-15);
  EXPECT_NEAR(colors.limit({0.5, 0.5}), 0.2, 1e-15);  // the first alone, on the edge
  EXPECT_NEAR(colors.limit({0, 1}), 0.6, 1e-15);
  EXPECT_NEAR(colors.limit(colors.white()), 1, 1e-15);
}

TEST(OptimalColors, RefuseDarkness) {
  const char* text = "invalid: bands: their luminance must be above 0 and finite";
  const Xyz dark[] = {{0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(error_text([&] { OptimalColors colors(dark); }), text);
  EXPECT_EQ(error_text([&] { OptimalColors colors(std::span<const Xyz>{}); }), text);
}

}  // namespace
}  // namespace tristim
