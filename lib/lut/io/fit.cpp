#include <algorithm>
#include <cmath>
#include <optional>

#include "lib/lut/io/tables.h"
#include "tristim/core/error.h"
#include "tristim/lut/io/file.h"

namespace tristim {
namespace {

using detail::parts_of;
using detail::step_point;

// What goes in where a table begins and ends: that of the first step, unless the format has 0 to 1.
LutRange range_of(const Lut& lut, LutRanges ranges) {
  LutRange range;
  if (!lut.steps.empty() && ranges != LutRanges::kUnit) {
    const LutStep& first = lut.steps.front();
    if (const auto* curves = std::get_if<Lut1D>(&first)) range = curves->range;
    if (const auto* cube = std::get_if<Lut3D>(&first)) range = cube->range;
    if (const auto* points = std::get_if<LutPoints>(&first)) {
      for (std::size_t c = 0; c < 3; ++c) {
        range.low[c] = points->curves[c].in.front();
        range.high[c] = points->curves[c].in.back();
      }
    }
  }
  if (ranges == LutRanges::kEqual) {
    range.low.fill(std::ranges::min(range.low));
    range.high.fill(std::ranges::max(range.high));
  }
  return range;
}

// Whether each channel depends on itself alone.
bool is_by_channel(const Lut& lut) {
  return std::ranges::all_of(lut.steps, [](const LutStep& step) {
    const auto* matrix = std::get_if<LutMatrix>(&step);
    if (matrix != nullptr) return matrix->matrix.isDiagonal(0);
    return !std::holds_alternative<Lut3D>(step);
  });
}

Rgb point_at(const LutRange& range, int r, int g, int b, int size) {
  return {step_point(range.low[0], range.high[0], r, size),
          step_point(range.low[1], range.high[1], g, size),
          step_point(range.low[2], range.high[2], b, size)};
}

void append(std::vector<float>& table, Rgb rgb) {
  for (const double value : {rgb.r, rgb.g, rgb.b}) table.push_back(static_cast<float>(value));
}

Lut1D sampled_curves(const Lut& lut, const LutRange& range, int size) {
  Lut1D curves{range, size, {}};
  curves.rgb.reserve(curve_samples(size));
  for (int i = 0; i < size; ++i) append(curves.rgb, evaluate(lut, point_at(range, i, i, i, size)));
  return curves;
}

Lut3D sampled_cube(const Lut& lut, const LutRange& range, int size) {
  Lut3D cube{range, size, {}};
  cube.rgb.reserve(cube_samples(size));
  for (int b = 0; b < size; ++b) {
    for (int g = 0; g < size; ++g) {
      for (int r = 0; r < size; ++r) {
        append(cube.rgb, evaluate(lut, point_at(range, r, g, b, size)));
      }
    }
  }
  return cube;
}

// The curves of the first step, and what follows as a cube over what they give.
std::optional<Lut> shaper_and_cube(const Lut& lut, const LutCapacity& capacity,
                                   const LutFitSizes& sizes) {
  if (capacity.shaper == 0 || lut.steps.size() < 2) return {};
  const auto* shaper = std::get_if<Lut1D>(&lut.steps.front());
  if (shaper == nullptr || (capacity.grey && !detail::equal_channels(*shaper))) return {};
  const Lut first{"", {*shaper}};
  const Lut rest{"", {lut.steps.begin() + 1, lut.steps.end()}};
  const int size = sizes.shaper > 0 ? sizes.shaper : shaper->size;
  Lut fitted{lut.title, {}};
  fitted.steps.emplace_back(sampled_curves(first, range_of(first, capacity.first), size));
  fitted.steps.emplace_back(sampled_cube(rest, range_of(rest, capacity.second), sizes.cube));
  return fitted;
}

}  // namespace

Lut fit_lut(const Lut& lut, const LutFormat& format, const LutFitSizes& sizes,
            const std::string& path) {
  const LutCapacity& capacity = format.holds;
  const bool by_channel = is_by_channel(lut);
  Lut fitted{lut.title, {}};
  int size = sizes.cube;
  if (by_channel && capacity.curves > 0 && sizes.curves > 0) {
    size = sizes.curves;
    fitted.steps.emplace_back(sampled_curves(lut, range_of(lut, capacity.alone), size));
  } else if (capacity.cube > 0 && size > 0) {
    auto two = shaper_and_cube(lut, capacity, sizes);
    if (two) fitted = *std::move(two);
    if (!two) fitted.steps.emplace_back(sampled_cube(lut, range_of(lut, capacity.alone), size));
  } else if (!by_channel && capacity.cube == 0) {
    throw Error(ErrorKind::kMisuse, path,
                "format " + std::string(format.name) +
                    " has curves alone, and channels of the table depend on others",
                "use a format that has cubes");
  }
  if (!fitted.steps.empty() && holds(format, fitted)) return fitted;
  throw Error(ErrorKind::kMisuse, path,
              "format " + std::string(format.name) + " does not hold a table of size " +
                  std::to_string(size),
              "it holds " + describe(capacity));
}

}  // namespace tristim
