#pragma once

#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

namespace tristim {

/// Rows of interleaved samples that somebody else owns; passed by value.
template <typename T>
struct ImageView {
  T* data = nullptr;
  int width = 0;              // pixels
  int height = 0;             // rows
  int channels = 0;           // samples of a pixel, interleaved
  std::ptrdiff_t stride = 0;  // samples from one row to the next

  std::span<T> row(int y) const noexcept {
    return {data + y * stride,
            static_cast<std::size_t>(width) * static_cast<std::size_t>(channels)};
  }
  T* pixel(int x, int y) const noexcept {
    return data + y * stride + static_cast<std::ptrdiff_t>(x) * channels;
  }
  /// The `count` rows from row `first` on; the caller keeps them inside.
  ImageView rows(int first, int count) const noexcept {
    return {data + first * stride, width, count, channels, stride};
  }
  /// Rows that are only read, as a T* becomes a const T*.
  // NOLINTNEXTLINE(google-explicit-constructor): implicit as for pointers
  operator ImageView<const T>() const noexcept requires(!std::is_const_v<T>) {
    return {data, width, height, channels, stride};
  }
};

/// A picture in memory: rows without gaps, zero at first. Copies are explicit: copy the `samples`.
template <typename T>
class Raster {
 public:
  Raster() = default;
  Raster(int width, int height, int channels)
      : width_(width),
        height_(height),
        channels_(channels),
        samples_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                 static_cast<std::size_t>(channels)) {}
  Raster(Raster&&) noexcept = default;
  Raster& operator=(Raster&&) noexcept = default;

  ImageView<T> view() noexcept {
    return {samples_.data(), width_, height_, channels_, std::ptrdiff_t{width_} * channels_};
  }
  ImageView<const T> view() const noexcept {
    return {samples_.data(), width_, height_, channels_, std::ptrdiff_t{width_} * channels_};
  }

 private:
  int width_ = 0;
  int height_ = 0;
  int channels_ = 0;
  std::vector<T> samples_;
};

using Image = Raster<float>;

}  // namespace tristim
