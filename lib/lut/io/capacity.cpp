#include <algorithm>

#include "lib/lut/io/tables.h"
#include "tristim/lut/io/file.h"

namespace tristim {
namespace {

bool fits(LutRanges ranges, const LutRange& range) noexcept {
  switch (ranges) {
    case LutRanges::kUnit:
      return range == LutRange{};
    case LutRanges::kEqual:
      return detail::equal_channels(range);
    case LutRanges::kAny:
      return true;
  }
  return false;
}

// `most`: 0 where there may be none.
bool fits(const LutCapacity& capacity, int size, int most) noexcept {
  const auto& sizes = capacity.sizes;
  return size <= most && (sizes.empty() || std::ranges::find(sizes, size) != sizes.end());
}

bool any_step_fits(const LutCapacity& capacity, const LutStep& step) noexcept {
  if (const auto* curves = std::get_if<Lut1D>(&step))
    return fits(capacity, curves->size, capacity.curves);
  if (const auto* cube = std::get_if<Lut3D>(&step))
    return fits(capacity, cube->size, capacity.cube);
  return capacity.points || !std::holds_alternative<LutPoints>(step);
}

bool points_fit(const LutCapacity& capacity, const LutPoints& points, bool two) noexcept {
  return (two ? capacity.points_first : capacity.points) &&
         std::ranges::all_of(points.curves, [&](const LutCurve& curve) {
           return curve.in.size() <= static_cast<std::size_t>(capacity.curves);
         });
}

// A cube, alone or behind a shaper.
bool cube_fits(const LutCapacity& capacity, const detail::LutParts& parts, bool two) noexcept {
  if (!fits(capacity, parts.cube->size, capacity.cube)) return false;
  if (!fits(two ? capacity.second : capacity.alone, parts.cube->range)) return false;
  const Lut1D* const shaper = parts.curves;
  if (shaper == nullptr) return true;
  return fits(capacity, shaper->size, capacity.shaper) && fits(capacity.first, shaper->range) &&
         (!capacity.grey || detail::equal_channels(*shaper));
}

std::string range_words(LutRanges ranges) {
  switch (ranges) {
    case LutRanges::kUnit:
      return " over 0 to 1";
    case LutRanges::kEqual:
      return " over one range for all channels";
    case LutRanges::kAny:
      return "";
  }
  return "";
}

std::string size_words(const LutCapacity& capacity, int most) {
  if (capacity.sizes.empty()) return "2 to " + std::to_string(most);
  std::string words;
  for (const int size : capacity.sizes) words += (words.empty() ? "" : ", ") + std::to_string(size);
  return words;
}

}  // namespace

bool holds(const LutFormat& format, const Lut& lut) noexcept {
  const LutCapacity& capacity = format.holds;
  if (capacity.any) {
    return std::ranges::all_of(lut.steps,
                               [&](const LutStep& step) { return any_step_fits(capacity, step); });
  }
  const detail::LutParts parts = detail::parts_of(lut);
  const bool two = lut.steps.size() == 2;
  if (parts.points != nullptr && !points_fit(capacity, *parts.points, two)) return false;
  if (two && capacity.shaper == 0) return false;
  if (parts.cube != nullptr) return cube_fits(capacity, parts, two);
  if (parts.curves != nullptr) {
    return fits(capacity, parts.curves->size, capacity.curves) &&
           fits(two ? capacity.second : capacity.alone, parts.curves->range);
  }
  return parts.points != nullptr;
}

std::string describe(const LutCapacity& capacity) {
  std::string words;
  if (capacity.curves > 0) {
    words += "curves of " + size_words(capacity, capacity.curves) + " entries" +
             range_words(capacity.alone);
  }
  if (capacity.cube > 0) {
    words += (words.empty()  ? ""
              : capacity.any ? ", "
                             : ", or ") +
             std::string("a cube of ") + size_words(capacity, capacity.cube) + " points an edge" +
             range_words(capacity.alone);
  }
  if (capacity.shaper > 0) {
    words += capacity.grey ? ", one curve in front of it" : ", or curves and then a cube";
  }
  if (capacity.points) words += ", or curves through points of their own";
  if (capacity.points_first) words += ", curves through points of their own in front of either";
  if (capacity.any) words += ", matrices; any number of them";
  return words;
}

}  // namespace tristim
