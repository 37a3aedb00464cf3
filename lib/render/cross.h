#pragma once

#include <Eigen/Core>

namespace tristim::detail {

/// a x b; Eigen's own is in a large header.
inline Eigen::Vector3d cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) noexcept {
  return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
          a.x() * b.y() - a.y() * b.x()};
}

}  // namespace tristim::detail
