#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "tristim/palette/histogram.h"
#include "tristim/palette/metric.h"

namespace tristim::detail {

/// Where a colour lies in a metric; the last number is that of its alpha, 0 where it is opaque.
/// Translucent colours lie the nearer together the less of them is seen.
using Place = std::array<float, 4>;

/// Colours with their places, in planes, and how much each counts.
struct Places {
  std::array<std::vector<float>, 4> axis;
  std::vector<float> weight;
  int axes = 3;  // 4 where a colour is translucent

  std::size_t size() const noexcept { return weight.size(); }
  Place at(std::size_t i) const noexcept {
    return {axis[0][i], axis[1][i], axis[2][i], axis[3][i]};
  }
  void push_back(const Place& place, float w);
};

/// Colours to places; keeps what they have in common.
class Placer {
 public:
  explicit Placer(const Metric& metric);
  Place operator()(Color8 color) const;

  /// Three numbers for each of `entries`, before alpha.
  void place(std::span<const Histogram::Entry> entries, std::span<float> pixels) const;
  Place with_alpha(const float* place, std::uint8_t alpha) const noexcept;

 private:
  const Metric* metric_;
  float length_;  // of black to white: what alpha is worth
  std::array<float, 256> light_;
};

Places places_of(std::span<const Histogram::Entry> entries, const Metric& metric);

}  // namespace tristim::detail
