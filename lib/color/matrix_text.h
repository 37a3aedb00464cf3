#pragma once

#include <Eigen/Core>
#include <string>

#include "tristim/color/xyz.h"

namespace tristim::detail {

/// The rows of a matrix, "1 0 0 / 0 1 0 / 0 0 1", in the shortest digits that read back.
std::string matrix_text(const Eigen::Matrix3d& matrix);

/// The name of a white, or its chromaticity: "d65", "0.31 0.33".
std::string white_text(Chromaticity white);

}  // namespace tristim::detail
