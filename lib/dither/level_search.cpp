#include "tristim/dither/level_search.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <limits>

namespace tristim {
namespace {

// Bins of 1/128 octave hold about one threshold of an 8-bit curve; 16 bits want finer ones.
constexpr int kCoarseShift = 16;
constexpr int kFineShift = 12;
constexpr std::size_t kManyThresholds = 1024;
constexpr std::size_t kFewThresholds = 7;

}  // namespace

LevelSearch::LevelSearch(std::span<const float> ascending)
    : thresholds_(ascending.begin(), ascending.end()),
      shift_(ascending.size() > kManyThresholds ? kFineShift : kCoarseShift) {
  const auto positive = std::upper_bound(thresholds_.begin(), thresholds_.end(), 0.0F);
  not_positive_ = static_cast<std::uint16_t>(positive - thresholds_.begin());
  if (positive != thresholds_.end()) {
    first_bits_ = std::bit_cast<std::uint32_t>(*positive) >> shift_;
    const std::uint32_t last_bits = std::bit_cast<std::uint32_t>(thresholds_.back()) >> shift_;
    for (std::uint32_t bin = first_bits_; bin <= last_bits; ++bin) {
      const float start = std::bit_cast<float>(bin << shift_);
      const auto at = std::upper_bound(thresholds_.begin(), thresholds_.end(), start);
      start_.push_back(static_cast<std::uint16_t>(at - thresholds_.begin()));
    }
  }
  thresholds_.push_back(std::numeric_limits<float>::quiet_NaN());
}

// Dithered values fall on either side of a threshold by chance: comparisons that are added up cost
// less than branches that are guessed wrong.
int LevelSearch::count_not_above(float value) const noexcept {
  const std::size_t thresholds = thresholds_.size() - 1;
  if (thresholds <= kFewThresholds) {
    int count = 0;
    for (std::size_t i = 0; i < thresholds; ++i) count += value >= thresholds_[i] ? 1 : 0;
    return count;
  }
  if (!(value > 0)) {
    if (value == 0) return not_positive_;
    int count = 0;  // negative or NaN: rare
    while (value >= thresholds_[static_cast<std::size_t>(count)]) ++count;
    return count;
  }
  const std::uint32_t bin = std::bit_cast<std::uint32_t>(value) >> shift_;
  if (bin < first_bits_ || start_.empty()) return not_positive_;
  const std::size_t i = std::min<std::size_t>(bin - first_bits_, start_.size() - 1);
  std::size_t count = start_[i];
  count += value >= thresholds_[count] ? 1 : 0;  // a bin has seldom more than one
  while (value >= thresholds_[count]) ++count;
  return static_cast<int>(count);
}

}  // namespace tristim
