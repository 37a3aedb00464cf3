#include "tristim/image/repeat.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "tristim/image/memory.h"

namespace tristim {
namespace {

std::unique_ptr<RowSource> numbered(int width, int height) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      for (int c = 0; c < 3; ++c) {
        image.view().pixel(x, y)[c] = static_cast<float>(100 * y + 10 * x + c);
      }
    }
  }
  return std::make_unique<ImageSource>(std::move(image));
}

TEST(RepeatPixels, MakesBlocksHoweverManyRowsAreRead) {
  for (const int at_a_time : {1, 2, 5, 6}) {
    const auto source = repeat_pixels(numbered(2, 2), 2, 3);
    EXPECT_EQ(source->info().width, 4);
    EXPECT_EQ(source->info().height, 6);
    Image all(4, 6, 3);
    for (int y = 0; y < 6; y += at_a_time) {
      source->read(all.view().rows(y, std::min(at_a_time, 6 - y)));
    }
    for (int y = 0; y < 6; ++y) {
      for (int x = 0; x < 4; ++x) {
        ASSERT_EQ(all.view().pixel(x, y)[1], static_cast<float>(100 * (y / 3) + 10 * (x / 2) + 1));
      }
    }
  }
}

TEST(RepeatPixels, LeavesThePictureAloneAndRefusesNothing) {
  auto source = numbered(2, 2);
  const RowSource* same = source.get();
  EXPECT_EQ(repeat_pixels(std::move(source), 1, 1).get(), same);
  EXPECT_THROW(repeat_pixels(numbered(2, 2), 0, 1), std::invalid_argument);
  EXPECT_THROW(repeat_pixels(numbered(2, 2), 1 << 30, 1), std::invalid_argument);
}

}  // namespace
}  // namespace tristim
