#include "tristim/dither/error_rows.h"

#include <gtest/gtest.h>

#include <array>

namespace tristim {
namespace {

using Row = std::vector<float>;

Row above(const ErrorRows& errors, int channel = 0) {
  return {errors.above(channel).begin(), errors.above(channel).end()};
}

// What the next three rows receive of a row's errors.
std::array<Row, 3> received(ErrorRows& errors) {
  std::array<Row, 3> rows;
  for (Row& row : rows) {
    errors.begin_row(1);
    row = above(errors);
    errors.end_row();
  }
  return rows;
}

ErrorRows with_error(const DiffusionKernel& kernel, int width, int x, float error, int direction) {
  ErrorRows errors(kernel, width, 1);
  errors.begin_row(direction);
  errors.errors(0)[static_cast<std::size_t>(x)] = error;
  errors.end_row();
  return errors;
}

TEST(FloydSteinberg, HasThePublishedWeights) {  // [FloydSteinberg76]
  ErrorRows errors = with_error(kFloydSteinberg, 5, 2, 16, 1);
  EXPECT_EQ(received(errors), (std::array<Row, 3>{{{0, 3, 5, 1, 0}, Row(5, 0), Row(5, 0)}}));
  EXPECT_EQ((ErrorsBefore{16, 0, 0}.received(0, errors.weight_before())), 7);
}

TEST(ErrorRows, MirrorsTheKernel) {
  ErrorRows errors = with_error(kFloydSteinberg, 5, 2, 16, -1);
  EXPECT_EQ(received(errors)[0], (Row{0, 1, 5, 3, 0}));
}

TEST(ErrorRows, ReachesThreeRows) {
  ErrorRows errors = with_error(kStevensonArce, 7, 3, 200, 1);
  const std::array<Row, 3> rows = received(errors);
  const std::array<Row, 3> expected{
      {{12, 0, 26, 0, 30, 0, 16}, {0, 12, 0, 26, 0, 12, 0}, {5, 0, 12, 0, 12, 0, 5}}};
  for (std::size_t y = 0; y < 3; ++y) {
    for (std::size_t x = 0; x < 7; ++x) EXPECT_FLOAT_EQ(rows[y][x], expected[y][x]);
  }
}

TEST(ErrorRows, DropsWhatFallsOffTheSides) {
  ErrorRows errors = with_error(kFloydSteinberg, 1, 0, 16, 1);
  EXPECT_EQ(received(errors)[0], Row{5});
}

TEST(ErrorRows, OfClosedKernelsKeepAll) {
  for (const int direction : {1, -1}) {
    for (const int x : {0, 1, 5, 8, 9}) {
      ErrorRows errors = with_error(kBlueDiffusion, 10, x, 64, direction);
      float sum = 0;
      for (const Row& row : received(errors)) {
        for (const float received : row) sum += received;
      }
      // To pixels beside it: 45 and -5, of which those that there are receive their share at once.
      const int left = direction > 0 ? 9 - x : x;
      const float beside = left == 0 ? 0.0F : left == 1 ? 45.0F : 40.0F;
      EXPECT_EQ(sum, 64 - beside) << x << " " << direction;
    }
  }
}

TEST(ErrorRows, KeepsChannelsApart) {
  ErrorRows errors(kFloydSteinberg, 3, 3);
  errors.begin_row(1);
  errors.errors(1)[0] = 16;
  errors.end_row();
  errors.begin_row(1);
  for (const int channel : {0, 1, 2}) {
    EXPECT_EQ(above(errors, channel), (channel == 1 ? Row{5, 1, 0} : Row{0, 0, 0}));
  }
}

TEST(ErrorRows, AddsUpAndStartsEmptyAgain) {
  ErrorRows errors(kFloydSteinberg, 3, 1);
  errors.begin_row(1);
  errors.errors(0)[0] = 16;
  errors.errors(0)[1] = 32;
  errors.end_row();
  EXPECT_EQ(received(errors), (std::array<Row, 3>{{{5 + 6, 1 + 10, 2}, Row(3, 0), Row(3, 0)}}));
}

TEST(ErrorRows, KeepsColumns) {
  ErrorRows errors = with_error(kSierra3, 5, 2, 32, 1);
  const std::uint8_t columns[] = {1, 1, 1, 0, 1};
  errors.keep(columns);
  EXPECT_TRUE(errors.keeps());
  EXPECT_EQ(received(errors), (std::array<Row, 3>{{{2, 4, 5, 0, 2}, {0, 2, 3, 0, 0}, Row(5, 0)}}));
  EXPECT_FALSE(errors.keeps());
}

TEST(ErrorRows, GivesByTone) {
  ErrorRows errors(kOstromoukhov, 3, 1);
  errors.begin_row(-1);
  errors.give_below(1, 0, 10, {.next = 0.5F, .below_last = 0.3F, .below = 0.2F});
  errors.end_row();
  EXPECT_EQ(received(errors)[0], (Row{0, 2, 3}));
}

}  // namespace
}  // namespace tristim
