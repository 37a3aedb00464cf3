#include "lib/color/curve_table.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tristim/color/transfer.h"

namespace tristim::detail {
namespace {

double largest_error(const CurveTable& table, double (*curve)(double) noexcept) {
  double largest = 0;
  for (float x = 1e-12F; x < 1; x *= 1.0003F) {
    largest = std::max(largest, std::fabs(table(x) - curve(x)));
  }
  return largest;
}

TEST(CurveTable, IsWithinItsBoundOfTheCurve) {
  EXPECT_LE(largest_error(srgb_encode_table(), srgb_encode), 1e-5);
  EXPECT_LE(largest_error(srgb_decode_table(), srgb_decode), 1e-5);
}

TEST(CurveTable, NeverFalls) {
  for (const CurveTable* table : {&srgb_encode_table(), &srgb_decode_table()}) {
    float before = (*table)(0);
    for (float x = 1e-12F; x < 1; x *= 1.0003F) {
      const float value = (*table)(x);
      ASSERT_GE(value, before - 1e-7F) << x;  // the rounding of two neighbouring lines
      before = value;
    }
  }
}

TEST(CurveTable, HoldsTheEndsBeyondThem) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  for (const CurveTable* table : {&srgb_encode_table(), &srgb_decode_table()}) {
    for (const float x : {0.0F, -0.0F, -1.0F, -kInfinity, std::nanf("")}) EXPECT_EQ((*table)(x), 0);
    for (const float x : {1.0F, 2.0F, kInfinity}) EXPECT_EQ((*table)(x), 1);
    EXPECT_GE((*table)(std::numeric_limits<float>::denorm_min()), 0);
  }
}

}  // namespace
}  // namespace tristim::detail
