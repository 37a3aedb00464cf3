#include "lib/image/io/half_row.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

namespace tristim::detail {
namespace {

std::vector<std::uint16_t> all_halves() {
  std::vector<std::uint16_t> halves(65536);
  for (std::size_t i = 0; i < halves.size(); ++i) halves[i] = static_cast<std::uint16_t>(i);
  return halves;
}

TEST(HalfRow, RowsAreBitForBitTheScalarDefinition) {
  const std::vector<std::uint16_t> halves = all_halves();
  std::vector<float> values(halves.size());
  float_from_half(halves, values);
  for (std::size_t i = 0; i < halves.size(); ++i) {
    ASSERT_EQ(std::bit_cast<std::uint32_t>(values[i]),
              std::bit_cast<std::uint32_t>(float_from_half(halves[i])))
        << "half " << i;
  }
  for (const std::size_t size : {0U, 1U, 7U, 8U, 9U, 1001U}) {
    std::vector<float> some(size, 0.1F);
    for (std::size_t i = 0; i < size; ++i) some[i] *= static_cast<float>(i);
    std::vector<std::uint16_t> row(size);
    half_from_float(some, row);
    for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(row[i], half_from_float(some[i]));
  }
}

TEST(HalfRow, EveryHalfComesBack) {
  for (const std::uint16_t half : all_halves()) {
    const float value = float_from_half(half);
    if (std::isnan(value)) {
      EXPECT_EQ(half_from_float(value), half | 0x200);  // quiet
    } else {
      EXPECT_EQ(half_from_float(value), half);
    }
  }
}

TEST(HalfRow, HasTheValuesOfIeee754) {
  EXPECT_EQ(float_from_half(0x3c00), 1.0F);
  EXPECT_EQ(float_from_half(0x7bff), 65504.0F);
  EXPECT_EQ(float_from_half(0x0001), 0x1p-24F);
  EXPECT_EQ(float_from_half(0xfc00), -std::numeric_limits<float>::infinity());
}

TEST(HalfRow, RoundsTiesToEvenAndOverflowsToInfinity) {
  EXPECT_EQ(half_from_float(1.0F + 0x1p-11F), 0x3c00);
  EXPECT_EQ(half_from_float(1.0F + 3 * 0x1p-11F), 0x3c02);
  EXPECT_EQ(half_from_float(65519.9F), 0x7bff);
  EXPECT_EQ(half_from_float(65520.0F), 0x7c00);
  EXPECT_EQ(half_from_float(-1e30F), 0xfc00);
  EXPECT_EQ(half_from_float(0x1p-25F), 0);
  EXPECT_EQ(half_from_float(0x1.8p-25F), 1);
}

TEST(HalfRow, WritesWhatTheProcessorWrites) {
  // floats around every half, so that each rounding decision occurs, and some beyond the range
  std::vector<float> values;
  for (std::uint32_t half = 0; half < 0x7c00; ++half) {
    const auto bits =
        std::bit_cast<std::uint32_t>(float_from_half(static_cast<std::uint16_t>(half)));
    for (const std::uint32_t offset : {0U, 0xfffU, 0x1000U, 0x1001U}) {
      values.push_back(std::bit_cast<float>(bits + offset));
    }
  }
  std::vector<std::uint16_t> halves(values.size());
  half_from_float(values, halves);
  for (std::size_t i = 0; i < values.size(); ++i) {
    ASSERT_EQ(halves[i], half_from_float(values[i])) << std::hexfloat << values[i];
  }
}

}  // namespace
}  // namespace tristim::detail
