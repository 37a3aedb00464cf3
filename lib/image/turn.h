#pragma once

#include <memory>

#include "tristim/image/picture.h"

namespace tristim::detail {

/// A turn or a flip of a picture: the pixel (x, y) of the result is (x, y) of the source, or (y, x)
/// where `transpose` is set, then counted from the other end where `flip_x`, `flip_y` (of the
/// source) are set.
struct Turn {
  bool transpose = false;
  bool flip_x = false;
  bool flip_y = false;
  friend constexpr bool operator==(const Turn&, const Turn&) = default;
};

/// What makes rows stored with an EXIF orientation upright [CIPA DC-008, tag 274]. Anything
/// but 1..8 is 1.
Turn turn_from_orientation(int orientation) noexcept;

/// Clockwise by 0, 90, 180 or 270 degrees. Throws std::invalid_argument for other angles.
Turn turn_from_degrees(int clockwise_deg);

/// First `a`, then `b`.
Turn combine(Turn a, Turn b) noexcept;

/// The turned rows; the source itself where there is nothing to turn. All but a horizontal flip
/// hold the whole picture. Throws Error (kContent) where that is more than 4 GiB.
std::unique_ptr<RowSource> turn(std::unique_ptr<RowSource> source, Turn how);

/// Memory that a step may take at once; beyond it a picture is refused before anything is
/// allocated.
inline constexpr double kMaxHeldBytes = 4.0 * (1 << 30);

}  // namespace tristim::detail
