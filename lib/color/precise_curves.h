#pragma once

#include "lib/core/double_double.h"

namespace tristim::detail {

// Curves of tristim/color/transfer.h with all the digits that pow_precise has, for results of which
// an integer is made. Light and codes in [0, 1].

DoubleDouble srgb_encode_precise(DoubleDouble linear) noexcept;
DoubleDouble srgb_decode_precise(DoubleDouble encoded) noexcept;
DoubleDouble pq_encode_precise(DoubleDouble linear) noexcept;
DoubleDouble pq_decode_precise(DoubleDouble encoded) noexcept;

}  // namespace tristim::detail
