#pragma once

#include "tristim/color/rgb.h"

namespace tristim {

/// Subtractive inks over white paper, each [0, 1].
struct Cmy {
  double c = 0, m = 0, y = 0;
  friend constexpr bool operator==(const Cmy&, const Cmy&) = default;
};

/// The same with black.
struct Cmyk {
  double c = 0, m = 0, y = 0, k = 0;
  friend constexpr bool operator==(const Cmyk&, const Cmyk&) = default;
};

/// RGB to CMY and back: 1 - RGB [Shoaff 2.2.5]. Nothing is clamped.
Cmy rgb_to_cmy(EncodedRgb rgb) noexcept;
EncodedRgb cmy_to_rgb(Cmy cmy) noexcept;

/// How much black, and how much ink.
struct BlackGeneration {
  double replacement = 1;  ///< of the grey component min(C, M, Y) that becomes black, [0, 1]
  double limit = 4;        ///< of C + M + Y + K: 3 is 300 %
};

/// C, M and Y scaled so that all inks add up to no more than `limit`, after K has been cut to it.
Cmyk limit_ink(Cmyk ink, double limit) noexcept;

/// CMY to CMYK by subtraction: K = r min(C, M, Y), C - K, M - K, Y - K [Shoaff 2.2.5].
///
/// Where the inks add up to more than the limit they are scaled as by limit_ink; such a colour does
/// not come back.
Cmyk cmy_to_cmyk_subtract(Cmy cmy, const BlackGeneration& black = {}) noexcept;

/// The inverse of cmy_to_cmyk_subtract, whatever the replacement was: C + K, M + K, Y + K.
Cmy cmyk_subtract_to_cmy(Cmyk cmyk) noexcept;

/// CMY to CMYK by covering: K = r min(C, M, Y), (C - K)/(1 - K) and so on; K = 1 needs no other ink
/// [CSS4 10]. Limited as cmy_to_cmyk_subtract.
Cmyk cmy_to_cmyk_normalised(Cmy cmy, const BlackGeneration& black = {}) noexcept;

/// The inverse of cmy_to_cmyk_normalised, whatever the replacement was: C (1 - K) + K.
Cmy cmyk_normalised_to_cmy(Cmyk cmyk) noexcept;

}  // namespace tristim
