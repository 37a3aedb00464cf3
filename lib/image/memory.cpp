#include "tristim/image/memory.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace tristim {
namespace {

template <typename A, typename B>
void check_rows(ImageView<A> rows, ImageView<B> picture, int next, const char* who) {
  if (rows.width == picture.width && rows.channels == picture.channels && rows.height >= 0 &&
      rows.height <= picture.height - next) {
    return;
  }
  throw std::invalid_argument(
      std::string(who) + ": " + std::to_string(rows.height) + " rows of " +
      std::to_string(rows.width) + " x " + std::to_string(rows.channels) +
      " samples, expected at most " + std::to_string(picture.height - next) + " of " +
      std::to_string(picture.width) + " x " + std::to_string(picture.channels));
}

}  // namespace

ImageSource::ImageSource(Image image, PictureInfo info)
    : image_(std::move(image)), info_(std::move(info)) {
  info_.width = image_.view().width;
  info_.height = image_.view().height;
  info_.channels = image_.view().channels;
}

void ImageSource::read(ImageView<float> rows) {
  const auto picture = std::as_const(image_).view();
  check_rows(rows, picture, next_, "ImageSource::read");
  for (int y = 0; y < rows.height; ++y) {
    std::ranges::copy(picture.row(next_++), rows.row(y).begin());
  }
}

void ImageSink::write(ImageView<const float> rows) {
  const auto picture = image_.view();
  check_rows(rows, picture, next_, "ImageSink::write");
  for (int y = 0; y < rows.height; ++y) {
    std::ranges::copy(rows.row(y), picture.row(next_++).begin());
  }
}

void ImageSink::finish() {
  const int height = image_.view().height;
  if (next_ == height) return;
  throw std::invalid_argument("ImageSink::finish: " + std::to_string(next_) + " rows, expected " +
                              std::to_string(height));
}

}  // namespace tristim
