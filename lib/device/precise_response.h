#pragma once

#include "lib/core/double_double.h"
#include "tristim/device/response.h"

namespace tristim::detail {

/// See code_of_light: to about 80 bits, of a table to a double's 53.
DoubleDouble precise_code(const Response& response, DoubleDouble light, double code_max) noexcept;

/// The code whose light is `light`, rounded half up once.
int nearest_code(const Response& response, DoubleDouble light, int code_max) noexcept;

}  // namespace tristim::detail
