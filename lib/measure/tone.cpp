#include "tristim/measure/tone.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lib/core/parallel.h"
#include "lib/measure/pair.h"
#include "tristim/color/lab.h"

namespace tristim {
namespace {

constexpr int kSteps = 32;             // of L*
constexpr double kLeastShare = 0.001;  // of the pixels, for a step to count
constexpr int kLeastRadius = 4;

// Means over 2 radius + 1 neighbours of a line, mirrored at its ends. `in` and `out` are `stride`
// apart from one to the next and may not be the same.
void blur_line(const double* in, double* out, int size, std::ptrdiff_t stride, int radius) {
  const auto value = [&](int i) { return in[detail::mirrored(i, size) * stride]; };
  double sum = 0;
  for (int i = -radius; i <= radius; ++i) sum += value(i);
  for (int i = 0; i < size; ++i) {
    out[i * stride] = sum / (2 * radius + 1);
    sum += value(i + radius + 1) - value(i - radius);
  }
}

std::vector<double> blurred(const LuminanceMap& map, int radius) {
  std::vector<double> across(map.value.size());
  std::vector<double> result(map.value.size());
  detail::parallel_for_rows(map.height, 0, [&](int y) {
    blur_line(&map.value[map.index(0, y)], &across[map.index(0, y)], map.width, 1, radius);
  });
  detail::parallel_for_rows(map.width, 0, [&](int x) {
    blur_line(&across[map.index(x, 0)], &result[map.index(x, 0)], map.height, map.width, radius);
  });
  return result;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v;
  return sum / static_cast<double>(values.size());
}

std::vector<TonePoint> tone_curve(const std::vector<double>& reference,
                                  const std::vector<double>& result) {
  std::array<TonePoint, kSteps> sums{};
  for (std::size_t i = 0; i < reference.size(); ++i) {
    const auto step = static_cast<int>(lstar_from_luminance(reference[i]) / 100 * kSteps);
    TonePoint& point = sums[static_cast<std::size_t>(std::clamp(step, 0, kSteps - 1))];
    point.reference += reference[i];
    point.result += result[i];
    point.share += 1;
  }
  std::vector<TonePoint> curve;
  const auto pixels = static_cast<double>(reference.size());
  for (const TonePoint& s : sums) {
    if (!(s.share > kLeastShare * pixels)) continue;
    curve.push_back({s.reference / s.share, s.result / s.share, s.share / pixels});
  }
  return curve;
}

}  // namespace

double lstar_difference(const TonePoint& point) noexcept {
  return lstar_from_luminance(point.result) - lstar_from_luminance(point.reference);
}

ToneFigures tone_figures(const LuminanceMap& reference, const LuminanceMap& result) {
  detail::check_sizes(reference, result);
  ToneFigures figures;
  figures.mean_reference = mean(reference.value);
  figures.mean_result = mean(result.value);
  if (figures.mean_reference != 0) {
    figures.relative = figures.mean_result / figures.mean_reference - 1;
  }
  const int radius = std::max(kLeastRadius, std::min(reference.width, reference.height) / 64);
  figures.curve = tone_curve(blurred(reference, radius), blurred(result, radius));
  for (const TonePoint& point : figures.curve) {
    const double difference = std::fabs(lstar_difference(point));
    figures.lstar_max = std::max(figures.lstar_max, difference);
    figures.lstar_mean += difference / static_cast<double>(figures.curve.size());
  }
  return figures;
}

std::vector<TonePoint> patch_tones(const LuminanceMap& reference, const LuminanceMap& result,
                                   int patches) {
  detail::check_sizes(reference, result);
  if (patches < 1 || patches > reference.width) {
    throw std::invalid_argument(std::to_string(patches) + " patches do not fit into " +
                                std::to_string(reference.width) + " columns");
  }
  const int width = reference.width / patches;
  const int margin = width / 16;
  const double pixels = static_cast<double>(width - 2 * margin) * reference.height;
  std::vector<TonePoint> points(static_cast<std::size_t>(patches));
  for (int i = 0; i < patches; ++i) {
    TonePoint& point = points[static_cast<std::size_t>(i)];
    point.share = pixels / static_cast<double>(reference.value.size());
    for (int y = 0; y < reference.height; ++y) {
      for (int x = i * width + margin; x < (i + 1) * width - margin; ++x) {
        point.reference += reference.at(x, y) / pixels;
        point.result += result.at(x, y) / pixels;
      }
    }
  }
  return points;
}

}  // namespace tristim
