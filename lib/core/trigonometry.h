#pragma once

#include "lib/core/double_double.h"

namespace tristim::detail {

// Angles in degrees, as hues are given. Like lib/core/math.h: the same bits everywhere, and
// correctly rounded but for values within 1e-12 ulp of a tie. So multiples of 30, 45 and 90 degrees
// come out as a table would have them: sin 30 is 1/2, the sine and the cosine of 45 are equal.

struct SineCosine {
  double sine = 0, cosine = 0;
};
struct PreciseSineCosine {
  DoubleDouble sine, cosine;  // 100 bits
};

/// Of any angle, reduced by whole turns without error; NaN where it is not finite.
SineCosine sine_cosine_deg(double degrees) noexcept;
PreciseSineCosine precise_sine_cosine_deg(double degrees) noexcept;

/// The angle of the vector (x, y) in [0, 360); 0 for (0, 0), whatever the signs of the zeros; NaN
/// where either is. An angle that rounds to 360 is 0.
double angle_deg(double y, double x) noexcept;

/// sqrt(x^2 + y^2), correctly rounded in nearly every case, without overflow on the way.
double hypotenuse(double x, double y) noexcept;

}  // namespace tristim::detail
