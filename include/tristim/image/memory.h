#pragma once

#include "tristim/image/picture.h"

namespace tristim {

/// A picture in memory as a source of rows.
class ImageSource : public RowSource {
 public:
  /// The size and the channels of `info` are taken from `image`.
  explicit ImageSource(Image image, PictureInfo info = {});

  const PictureInfo& info() const noexcept override { return info_; }

  /// Throws std::invalid_argument where `rows` is not of the picture's width and channels, or asks
  /// for more rows than are left.
  void read(ImageView<float> rows) override;

 private:
  Image image_;
  PictureInfo info_;
  int next_ = 0;
};

/// Collects rows into a picture in memory.
class ImageSink : public RowSink {
 public:
  ImageSink(int width, int height, int channels) : image_(width, height, channels) {}

  /// Throws std::invalid_argument where `rows` is not of the picture's width and channels, or has
  /// more rows than are missing.
  void write(ImageView<const float> rows) override;

  /// Throws std::invalid_argument where rows are missing.
  void finish() override;

  /// What has come so far; rows still missing are 0.
  const Image& image() const noexcept { return image_; }

 private:
  Image image_;
  int next_ = 0;
};

}  // namespace tristim
