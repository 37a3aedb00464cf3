#include "tristim/dither/error_rows.h"

#include <gtest/gtest.h>

#include <array>

namespace tristim {
namespace {

// What each pixel of three rows of `width` has received; reading goes on to the rows below.
std::array<std::vector<float>, 3> received(ErrorRows& errors, int width, int channel = 0) {
  std::array<std::vector<float>, 3> rows;
  for (auto& row : rows) {
    for (int x = 0; x < width; ++x) row.push_back(errors.received(x, channel));
    errors.next_row();
  }
  return rows;
}

TEST(FloydSteinberg, HasThePublishedWeights) {  // [FloydSteinberg76]
  ErrorRows errors(kFloydSteinberg, 5, 1);
  errors.spread(2, 0, 16, 1);
  const auto rows = received(errors, 5);
  EXPECT_EQ(rows[0], (std::vector<float>{0, 0, 0, 7, 0}));
  EXPECT_EQ(rows[1], (std::vector<float>{0, 3, 5, 1, 0}));
  EXPECT_EQ(rows[2], (std::vector<float>{0, 0, 0, 0, 0}));
}

TEST(ErrorRows, MirrorsTheKernel) {
  ErrorRows errors(kFloydSteinberg, 5, 1);
  errors.spread(2, 0, 16, -1);
  const auto rows = received(errors, 5);
  EXPECT_EQ(rows[0], (std::vector<float>{0, 7, 0, 0, 0}));
  EXPECT_EQ(rows[1], (std::vector<float>{0, 1, 5, 3, 0}));
}

TEST(ErrorRows, DropsWhatFallsOffTheSides) {
  ErrorRows errors(kFloydSteinberg, 1, 1);
  errors.spread(0, 0, 16, 1);
  const auto rows = received(errors, 1);
  EXPECT_EQ(rows[0][0], 0);
  EXPECT_EQ(rows[1][0], 5);
  EXPECT_EQ(rows[2][0], 0);
}

TEST(ErrorRows, KeepsChannelsApart) {
  ErrorRows errors(kFloydSteinberg, 3, 3);
  errors.spread(0, 1, 16, 1);
  for (const int channel : {0, 1, 2}) {
    EXPECT_EQ(errors.received(1, channel), channel == 1 ? 7 : 0);
  }
}

TEST(ErrorRows, AddsUpAndStartsEmptyAgain) {
  ErrorRows errors(kFloydSteinberg, 3, 1);
  errors.spread(0, 0, 16, 1);
  errors.spread(1, 0, 32, 1);
  EXPECT_EQ(errors.received(1, 0), 7);
  EXPECT_EQ(errors.received(2, 0), 14);
  errors.next_row();
  EXPECT_EQ(errors.received(0, 0), 5 + 6);
  EXPECT_EQ(errors.received(1, 0), 1 + 10);
  EXPECT_EQ(errors.received(2, 0), 2);
  for (int i = 0; i < 3; ++i) errors.next_row();
  for (int x = 0; x < 3; ++x) EXPECT_EQ(errors.received(x, 0), 0);
}

}  // namespace
}  // namespace tristim
