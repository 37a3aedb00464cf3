#pragma once

#include "lib/core/trigonometry.h"

namespace tristim::detail {

inline double sin_deg(double degrees) noexcept { return sine_cosine_deg(degrees).sine; }
inline double cos_deg(double degrees) noexcept { return sine_cosine_deg(degrees).cosine; }

}  // namespace tristim::detail
