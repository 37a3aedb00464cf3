#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tristim/color/rgb.h"
#include "tristim/palette/metric.h"

namespace tristim {

/// Finds the entry of a palette that is nearest in a metric, exactly; of several the first.
class NearestColor {
 public:
  /// `palette` in linear sRGB, at least one entry.
  NearestColor(std::span<const Rgb> palette, const Metric& metric);

  int find(Rgb linear_srgb) const noexcept;

  /// For each of a row of three-channel pixels, places being taken by place_row(): exactly what a
  /// comparison with every entry finds, most of which are left out for all pixels of a run at once.
  void find_row(std::span<const float> pixels, std::span<std::uint16_t> indices) const;

 private:
  const Metric* metric_;
  std::vector<float> x_, y_, z_;
  std::array<std::vector<float>, 3> row_;  // the same by place_row()
};

}  // namespace tristim
