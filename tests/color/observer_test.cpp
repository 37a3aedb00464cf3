#include "tristim/color/observer.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/example_rows.h"
#include "tests/support.h"
#include "tristim/color/illuminant.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const Observer& kTwoDegrees = observers()[0];

Spectrum flat(double value) { return {{300, 830}, {value, value}}; }

// The reflectance of the examples: c0 + c1 exp(-((lambda - mu)/sigma)^2).
Spectrum reflectance_of(const ExampleRow& row) {
  Spectrum spectrum;
  for (int lambda = 380; lambda <= 780; lambda += 5) {
    const double z =
        row.number("sigma") == 0 ? 0 : (lambda - row.number("mu")) / row.number("sigma");
    spectrum.lambda_nm.push_back(lambda);
    spectrum.value.push_back(row.number("c0") + row.number("c1") * std::exp(-z * z));
  }
  return spectrum;
}

void expect_relative(double value, double expected) {
  EXPECT_NEAR(value, expected, 1e-12 * std::fabs(expected));
}

// 1e-12 relative is the bound of the file.
TEST(XyzOfObject, AgreesWithTheExamples) {
  const auto shared = shared_dir();
  if (!shared) GTEST_SKIP() << kNoShared;
  for (const ExampleRow& row : example_rows(*shared / "spec/colour-examples/spectrum_xyz.csv")) {
    SCOPED_TRACE(row.text("id"));
    const Illuminant* illuminant = find_by_name(illuminants(), row.text("illuminant"));
    const Observer* observer = find_observer(row.text("observer_deg"));
    ASSERT_TRUE(illuminant != nullptr && observer != nullptr);
    const Spectrum light = illuminant_spectrum(*illuminant);
    const bool source = row.text("kind") == "illuminant";
    const Xyz xyz = xyz_of_object(source ? flat(1) : reflectance_of(row), light, *observer);
    expect_relative(100 * xyz.x, row.number("X"));
    expect_relative(100 * xyz.y, row.number("Y"));
    expect_relative(100 * xyz.z, row.number("Z"));
    if (!source) continue;
    const Chromaticity c = chromaticity_of_light(light, *observer);
    expect_relative(c.x, row.number("x"));
    expect_relative(c.y, row.number("y"));
  }
}

// Illuminant A at 5 nm, 380 to 780, in twenty digits.
TEST(XyzOfObject, OfAPerfectWhiteIsTheIlluminant) {
  const Spectrum a = illuminant_spectrum(*find_by_name(illuminants(), "a"));
  const Xyz xyz = xyz_of_object(flat(1), a, kTwoDegrees);
  expect_relative(xyz.x, 1.0984899312124502);
  EXPECT_EQ(xyz.y, 1);
  expect_relative(xyz.z, 0.3558247363237354);
  const Xyz grey = xyz_of_object(flat(0.5), a, kTwoDegrees);
  EXPECT_EQ(grey.y, 0.5);
}

TEST(XyzOfObject, OfDarknessIsUndefined) {
  EXPECT_TRUE(std::isnan(xyz_of_object(flat(1), flat(0), kTwoDegrees).y));
  EXPECT_TRUE(std::isnan(chromaticity_of_light(flat(0), kTwoDegrees).x));
}

// 555 nm alone, 5 nm wide, is seen with ybar = 1.
TEST(XyzOfLight, IsInLumens) {
  const Spectrum line{{550, 555, 560}, {0, 0.1, 0}};
  EXPECT_DOUBLE_EQ(xyz_of_light(line, kTwoDegrees).y, 683 * 0.1 * 5);
  // The sums of the two rules agree where light is smooth.
  const double coarse = xyz_of_light(flat(1), kTwoDegrees, kSum5nm).y;
  const double fine = xyz_of_light(flat(1), kTwoDegrees, kSum1nm).y;
  EXPECT_NEAR(fine / coarse, 1, 1e-4);
}

// Sums of the tables at 5 nm from 360 to 830 [CIE15].
TEST(MatchingFunctions, HaveThePublishedSums) {
  const double sums[2][3] = {{21.373140, 21.371408, 21.378664}, {23.329480, 23.332077, 23.334330}};
  for (std::size_t i = 0; i < observers().size(); ++i) {
    SCOPED_TRACE(observers()[i].name);
    Xyz sum;
    for (int lambda = 360; lambda <= 830; lambda += 5) {
      const Xyz bar = matching_functions(observers()[i], lambda);
      sum = {sum.x + bar.x, sum.y + bar.y, sum.z + bar.z};
    }
    EXPECT_NEAR(sum.x, sums[i][0], 5e-7);
    EXPECT_NEAR(sum.y, sums[i][1], 5e-7);
    EXPECT_NEAR(sum.z, sums[i][2], 5e-7);
  }
}

TEST(MatchingFunctions, AreZeroOutsideTheTable) {
  EXPECT_EQ(matching_functions(kTwoDegrees, 359), Xyz{});
  EXPECT_EQ(matching_functions(kTwoDegrees, 831), Xyz{});
  EXPECT_GT(matching_functions(kTwoDegrees, 830).y, 0);
}

TEST(FindObserver, TakesNamesAndFields) {
  EXPECT_EQ(find_observer("2"), &observers()[0]);
  EXPECT_EQ(find_observer("10"), &observers()[1]);
  EXPECT_EQ(find_observer("CIE_1964"), &observers()[1]);
  EXPECT_EQ(find_observer("1"), nullptr);
}

}  // namespace
}  // namespace tristim
