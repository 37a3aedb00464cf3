#pragma once

namespace tristim {

/// Linear light of three primaries; unitless, [0, 1] spans the gamut.
struct Rgb {
  double r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Rgb&, const Rgb&) = default;
};

/// RGB behind a transfer function, as files and frame buffers hold it; [0, 1] spans the gamut.
struct EncodedRgb {
  double r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const EncodedRgb&, const EncodedRgb&) = default;
};

}  // namespace tristim
