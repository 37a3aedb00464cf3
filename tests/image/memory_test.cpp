#include "tristim/image/memory.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace tristim {
namespace {

TEST(ImageSource, TakesItsSizeFromTheImage) {
  const ImageSource source(Image(3, 2, 4));
  EXPECT_EQ(source.info().width, 3);
  EXPECT_EQ(source.info().height, 2);
  EXPECT_EQ(source.info().channels, 4);
}

TEST(ImageSource, RefusesMoreRowsThanAreLeft) {
  ImageSource source(Image(3, 2, 3));
  Image rows(3, 3, 3);
  EXPECT_THROW(source.read(rows.view()), std::invalid_argument);
  source.read(rows.view().rows(0, 2));
  EXPECT_THROW(source.read(rows.view().rows(0, 1)), std::invalid_argument);
}

TEST(ImageSink, CollectsRowsInOrder) {
  Image rows(1, 2, 3);
  rows.view().row(0)[1] = 5;
  rows.view().row(1)[2] = 7;
  ImageSink sink(1, 3, 3);
  sink.write(rows.view().rows(1, 1));
  EXPECT_THROW(sink.finish(), std::invalid_argument);
  sink.write(rows.view());
  sink.finish();
  EXPECT_EQ(sink.image().view().row(0)[2], 7);
  EXPECT_EQ(sink.image().view().row(1)[1], 5);
  EXPECT_EQ(sink.image().view().row(2)[2], 7);
  EXPECT_THROW(sink.write(rows.view()), std::invalid_argument);
}

TEST(ImageSink, RefusesRowsOfAnotherShape) {
  ImageSink sink(3, 2, 3);
  EXPECT_THROW(sink.write(Image(2, 1, 3).view()), std::invalid_argument);
  EXPECT_THROW(sink.write(Image(3, 1, 4).view()), std::invalid_argument);
}

}  // namespace
}  // namespace tristim
