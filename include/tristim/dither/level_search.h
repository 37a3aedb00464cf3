#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace tristim {

/// Counts how many of a few thousand ascending floats are not above a value, in constant time: the
/// value's leading bits give the count at the start of their bin, the rest is a short walk. Exact
/// for every float.
class LevelSearch {
 public:
  /// `ascending` may hold infinities (never reached). At most 65535 of them.
  explicit LevelSearch(std::span<const float> ascending);

  /// How many are <= value; 0 for NaN.
  int count_not_above(float value) const noexcept;

  std::span<const float> thresholds() const noexcept {
    return std::span(thresholds_).first(thresholds_.size() - 1);
  }

 private:
  std::vector<float> thresholds_;     // and a NaN that ends every walk
  std::vector<std::uint16_t> start_;  // by bin of a positive float
  int shift_ = 16;
  std::uint32_t first_bits_ = 0;    // of the first positive threshold
  std::uint16_t not_positive_ = 0;  // how many are <= 0
};

}  // namespace tristim
