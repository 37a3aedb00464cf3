#pragma once

#include "tristim/color/lab.h"

namespace tristim {

/// CIEDE2000 with kL = kC = kH = 1 [Sharma05 eqs 2-22]; 1 is about a just noticeable difference.
/// Symmetric.
double ciede2000(Lab first, Lab second) noexcept;

}  // namespace tristim
