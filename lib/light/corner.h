#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>

#include "lib/light/precise.h"

namespace tristim::detail {

/// A face as it is seen from one of its vertices, for the shares of NormalWeighting.
struct Corner {
  std::span<const Eigen::Vector3d> polygon;  // the face's vertices
  std::size_t at;                            // which of them
  const Eigen::Vector3d* plane;              // (a, b, c) of the face, where it is given
};

}  // namespace tristim::detail
