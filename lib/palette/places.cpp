#include "lib/palette/places.h"

#include <cmath>

#include "tristim/color/transfer.h"

namespace tristim::detail {

void Places::push_back(const Place& place, float w) {
  for (std::size_t i = 0; i < 4; ++i) axis[i].push_back(place[i]);
  weight.push_back(w);
  if (place[3] != 0) axes = 4;
}

Placer::Placer(const Metric& metric) : metric_(&metric), length_(0), light_{} {
  for (std::size_t i = 0; i < light_.size(); ++i) {
    light_[i] = srgb_decode(static_cast<double>(i) / 255);
  }
  const auto black = metric.place({0, 0, 0});
  const auto white = metric.place({1, 1, 1});
  float sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (white[i] - black[i]) * (white[i] - black[i]);
  length_ = std::sqrt(sum);
}

Place Placer::operator()(Color8 color) const noexcept {
  const auto place = metric_->place({light_[color.r], light_[color.g], light_[color.b]});
  if (color.a == 255) return {place[0], place[1], place[2], 0};
  const float alpha = static_cast<float>(color.a) / 255;
  return {place[0] * alpha, place[1] * alpha, place[2] * alpha, (1 - alpha) * length_};
}

Places places_of(std::span<const Histogram::Entry> entries, const Metric& metric) {
  const Placer placer(metric);
  Places places;
  for (auto& axis : places.axis) axis.reserve(entries.size());
  places.weight.reserve(entries.size());
  for (const Histogram::Entry& entry : entries) {
    places.push_back(placer(entry.color), static_cast<float>(entry.count));
  }
  return places;
}

}  // namespace tristim::detail
