#pragma once

#include <vector>

namespace tristim::detail {

/// The points from which on the upper of two levels is nearer in light: the floats behind half way.
std::vector<float> half_way_points(const std::vector<float>& light);

}  // namespace tristim::detail
