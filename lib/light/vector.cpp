#include "tristim/light/vector.h"

#include "lib/core/trigonometry.h"
#include "lib/light/angle.h"
#include "lib/light/precise.h"

namespace tristim {

using detail::precise;
using Eigen::Vector3d;

Vector3d reflect(const Vector3d& to_light, const Vector3d& normal) noexcept {
  return rounded(detail::reflect(precise(to_light), precise(normal)));
}

Vector3d reflect_z(const Vector3d& normal) noexcept {
  const detail::PreciseVector n = precise(normal);
  return {(2 * n.z * n.x).hi, (2 * n.z * n.y).hi, (2 * n.z * n.z - 1).hi};
}

Vector3d reflect_by_turning(const Vector3d& to_light, const Vector3d& normal) noexcept {
  // The half turn about the axis between L and +z swaps the two; any axis across serves for -z.
  const Vector3d between = to_light + Vector3d(0, 0, 1);
  const Vector3d axis = dot(between, between) > 1e-30 ? normalize(between) : Vector3d(1, 0, 0);
  return reflect(reflect_z(reflect(normal, axis)), axis);
}

double r_dot_v(const Vector3d& normal, const Vector3d& to_light, const Vector3d& to_eye) noexcept {
  return detail::r_dot_v(precise(normal), precise(to_light), precise(to_eye)).hi;
}

Vector3d half_vector(const Vector3d& to_light, const Vector3d& to_eye) noexcept {
  return rounded(detail::half_vector(precise(to_light), precise(to_eye)));
}

double n_dot_h(const Vector3d& normal, const Vector3d& to_light, const Vector3d& to_eye) noexcept {
  return dot(precise(normal), detail::half_vector(precise(to_light), precise(to_eye))).hi;
}

double cosine_deg(double angle_deg) noexcept { return detail::sine_cosine_deg(angle_deg).cosine; }

double angle_between_deg(const Vector3d& a, const Vector3d& b) noexcept {
  return (detail::angle_between(normalize(precise(a)), normalize(precise(b))) *
          detail::kDegreesPerRadian)
      .hi;
}

HighlightAngles highlight_angles(const Vector3d& normal, const Vector3d& to_light,
                                 const Vector3d& to_eye) noexcept {
  const Vector3d half = half_vector(to_light, to_eye);
  return {.alpha_deg = angle_between_deg(to_light, normal),
          .beta_deg = angle_between_deg(to_light, half),
          .rho_deg = angle_between_deg(reflect(to_light, normal), to_eye),
          .nu_deg = angle_between_deg(normal, half)};
}

}  // namespace tristim
