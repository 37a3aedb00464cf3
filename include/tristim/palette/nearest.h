#pragma once

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

 private:
  const Metric* metric_;
  std::vector<float> x_, y_, z_;
};

}  // namespace tristim
