#include "tristim/palette/nearest.h"

#include <cstddef>
#include <limits>

namespace tristim {

NearestColor::NearestColor(std::span<const Rgb> palette, const Metric& metric) : metric_(&metric) {
  for (const Rgb& entry : palette) {
    const auto place = metric.place(entry);
    x_.push_back(place[0]);
    y_.push_back(place[1]);
    z_.push_back(place[2]);
  }
}

int NearestColor::find(Rgb linear_srgb) const noexcept {
  const auto place = metric_->place(linear_srgb);
  float least = std::numeric_limits<float>::infinity();
  std::size_t best = 0;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    const float dx = x_[i] - place[0];
    const float dy = y_[i] - place[1];
    const float dz = z_[i] - place[2];
    const float distance = dx * dx + dy * dy + dz * dz;
    if (distance < least) {
      least = distance;
      best = i;
    }
  }
  return static_cast<int>(best);
}

}  // namespace tristim
