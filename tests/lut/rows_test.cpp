#include "tristim/lut/rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "lib/lut/cube_kernels.h"
#include "tests/lut/luts.h"

namespace tristim {
namespace {

// Pixels across [0, 1] and some beyond it, the odd ones first.
std::vector<float> noise_pixels(std::size_t count) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  constexpr float kInf = std::numeric_limits<float>::infinity();
  std::vector<float> pixels = {0, 0,    0,    1,    1,     1, 0.5F,   0.5F,  0.5F,   1,        0,
                               1, -0.F, kNan, kInf, -kInf, 9, -3e38F, 3e38F, 1e-40F, 0.999999F};
  std::mt19937 random(7);
  while (pixels.size() < 3 * count) {
    pixels.push_back(static_cast<float>(random() >> 8) * 0x1.1p-24F - 0x1p-5F);
  }
  pixels.resize(3 * count);
  return pixels;
}

double largest_error(const Lut& lut, const LutInterpolation& method) {
  const std::vector<float> in = noise_pixels(20'000);
  std::vector<float> out(in.size());
  LutRows(lut, method)(in, out);
  double most = 0;
  for (std::size_t i = 0; i < in.size(); i += 3) {
    const Rgb exact = evaluate(lut, {in[i], in[i + 1], in[i + 2]}, method);
    most = std::max({most, std::abs(exact.r - out[i]), std::abs(exact.g - out[i + 1]),
                     std::abs(exact.b - out[i + 2])});
  }
  return most;
}

const LutRange kOddRange{{-0.25, 0, 0.1}, {1, 1.5, 0.9}};

TEST(LutRows, FollowTheDoubleDefinition) {
  for (const LutInterpolation& method : kLutInterpolations) {
    SCOPED_TRACE(method.name);
    for (const int size : {2, 3, 17, 20, 33, 64, 65}) {
      SCOPED_TRACE(size);
      // Of random entries in [0, 1), so neighbours differ by all there is; largest: 1.9e-7.
      EXPECT_LT(largest_error({"", {noise_cube(size, 1)}}, method), 2e-7);
      EXPECT_LT(largest_error({"", {noise_cube(size, 2, kOddRange)}}, method), 2e-7);
    }
  }
}

TEST(LutRows, TakeCurvesAndMatricesToo) {
  std::mt19937 random(3);
  for (const int size : {2, 256, 1 << 16}) {
    Lut1D curves{kOddRange, size, {}};
    for (int i = 0; i < 3 * size; ++i) {
      curves.rgb.push_back(static_cast<float>(random() >> 8) * 0x1p-24F);
    }
    EXPECT_LT(largest_error({"", {curves}}, kLutInterpolations[0]), 3.1e-8) << size;
  }
  LutPoints points;
  for (LutCurve& curve : points.curves) {
    for (float x = -2; x < 2; x += static_cast<float>(random() % 1000) * 1e-4F + 1e-6F) {
      curve.in.push_back(x);
      curve.out.push_back(static_cast<float>(random() >> 8) * 0x1p-24F);
    }
  }
  EXPECT_LT(largest_error({"", {points}}, kLutInterpolations[0]), 3.1e-8);
  const LutMatrix matrix{.matrix = Eigen::Matrix3d::Constant(0.3), .offset = {0, 0.1, 0.2}};
  const std::vector<float> in{0.25F, 0.5F, -1};
  std::vector<float> out(3);
  LutRows({"", {matrix}})(in, out);
  EXPECT_EQ(out, (std::vector<float>{-0.075F, 0.025F, 0.125F}));
}

// Steps one after the other, in floats between.
TEST(LutRows, TakeAShaperAndACube) {
  Lut1D shaper{{}, 256, {}};
  for (int i = 0; i < 256; ++i) {
    for (int c = 0; c < 3; ++c) shaper.rgb.push_back(static_cast<float>(std::sqrt(i / 255.0)));
  }
  const LutMatrix smooth{.matrix = 0.5 * Eigen::Matrix3d::Identity()};
  const Lut lut{"", {shaper, sampled(smooth, 33)}};
  EXPECT_LT(largest_error(lut, kLutInterpolations[0]), 2e-7);
}

TEST(LutRows, AreTheSameBitsInEveryInstructionSet) {
  for (const LutRange& range : {LutRange{}, kOddRange}) {
    for (const int size : {2, 33, 40}) {
      const detail::CubeTable table(noise_cube(size, 5, range));
      for (const std::size_t count : {0, 1, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 1001}) {
        const std::vector<float> in = noise_pixels(count);
        std::vector<float> tetrahedral(in.size() + 1, -7);
        std::vector<float> trilinear = tetrahedral;
        detail::scalar_cube_kernels().tetrahedral(table, in.data(), tetrahedral.data(), count);
        detail::scalar_cube_kernels().trilinear(table, in.data(), trilinear.data(), count);
        for (const detail::CubeKernels& kernels : detail::simd_cube_kernels()) {
          SCOPED_TRACE(std::string(kernels.name) + " " + std::to_string(count));
          std::vector<float> out(in.size() + 1, -7);
          kernels.tetrahedral(table, in.data(), out.data(), count);
          EXPECT_EQ(out, tetrahedral);  // the number behind the row as well
          kernels.trilinear(table, in.data(), out.data(), count);
          EXPECT_EQ(out, trilinear);
        }
      }
    }
  }
}

TEST(LutRows, CarryOtherChannelsOver) {
  const std::vector<float> in = noise_pixels(1000);
  const LutRows rows({"", {noise_cube(9, 1)}});
  std::vector<float> expected(in.size());
  rows(in, expected);
  std::vector<float> five;
  for (std::size_t i = 0; i < 1000; ++i) {
    for (std::size_t c = 0; c < 3; ++c) five.push_back(in[3 * i + c]);
    five.push_back(0.25F);
    five.push_back(static_cast<float>(i));
  }
  rows(five, five, 5);
  for (std::size_t i = 0; i < 1000; ++i) {
    for (std::size_t c = 0; c < 3; ++c) ASSERT_EQ(five[5 * i + c], expected[3 * i + c]);
    ASSERT_EQ(five[5 * i + 3], 0.25F);
    ASSERT_EQ(five[5 * i + 4], static_cast<float>(i));
  }
  std::vector<float> same = in;
  rows(same, same);
  EXPECT_EQ(same, expected);
}

TEST(LutRows, OfAPictureDoNotDependOnThreads) {
  const LutRows rows({"", {noise_cube(17, 1)}});
  const std::vector<float> in = noise_pixels(33 * 21);
  const ImageView<const float> picture{in.data(), 33, 21, 3, 99};
  std::vector<float> one(in.size());
  std::vector<float> four(in.size());
  apply(rows, picture, {one.data(), 33, 21, 3, 99}, 1);
  apply(rows, picture, {four.data(), 33, 21, 3, 99}, 4);
  EXPECT_EQ(one, four);
  EXPECT_THROW(apply(rows, picture, {four.data(), 33, 20, 3, 99}), std::invalid_argument);
}

TEST(LutRows, RefuseWhatIsNoRow) {
  const LutRows rows({"", {}});
  std::vector<float> six(6);
  std::vector<float> seven(7);
  EXPECT_THROW(rows(seven, seven), std::invalid_argument);
  EXPECT_THROW(rows(six, seven), std::invalid_argument);
  EXPECT_THROW(rows(six, six, 2), std::invalid_argument);
  EXPECT_THROW(LutRows({"", {Lut3D{{}, 2, {}}}}), std::invalid_argument);
}

}  // namespace
}  // namespace tristim
