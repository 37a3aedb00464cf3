#include "lib/render/sample_pattern.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/core/math.h"
#include "tristim/core/find.h"

namespace tristim::detail {
namespace {

// The binary digits of i in reverse, behind the point.
int reversed(int i, int digits) noexcept {
  int mirrored = 0;
  for (int d = 0; d < digits; ++d) mirrored |= (i >> d & 1) << (digits - 1 - d);
  return mirrored;
}

double weight_at(const PixelFilter& filter, double x, double y) noexcept {
  if (filter.name == kBoxFilter.name) return x >= -0.5 && x < 0.5 && y >= -0.5 && y < 0.5 ? 1 : 0;
  if (std::fabs(x) > filter.radius || std::fabs(y) > filter.radius) return 0;
  if (filter.name == kTentFilter.name) return (1 - std::fabs(x)) * (1 - std::fabs(y));
  return exp(-2 * (x * x + y * y));
}

}  // namespace

std::vector<SampleOffset> sample_offsets(int samples, int bits) {
  if (samples != 1 && samples != 4 && samples != 16 && samples != 64) {
    throw std::invalid_argument("samples of a pixel: " + std::to_string(samples) +
                                "; expected 1, 4, 16 or 64");
  }
  int digits = 0;
  while (1 << digits < samples) ++digits;
  const int cell = (1 << bits) / samples;
  std::vector<SampleOffset> offsets;
  for (int i = 0; i < samples; ++i) {
    offsets.push_back({i * cell + cell / 2, reversed(i, digits) * cell + cell / 2});
  }
  return offsets;
}

std::vector<std::vector<FilterTap>> filter_taps(const PixelFilter& filter,
                                                const std::vector<SampleOffset>& offsets,
                                                int bits) {
  const double pixel = 1.0 / static_cast<double>(1 << bits);
  const int reach = filter_margin(filter);
  std::vector<std::vector<FilterTap>> taps;
  double sum = 0;
  for (const SampleOffset& offset : offsets) {
    taps.emplace_back();
    for (int y = -reach; y <= reach; ++y) {
      for (int x = -reach; x <= reach; ++x) {
        const double weight =
            weight_at(filter, offset.x * pixel - 0.5 - x, offset.y * pixel - 0.5 - y);
        if (weight > 0) taps.back().push_back({x, y, weight});
        sum += weight;
      }
    }
  }
  for (auto& of_sample : taps) {
    for (FilterTap& tap : of_sample) tap.weight /= sum;
  }
  return taps;
}

int filter_margin(const PixelFilter& filter) noexcept {
  return static_cast<int>(std::ceil(filter.radius - 0.5));
}

}  // namespace tristim::detail
