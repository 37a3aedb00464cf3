#include "tristim/lut/bake.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lib/lut/grid_points.h"
#include "tests/lut/luts.h"
#include "tristim/color/difference.h"
#include "tristim/color/transfer.h"
#include "tristim/color/xyz.h"
#include "tristim/lut/rows.h"
#include "tristim/lut/shaper.h"

namespace tristim {
namespace {

// sRGB codes of linear light in the same primaries, and what they look like.
auto srgb_encoder() {
  const auto map = [](Rgb c) { return Rgb{srgb_encode(c.r), srgb_encode(c.g), srgb_encode(c.b)}; };
  const auto look = [](Rgb c) {
    const Eigen::Vector3d xyz =
        xyz_from_rgb(Primaries{}) *
        Eigen::Vector3d(srgb_decode(c.r), srgb_decode(c.g), srgb_decode(c.b));
    return xyz_to_lab({xyz.x(), xyz.y(), xyz.z()}, white_xyz(kD65));
  };
  return CallableSource(map, look);
}

// Of linear maps of encoded values, which cubes hold exactly.
auto channel_mixer() {
  const auto map = [](Rgb c) {
    return Rgb{0.5 * c.r + 0.25 * c.g, 0.75 * c.g, 0.125 * c.r + 0.5 * c.b};
  };
  return CallableSource(map, [](Rgb c) { return Lab{100 * c.g, 100 * c.r, 100 * c.b}; });
}

TEST(BakeCurves, RoundsTheFormulaOnce) {
  const auto source = srgb_encoder();
  for (const int size : {2, 256, 1025, 1 << 16}) {
    const Lut1D lut = bake_curves(source, {{0, 0, -0.5}, {1, 4, 1}}, size);
    ASSERT_EQ(lut.size, size);
    for (int i = 0; i < size; i += std::max(1, size / 500)) {
      const float* entry = &lut.rgb[3 * static_cast<std::size_t>(i)];
      const double at = static_cast<double>(i) / (size - 1);
      ASSERT_EQ(entry[0], static_cast<float>(srgb_encode(at))) << i;
      ASSERT_EQ(entry[1], static_cast<float>(srgb_encode(4 * at))) << i;
      ASSERT_EQ(entry[2], static_cast<float>(srgb_encode(-0.5 + 1.5 * at))) << i;
    }
    EXPECT_EQ(lut.rgb.back(), 1);
  }
}

TEST(BakeCurves, DoesNotDependOnThreads) {
  const auto source = srgb_encoder();
  EXPECT_EQ(bake_curves(source, {}, 5000, 1), bake_curves(source, {}, 5000, 3));
  EXPECT_EQ(bake_cube(source, {}, 7, 1), bake_cube(source, {}, 7, 3));
}

TEST(BakeCube, HoldsLinearMapsExactly) {
  const auto source = channel_mixer();
  const Lut lut = bake_cube(source, {}, 5);
  const auto* cube = std::get_if<Lut3D>(&lut.steps[0]);
  ASSERT_NE(cube, nullptr);
  EXPECT_EQ(
      *cube,
      sampled(
          LutMatrix{.matrix =
                        (Eigen::Matrix3d() << 0.5, 0.25, 0, 0, 0.75, 0, 0.125, 0, 0.5).finished()},
          5));
  const BakeError error = bake_error(source, lut, BakeGrid{});
  EXPECT_LT(error.largest, 1e-5);
  EXPECT_EQ(error.colors, 128'000U);
}

TEST(BakeCube, PutsItsPointsWhereTheShapersTableDoes) {
  const auto source = srgb_encoder();
  BakeGrid grid;
  grid.shaper = shaper_step({&shaper_shapes()[1], 2.4, {}}, 1024, false);
  const Lut lut = bake_cube(source, grid, 9);
  ASSERT_EQ(lut.steps.size(), 2U);
  const auto& cube = std::get<Lut3D>(lut.steps[1]);
  const LutPoints inverse = invert(std::get<Lut1D>(*grid.shaper));
  for (int i = 0; i < 9; ++i) {
    const double in = evaluate(inverse.curves[0], i / 8.0);
    EXPECT_EQ(cube.rgb[static_cast<std::size_t>(3 * i)], static_cast<float>(srgb_encode(in)));
  }
}

TEST(BakeError, SeesWhatIsWrong) {
  const auto source = channel_mixer();
  Lut lut = bake_cube(source, {}, 17);
  auto& cube = std::get<Lut3D>(lut.steps[0]);
  for (std::size_t i = 1; i < cube.rgb.size(); i += 3) cube.rgb[i] += 0.01F;
  const BakeError error = bake_error(source, lut, BakeGrid{});
  EXPECT_GT(error.largest, 0.5);
  EXPECT_GT(error.mean, 0.5);  // L* is off by 1 everywhere
  EXPECT_LT(error.mean, error.largest);
  cube.rgb[0] = 1000;
  const BakeError corner = bake_error(source, lut, BakeGrid{});
  EXPECT_LT(std::max({corner.worst.r, corner.worst.g, corner.worst.b}), 1.0 / 16);
}

TEST(BakeCube, RefusesWhatIsNotFinite) {
  const auto map = [](Rgb c) { return Rgb{1 / c.r, c.g, c.b}; };
  const CallableSource source(map, [](Rgb) { return Lab{}; });
  EXPECT_THROW(bake_cube(source, {}, 3), std::invalid_argument);
  EXPECT_THROW(bake_curves(source, {}, 3), std::invalid_argument);
  EXPECT_THROW(bake_cube(srgb_encoder(), {}, 1 << 20), std::invalid_argument);
  EXPECT_THROW(bake_cube(srgb_encoder(), {}, 1), std::invalid_argument);
  EXPECT_THROW(bake_curves(srgb_encoder(), {}, 0), std::invalid_argument);
  BakeGrid matrix;
  matrix.shaper = LutMatrix{};
  EXPECT_THROW(bake_cube(srgb_encoder(), matrix, 3), std::invalid_argument);
}

TEST(CubeError, IsThatOfTheBakedCube) {
  const auto source = srgb_encoder();
  const std::vector<Rgb> inputs = {{0.01, 0.3, 0.7}, {0.002, 0.002, 0.002}, {1, 1, 1}, {0, 0, 0.1}};
  for (const LutInterpolation& interpolation : kLutInterpolations) {
    const Lut lut = bake_cube(source, {}, 12);
    double most = 0;
    for (const Rgb in : inputs) {
      Rgb exact[] = {in};
      source.apply(exact);
      most = std::max(most, ciede2000(source.appearance(exact[0]),
                                      source.appearance(evaluate(lut, in, interpolation))));
    }
    EXPECT_NEAR(cube_error(source, {}, 12, inputs, interpolation), most, 1e-9);
  }
}

// Light without a shaper wastes most points on whites; one that is chosen reaches .5 with 65.
TEST(ChooseShaper, MakesSmoothChainsFit) {
  const auto source = srgb_encoder();
  const Shaper shaper = choose_shaper(source, {}, 33, 4096, false);
  ASSERT_NE(shaper.shape, nullptr);
  BakeGrid shaped;
  shaped.shaper = shaper_step(shaper, 4096, false);
  const double with = bake_error(source, bake_cube(source, shaped, 33), shaped).largest;
  const double without = bake_error(source, bake_cube(source, {}, 33), shaped).largest;
  EXPECT_LT(with, 0.12);  // measured: 0.100
  EXPECT_GT(without, 3);
  const auto size = cube_size_for(source, shaped, 0.1);
  ASSERT_TRUE(size);
  EXPECT_NEAR(*size, 33, 3);
  EXPECT_FALSE(cube_size_for(source, {}, 0.001));
}

TEST(ShaperStep, RisesFromBlackToWhiteOverAnyRange) {
  for (const LutRange& range : {LutRange{}, LutRange{{-0.5, -1, 0.001}, {1, 1, 64}}}) {
    for (const ShaperShape& shape : shaper_shapes()) {
      for (const double strength : shape.strengths) {
        SCOPED_TRACE(std::string(shape.name) + " " + std::to_string(strength));
        for (const bool points : {false, true}) {
          const LutStep step = shaper_step({&shape, strength, range}, 1024, points);
          check({"", {step}});
          const detail::GridPoints places({range, step});
          const Rgb black = evaluate(step, {range.low[0], range.low[1], range.low[2]});
          EXPECT_EQ(black.r, 0);
          EXPECT_EQ(black.g, 0);
          EXPECT_LT(black.b, 1e-7);  // points are floats, 0.001 is none
          EXPECT_EQ(evaluate(step, {range.high[0], range.high[1], range.high[2]}), (Rgb{1, 1, 1}));
          const Rgb back = places.place(places.input({0.25, 0.5, 0.75}));
          EXPECT_NEAR(back.r, 0.25, 1e-5);
          EXPECT_NEAR(back.g, 0.5, 1e-5);
          EXPECT_NEAR(back.b, 0.75, 1e-5);
        }
      }
    }
  }
}

TEST(ShaperShapes, AreUndoneByTheirInverses) {
  for (const ShaperShape& shape : shaper_shapes()) {
    for (const double s : shape.strengths) {
      for (const double x : {0.0, 1e-4, 0.01, 0.18, 0.9, 1.0}) {
        EXPECT_NEAR(shape.decode(shape.encode(x, s), s), x, 1e-14) << shape.name << s;
      }
    }
  }
}

}  // namespace
}  // namespace tristim
