#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <utility>

#include "lib/dither/half_way.h"
#include "tristim/dither/whole_picture.h"

namespace tristim {
namespace {

constexpr std::size_t kQueue = 16;

// From the oldest error to the newest, 1 : 16 in equal ratios, summing to 1.
std::array<float, kQueue> queue_weights() {
  constexpr double kRatio = 1.2030250360821167;  // 16^(1/15)
  std::array<double, kQueue> powers{};
  double power = 1;
  double sum = 0;
  for (double& p : powers) {
    p = power;
    sum += power;
    power *= kRatio;
  }
  std::array<float, kQueue> weights{};
  for (std::size_t i = 0; i < kQueue; ++i) weights[i] = static_cast<float>(powers[i] / sum);
  return weights;
}

// The place of step `at` on the Hilbert curve through a square of 2^order, from its corner (0, 0)
// to the corner (2^order - 1, 0) [Hilbert91].
std::pair<int, int> hilbert_place(std::uint64_t at, int order) noexcept {
  int x = 0;
  int y = 0;
  for (int level = 0; level < order; ++level) {
    const int side = 1 << level;
    const bool right = (at & 2) != 0;
    const bool lower = ((at ^ (at >> 1)) & 1) != 0;  // quarters go down, right, up
    if (!lower) {
      if (right) {
        x = side - 1 - x;
        y = side - 1 - y;
      }
      std::swap(x, y);
    }
    if (right) x += side;
    if (lower) y += side;
    at >>= 2;
  }
  return {x, y};
}

// Calls visit(x, y) for every pixel, along curves through squares side by side: each ends beside
// the next one's start.
template <typename Visit>
void along_hilbert_curve(int width, int height, Visit&& visit) {
  const bool wide = width >= height;
  const int across = std::min(width, height);
  const auto order =
      static_cast<int>(std::bit_width(static_cast<unsigned>(std::max(across - 1, 0))));
  const int side = 1 << order;
  const std::uint64_t steps = std::uint64_t{1} << (2 * order);
  for (int start = 0; start < std::max(width, height); start += side) {
    for (std::uint64_t at = 0; at < steps; ++at) {
      auto [x, y] = hilbert_place(at, order);
      x += start;
      if (!wide) std::swap(x, y);
      if (x < width && y < height) visit(x, y);
    }
  }
}

}  // namespace

void riemersma_channel(ImageView<const float> light, const MixLevels& levels,
                       const WholePictureParameters& parameters, ImageView<std::uint16_t> codes) {
  const LevelSearch search(detail::half_way_points(levels.light));
  const std::array<float, kQueue> weights = queue_weights();
  std::array<float, kQueue> errors{};  // a ring; the oldest at `oldest`
  std::size_t oldest = 0;
  along_hilbert_curve(light.width, light.height, [&](int x, int y) {
    float received = 0;
    for (std::size_t i = 0; i < kQueue; ++i) {
      received += weights[i] * errors[(oldest + i) % kQueue];
    }
    const float share = parameters.share(x, y);
    const float clipped = std::clamp(*light.pixel(x, y), levels.light.front(), levels.light.back());
    const float wanted = clipped + received * share;
    const auto level = static_cast<std::size_t>(search.count_not_above(wanted));
    *codes.pixel(x, y) = levels.code[level];
    errors[oldest] = (wanted - levels.light[level]) * share;
    oldest = (oldest + 1) % kQueue;
  });
}

}  // namespace tristim
