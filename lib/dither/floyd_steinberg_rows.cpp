#include "lib/dither/floyd_steinberg_rows.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

constexpr std::int32_t kMostBins = 1 << 14;  // 128 KB of pairs
constexpr int kMostShift = 20;

std::int32_t bits(float x) noexcept { return std::bit_cast<std::int32_t>(x); }

// The most bits that may be left off so that no bin holds two thresholds.
int bin_shift(std::span<const float> threshold) {
  int shift = kMostShift;
  for (std::size_t i = 1; i < threshold.size(); ++i) {
    while (shift > 0 && bits(threshold[i - 1]) >> shift == bits(threshold[i]) >> shift) --shift;
  }
  return shift;
}

// The fast rows compute the half way points themselves, in floats.
bool half_way_in_floats(std::span<const float> light, std::span<const float> threshold) {
  for (std::size_t i = 0; i < threshold.size(); ++i) {
    const float middle = (light[i] + light[i + 1]) * 0.5F;
    if (std::nextafter(middle, std::numeric_limits<float>::infinity()) != threshold[i])
      return false;
  }
  return true;
}

}  // namespace

LevelTable::LevelTable(std::span<const float> lights, std::span<const float> thresholds,
                       std::span<const std::uint16_t> level_codes) {
  if (lights.size() > kFew) {
    if (!(thresholds.front() > 0) || !half_way_in_floats(lights, thresholds)) return;
    shift = bin_shift(thresholds);
    first = (bits(thresholds.front()) >> shift) - 1;
    last = (bits(thresholds.back()) >> shift) + 1;
    if (last - first >= kMostBins) return;
    std::size_t level = 0;
    for (std::int32_t bin = first; bin <= last; ++bin) {
      const std::size_t lower = level;
      if (level < thresholds.size() && bits(thresholds[level]) >> shift == bin) ++level;
      pair.push_back({lights[lower], lights[level]});
      codes.push_back(level_codes[lower] | level_codes[level] << 16);
    }
  }
  light.assign(lights.begin(), lights.end());
  threshold.assign(thresholds.begin(), thresholds.end());
  code.assign(level_codes.begin(), level_codes.end());
}

const FloydSteinbergRows* floyd_steinberg_rows() {
  return chosen_instruction_set(all_floyd_steinberg_rows());
}

}  // namespace tristim::detail
