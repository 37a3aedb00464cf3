#pragma once

#include <algorithm>
#include <cstdint>

namespace tristim::detail {

/// A rectangle of pixels in an EXR file's coordinates, whose origin is anywhere.
struct PixelWindow {
  std::int64_t x = 0, y = 0, width = 0, height = 0;
};

/// The part of the data window that is seen through the display window, relative to that; of no
/// width or height where there is none.
inline PixelWindow visible(const PixelWindow& data, const PixelWindow& display) noexcept {
  const std::int64_t x = std::max(data.x, display.x);
  const std::int64_t y = std::max(data.y, display.y);
  const std::int64_t end_x = std::min(data.x + data.width, display.x + display.width);
  const std::int64_t end_y = std::min(data.y + data.height, display.y + display.height);
  return {x - display.x, y - display.y, std::max<std::int64_t>(end_x - x, 0),
          std::max<std::int64_t>(end_y - y, 0)};
}

inline bool covers(const PixelWindow& data, const PixelWindow& display) noexcept {
  const PixelWindow seen = visible(data, display);
  return seen.width == display.width && seen.height == display.height;
}

}  // namespace tristim::detail
