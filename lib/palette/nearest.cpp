#include "tristim/palette/nearest.h"

#include <algorithm>
#include <cstddef>
#include <limits>

#include "lib/palette/clusters.h"

namespace tristim {

NearestColor::NearestColor(std::span<const Rgb> palette, const Metric& metric) : metric_(&metric) {
  for (const Rgb& entry : palette) {
    const auto place = metric.place(entry);
    x_.push_back(place[0]);
    y_.push_back(place[1]);
    z_.push_back(place[2]);
    std::array pixel{static_cast<float>(entry.r), static_cast<float>(entry.g),
                     static_cast<float>(entry.b)};
    place_row(metric, pixel);
    for (std::size_t a = 0; a < 3; ++a) row_[a].push_back(pixel[a]);
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

void NearestColor::find_row(std::span<const float> pixels, std::span<std::uint16_t> indices) const {
  std::vector<float> placed(pixels.begin(), pixels.end());
  place_row(*metric_, placed);
  detail::Places places;
  for (auto& axis : places.axis) axis.resize(indices.size());
  places.weight.assign(indices.size(), 1);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    for (std::size_t a = 0; a < 3; ++a) places.axis[a][i] = placed[3 * i + a];
  }
  detail::Places entries;
  std::copy(row_.begin(), row_.end(), entries.axis.begin());
  entries.axis[3].resize(x_.size());
  entries.weight.resize(x_.size());
  const detail::Nearest nearest =
      detail::nearest_entries(detail::runs_of(std::move(places)), entries);
  for (std::size_t i = 0; i < indices.size(); ++i) {
    indices[i] = static_cast<std::uint16_t>(nearest.index[i]);
  }
}

}  // namespace tristim
