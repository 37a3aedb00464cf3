#include "lib/lut/io/tables.h"

#include <algorithm>
#include <cmath>

namespace tristim::detail {
namespace {

std::vector<float> read_rows(TextLines& lines, std::size_t samples) {
  lines.promise(samples);
  std::vector<float> rgb;
  rgb.reserve(samples);
  while (rgb.size() < samples) {
    lines.need();
    for (int c = 0; c < 3; ++c) rgb.push_back(lines.take_float());
    lines.end_line();
  }
  return rgb;
}

}  // namespace

LutParts parts_of(const Lut& lut) noexcept {
  LutParts parts;
  const std::size_t count = lut.steps.size();
  if (count == 0 || count > 2) return {};
  parts.points = std::get_if<LutPoints>(&lut.steps.front());
  parts.curves = std::get_if<Lut1D>(&lut.steps[parts.points != nullptr ? count - 1 : 0]);
  parts.cube = std::get_if<Lut3D>(&lut.steps.back());
  const int found = static_cast<int>(parts.points != nullptr) +
                    static_cast<int>(parts.curves != nullptr) +
                    static_cast<int>(parts.cube != nullptr);
  return found == static_cast<int>(count) ? parts : LutParts{};
}

bool equal_channels(const LutRange& range) noexcept {
  const auto equal = [](const std::array<double, 3>& v) { return v[0] == v[1] && v[1] == v[2]; };
  return equal(range.low) && equal(range.high);
}

bool equal_channels(const Lut1D& curves) noexcept {
  if (!equal_channels(curves.range)) return false;
  for (std::size_t i = 0; i < curves.rgb.size(); i += 3) {
    if (curves.rgb[i] != curves.rgb[i + 1] || curves.rgb[i] != curves.rgb[i + 2]) return false;
  }
  return true;
}

std::size_t blue_fastest(std::size_t index, std::size_t size) noexcept {
  const std::size_t blue = index / (size * size);
  const std::size_t green = index / size % size;
  return (index % size * size + green) * size + blue;
}

Lut1D read_curve_rows(TextLines& lines, int size) {
  return {{}, size, read_rows(lines, curve_samples(size))};
}

Lut3D read_cube_rows(TextLines& lines, int size) {
  return {{}, size, read_rows(lines, cube_samples(size))};
}

std::uint16_t table_code(float value, int most) noexcept {
  const double scaled = std::floor(static_cast<double>(value) * most + 0.5);
  return static_cast<std::uint16_t>(std::clamp(scaled, 0.0, static_cast<double>(most)));
}

double step_point(double low, double high, int i, int size) noexcept {
  return i == size - 1 ? high : low + (high - low) * i / (size - 1);
}

bool equal_steps(const std::vector<float>& points, double low, double high) noexcept {
  const auto size = static_cast<int>(points.size());
  for (int i = 0; i < size; ++i) {
    const auto point = static_cast<float>(step_point(low, high, i, size));
    if (points[static_cast<std::size_t>(i)] != point) return false;
  }
  return true;
}

}  // namespace tristim::detail
