#include "lib/pipeline/ink_planes.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace tristim::detail {
namespace {

constexpr std::size_t kGainSteps = 8192;
constexpr std::size_t kMostInks = 8;

}  // namespace

ToneBeforeGain::ToneBeforeGain(const DotGain& gain) {
  if (std::holds_alternative<NoGain>(gain)) return;
  for (std::size_t i = 0; i <= kGainSteps; ++i) {
    const double tone = static_cast<double>(i) / kGainSteps;
    table_.push_back(static_cast<float>(1 - asked_area(gain, 1 - tone)));
  }
}

float ToneBeforeGain::operator()(float tone) const noexcept {
  if (table_.empty()) return tone;
  if (!(tone > 0)) return table_.front();
  if (tone >= 1) return table_.back();
  const float place = tone * static_cast<float>(kGainSteps);
  const auto i = static_cast<std::size_t>(place);
  return table_[i] + (table_[i + 1] - table_[i]) * (place - static_cast<float>(i));
}

InkPlanes::InkPlanes(const Display& display, BlackPoint black_point)
    : count_(static_cast<int>(display.press->inks.size())),
      separation_(*display.press, black_point == BlackPoint::kRelative),
      before_gain_(display.dots ? display.dots->gain : NoGain{}) {}

void InkPlanes::row(std::span<const float> rgb, std::span<float> planes) const noexcept {
  const std::size_t width = rgb.size() / 3;
  const auto count = static_cast<std::size_t>(count_);
  std::array<double, kMostInks> areas{};
  for (std::size_t x = 0; x < width; ++x) {
    const float* p = &rgb[3 * x];
    const bool repeated = x > 0 && p[0] == p[-3] && p[1] == p[-2] && p[2] == p[-1];
    if (!repeated) separation_.areas({p[0], p[1], p[2]}, std::span(areas.data(), count));
    for (std::size_t i = 0; i < count; ++i) {
      planes[i * width + x] =
          repeated ? planes[i * width + x - 1] : before_gain_(static_cast<float>(1 - areas[i]));
    }
  }
}

}  // namespace tristim::detail
