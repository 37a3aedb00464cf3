#pragma once

#include <array>
#include <string_view>

#include "tristim/color/rgb.h"

namespace tristim {

/// A kind of dichromatic vision: one kind of cones is missing.
struct ColorDeficiency {
  std::string_view name;
  int missing_cone;  // 0, 1, 2: long, middle, short wavelengths
  /// Wavelengths in nm that look alike to both eyes, one on each side of the neutral colours; 0 and
  /// 0: the blue primary alone, one plane for all colours.
  std::array<double, 2> anchors_nm;
  std::string_view source;
};

/// The command line and the tests read this list.
inline constexpr std::array kColorDeficiencies{
    ColorDeficiency{"protanopia", 0, {0, 0}, "[Vienot99]"},
    ColorDeficiency{"deuteranopia", 1, {0, 0}, "[Vienot99]"},
    ColorDeficiency{"tritanopia", 2, {485, 660}, "[Brettel97]"}};

/// Linear sRGB as it looks to such an observer. Colours are projected along the missing cone's axis
/// onto planes through the neutral colours, which stay as they are; saturated colours may come out
/// of [0, 1]. Any finite input.
Rgb simulate_deficiency(Rgb linear_srgb, const ColorDeficiency& deficiency) noexcept;

}  // namespace tristim
