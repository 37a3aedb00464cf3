#pragma once

namespace tristim {

// Hues are in degrees. A colour without a hue (a grey) has NaN there, and every inverse takes it.

/// The same hue in [0, 360): -60 and 660 are 300. NaN stays NaN; infinities have no hue.
double wrap_hue(double deg) noexcept;

/// Whether two hues are one: equal modulo 360, or both undefined.
bool same_hue(double first_deg, double second_deg) noexcept;

/// Whether two components are one: equal, or both undefined.
bool same_component(double first, double second) noexcept;

}  // namespace tristim
