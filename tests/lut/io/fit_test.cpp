#include <gtest/gtest.h>

#include "tests/error_text.h"
#include "tests/lut/io/tables.h"
#include "tristim/core/find.h"

namespace tristim {
namespace {

const LutFormat& format(std::string_view name) { return *find_by_name(lut_formats(), name); }

TEST(FitLut, CurvesStayCurvesWhereTheFormatHasThem) {
  LutMatrix half;
  half.matrix *= 0.5;
  const Lut lut{"", {test_shaper(17, 0), half, test_shaper(9, 0)}};
  const Lut fitted = fit_lut(lut, format("xrandr"), {.curves = 1024}, "x");
  ASSERT_EQ(fitted.steps.size(), 1u);
  const Lut1D& curves = std::get<Lut1D>(fitted.steps[0]);
  for (int i = 0; i < 1024; ++i) {
    const double x = i / 1023.0;
    EXPECT_EQ(curves.rgb[3 * static_cast<std::size_t>(i)],
              static_cast<float>(evaluate(lut, {x, x, x}).r));
  }
}

TEST(FitLut, PointsOfACubeAreExact) {
  const Lut lut{"", {test_cube(5, 0), test_shaper(9, 0)}};
  const Lut fitted = fit_lut(lut, format("spi3d"), {.cube = 9}, "x");
  const Lut3D& cube = std::get<Lut3D>(fitted.steps[0]);
  ASSERT_EQ(cube.size, 9);
  for (std::size_t i = 0; i < 729; ++i) {
    const auto at = [&](std::size_t step) { return static_cast<double>(i / step % 9) / 8; };
    const Rgb expected = evaluate(lut, {at(1), at(9), at(81)});
    EXPECT_EQ(cube.rgb[3 * i], static_cast<float>(expected.r));
    EXPECT_EQ(cube.rgb[3 * i + 2], static_cast<float>(expected.b));
  }
}

TEST(FitLut, ShapersStayInFront) {
  const LutRange wide{{0, 0, 0}, {16, 16, 16}};
  const Lut lut{"", {test_shaper(64, 0, wide), test_cube(3, 0), test_shaper(5, 0)}};
  const Lut fitted = fit_lut(lut, format("csp"), {.cube = 3}, "x");
  ASSERT_EQ(fitted.steps.size(), 2u);
  EXPECT_EQ(fitted.steps[0], lut.steps[0]);
  const Lut spi3d = fit_lut(lut, format("spi3d"), {.cube = 3}, "x");
  EXPECT_EQ(spi3d.steps.size(), 1u);
  EXPECT_EQ(
      std::get<Lut1D>(fit_lut(lut, format("cube"), {.cube = 3, .shaper = 99}, "x").steps[0]).size,
      99);
}

TEST(FitLut, SaysWhatItCannot) {
  const Lut cube{"", {test_cube(3, 0)}};
  EXPECT_EQ(error_text([&] { fit_lut(cube, format("spi1d"), {.cube = 9}, "x"); }),
            "2 x: format spi1d has curves alone, and channels of the table depend on others; use a "
            "format that has cubes");
  EXPECT_EQ(
      error_text([&] { fit_lut(cube, format("hald"), {.cube = 17}, "x"); }),
      "2 x: format hald does not hold a table of size 17; it holds a cube of 4, 9, 16, 25, 36, "
      "49, 64, 81, 100, 121, 144, 169, 196, 225, 256 points an edge over 0 to 1");
  const Lut curves{"", {test_curves(4, 0)}};
  EXPECT_EQ(error_text([&] { fit_lut(curves, format("drm"), {.curves = 300}, "x"); }),
            "2 x: format drm does not hold a table of size 300; it holds curves of 256, 1024, 4096 "
            "entries over 0 to 1");
  for (const int size : {1, 1 << 20}) {
    EXPECT_EQ(error_text([&] { fit_lut(cube, format("cube"), {.cube = size}, "x"); }),
              "invalid: lut: cube of size " + std::to_string(size) + "; expected 2 to 256");
  }
}

}  // namespace
}  // namespace tristim
