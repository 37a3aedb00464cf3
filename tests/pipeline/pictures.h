#pragma once

#include <random>
#include <stdexcept>
#include <vector>

#include "tristim/frame/code.h"
#include "tristim/image/memory.h"

namespace tristim {

/// Light of all kinds: ramps, noise, and values outside of [0, 1].
inline Image test_picture(int width, int height) {
  Image image(width, height, 3);
  std::mt19937 random(1);
  std::uniform_real_distribution<float> noise(-0.1F, 0.1F);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float* pixel = image.view().pixel(x, y);
      pixel[0] = 1.2F * static_cast<float>(x) / static_cast<float>(width) + noise(random);
      pixel[1] = static_cast<float>(y) / static_cast<float>(height) + noise(random);
      pixel[2] = 0.3F + noise(random);
    }
  }
  return image;
}

inline Image flat_picture(int width, int height, float r, float g, float b) {
  Image image(width, height, 3);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      float* pixel = image.view().pixel(x, y);
      pixel[0] = r, pixel[1] = g, pixel[2] = b;
    }
  }
  return image;
}

/// Collects the codes of a frame.
class CodeCollector : public CodeSink {
 public:
  void write(ImageView<const std::uint16_t> rows) override {
    for (int y = 0; y < rows.height; ++y) {
      codes.insert(codes.end(), rows.row(y).begin(), rows.row(y).end());
    }
    width = rows.width;
    channels = rows.channels;
  }
  void finish() override {}

  std::vector<std::uint16_t> codes;
  int width = 0;
  int channels = 0;
};

}  // namespace tristim
