#include "lib/palette/places.h"

#include <algorithm>
#include <cmath>

#include "tristim/color/transfer.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kBlock = 256;  // pixels

}  // namespace

void Places::push_back(const Place& place, float w) {
  for (std::size_t i = 0; i < 4; ++i) axis[i].push_back(place[i]);
  weight.push_back(w);
  if (place[3] != 0) axes = 4;
}

Placer::Placer(const Metric& metric) : metric_(&metric), length_(0), light_{} {
  for (std::size_t i = 0; i < light_.size(); ++i) {
    light_[i] = static_cast<float>(srgb_decode(static_cast<double>(i) / 255));
  }
  const auto black = metric.place({0, 0, 0});
  const auto white = metric.place({1, 1, 1});
  float sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += (white[i] - black[i]) * (white[i] - black[i]);
  length_ = std::sqrt(sum);
}

void Placer::place(std::span<const Histogram::Entry> entries, std::span<float> pixels) const {
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Color8 c = entries[i].color;
    pixels[3 * i] = light_[c.r];
    pixels[3 * i + 1] = light_[c.g];
    pixels[3 * i + 2] = light_[c.b];
  }
  place_row(*metric_, pixels.first(3 * entries.size()));
}

Place Placer::with_alpha(const float* place, std::uint8_t alpha) const noexcept {
  if (alpha == 255) return {place[0], place[1], place[2], 0};
  const float part = static_cast<float>(alpha) / 255;
  return {place[0] * part, place[1] * part, place[2] * part, (1 - part) * length_};
}

Place Placer::operator()(Color8 color) const {
  const Histogram::Entry entry{color, 1};
  std::array<float, 3> pixel{};
  place({&entry, 1}, pixel);
  return with_alpha(pixel.data(), color.a);
}

Places places_of(std::span<const Histogram::Entry> entries, const Metric& metric) {
  const Placer placer(metric);
  Places places;
  for (auto& axis : places.axis) axis.resize(entries.size());
  places.weight.resize(entries.size());
  std::array<float, 3 * kBlock> pixels{};
  for (std::size_t first = 0; first < entries.size(); first += kBlock) {
    const auto block = entries.subspan(first, std::min(kBlock, entries.size() - first));
    placer.place(block, pixels);
    for (std::size_t i = 0; i < block.size(); ++i) {
      const Place place = placer.with_alpha(&pixels[3 * i], block[i].color.a);
      for (std::size_t a = 0; a < 4; ++a) places.axis[a][first + i] = place[a];
      places.weight[first + i] = static_cast<float>(block[i].count);
      if (place[3] != 0) places.axes = 4;
    }
  }
  return places;
}

}  // namespace tristim::detail
