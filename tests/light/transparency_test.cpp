#include "tristim/light/transparency.h"

#include <gtest/gtest.h>

namespace tristim {
namespace {

TEST(Transparency, InterpolatesOrFilters) {
  const TransparentSurface glass{.kt = 0.25, .tint = {1, 0.5, 0}};
  const Rgb front{1, 2, 4};
  const Rgb behind{8, 8, 8};
  EXPECT_EQ(interpolated_transparency(glass, front, behind), (Rgb{2.75, 3.5, 5}));
  EXPECT_EQ(filtered_transparency(glass, front, behind), (Rgb{3, 3, 4}));
  EXPECT_EQ(interpolated_transparency({.kt = 0}, front, behind), front);
  EXPECT_EQ(interpolated_transparency({.kt = 1}, front, behind), behind);
}

TEST(Transparency, OfSpectraIsThatOfEachSample) {
  const SpectralTransparentSurface glass{.kt = 0.25, .tint = flat_spectrum(0.5)};
  const SpectralColor front = flat_spectrum(2);
  const SpectralColor behind = flat_spectrum(8);
  EXPECT_EQ(interpolated_transparency(glass, front, behind), flat_spectrum(3.5));
  EXPECT_EQ(filtered_transparency(glass, front, behind), flat_spectrum(3));
}

TEST(Transparency, TranslucentSurfaceIsLitFromItsFarSide) {
  const Eigen::Vector3d up(0, 0, 1);
  EXPECT_EQ(diffuse_transmission(up, Eigen::Vector3d(0.6, 0, -0.8)), 0.8);
  EXPECT_EQ(diffuse_transmission(up, Eigen::Vector3d(0.6, 0, 0.8)), 0);
}

}  // namespace
}  // namespace tristim
