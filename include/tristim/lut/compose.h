#pragma once

#include <optional>
#include <span>

#include "tristim/lut/lut.h"

namespace tristim {

/// Curves at equal steps as curves through those points, which are rounded to float.
LutPoints points_of(const Lut1D& curves);

/// `second` of what `first` gives, as one: its points are those of the first and where the first
/// passes those of the second, rounded to float. Nothing where they are more than kMostCurveSize.
std::optional<LutPoints> compose(const LutPoints& first, const LutPoints& second);

/// One LUT after the other. Matrices that follow one another become one, as do curves; the rest
/// stays as it is. Throws std::invalid_argument as check() does.
Lut compose(std::span<const Lut> luts);

}  // namespace tristim
