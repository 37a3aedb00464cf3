#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <random>
#include <thread>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/color/transfer.h"
#include "tristim/dither/levels.h"
#include "tristim/image/view.h"

namespace tristim::bench {

/// The picture that figures are quoted for.
inline constexpr int kWidth = 3840;
inline constexpr int kHeight = 2160;

/// `count` floats in [0, 1), the same ones every time.
inline std::vector<float> noise(std::size_t count) {
  std::vector<float> made(count);
  std::mt19937 random(1);
  for (float& x : made) x = static_cast<float>(random() >> 8) * 0x1p-24F;
  return made;
}

/// Samples without gaps at an address that every library takes for vectors.
template <typename T>
class Samples {
 public:
  explicit Samples(std::size_t count)
      : count_(count),
        data_(static_cast<T*>(std::aligned_alloc(64, (count * sizeof(T) + 63) / 64 * 64))) {
    if (!data_) throw std::bad_alloc();
    std::fill_n(data_.get(), count, T{});  // so that no measurement is the first to touch it
  }
  T* data() const noexcept { return data_.get(); }
  std::size_t size() const noexcept { return count_; }
  T& operator[](std::size_t i) const noexcept { return data_.get()[i]; }

 private:
  struct Free {
    void operator()(T* p) const noexcept { std::free(p); }
  };
  std::size_t count_;
  std::unique_ptr<T[], Free> data_;
};

/// Levels of `bits` bits with their codes, even in light or behind sRGB's curve.
inline MixLevels levels(int bits, bool srgb = true) {
  MixLevels made;
  const int last = (1 << bits) - 1;
  for (int i = 0; i <= last; ++i) {
    const double code = static_cast<double>(i) / last;
    made.light.push_back(static_cast<float>(srgb ? srgb_decode(code) : code));
    made.code.push_back(static_cast<std::uint16_t>(i));
  }
  return made;
}

/// A palette of colours all over the cube, first those of a panel with seven.
inline std::vector<Rgb> entries(int count) {
  std::vector<Rgb> all{{0, 0, 0}, {1, 1, 1}, {1, 0, 0},  {0, 1, 0},
                       {0, 0, 1}, {1, 1, 0}, {1, 0.5, 0}};
  std::mt19937 random(3);
  std::uniform_real_distribution<double> light(0, 1);
  while (static_cast<int>(all.size()) < count) {
    const double r = light(random);
    const double g = light(random);
    all.push_back({r, g, light(random)});
  }
  all.resize(static_cast<std::size_t>(count));
  return all;
}

/// A stand-in for a photograph of that size, smooth light with noise: calls put(x, y, codes) for
/// every pixel, its codes of 8 bits not yet rounded.
template <typename Put>
void photograph(Put&& put) {
  std::mt19937 random(1);
  std::normal_distribution<double> grain(0, 1.5);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const double u = x / 600.0;
      const double v = y / 500.0;
      const double light = 110 + 80 * std::sin(u) * std::cos(v + u / 3) + 30 * std::sin(7 * v);
      std::array<double, 3> codes = {light + 40 * std::sin(v * 1.3), light + 10 * std::sin(u + v),
                                     light + 50 * std::cos(u * 0.7)};
      for (double& code : codes) code = std::clamp(code + grain(random), 0.0, 255.0);
      put(x, y, codes);
    }
  }
}

/// The light of that photograph, behind sRGB's curve.
inline Image photograph_light() {
  constexpr int kParts = 16;  // of a code
  std::vector<float> decoded;
  for (int i = 0; i <= 255 * kParts; ++i) {
    decoded.push_back(static_cast<float>(srgb_decode(i / (255.0 * kParts))));
  }
  Image light(kWidth, kHeight, 3);
  photograph([&](int x, int y, const std::array<double, 3>& codes) {
    std::ranges::transform(codes, light.view().pixel(x, y), [&](double code) {
      return decoded[static_cast<std::size_t>(code * kParts)];
    });
  });
  return light;
}

/// Runs part(first, count) on all of `height` rows, shared out among `threads`.
template <typename Part>
void share_rows(int height, int threads, const Part& part) {
  const auto share = [&](int i) {
    const int first = height * i / threads;
    part(first, height * (i + 1) / threads - first);
  };
  std::vector<std::thread> others;
  for (int i = 1; i < threads; ++i) others.emplace_back(share, i);
  share(0);
  for (std::thread& other : others) other.join();
}

/// Tells how many pixels every iteration went through.
inline void count_pixels(benchmark::State& state, std::int64_t width, std::int64_t height) {
  state.SetItemsProcessed(state.iterations() * width * height);
}

}  // namespace tristim::bench
