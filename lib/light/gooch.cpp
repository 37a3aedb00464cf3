#include "tristim/light/gooch.h"

#include "lib/light/precise.h"
#include "lib/light/product.h"

namespace tristim {

using detail::precise;
using Eigen::Vector3d;

double gooch_warmth(const Vector3d& normal, const Vector3d& to_light) noexcept {
  return ((1 + dot(precise(normal), precise(to_light))) / 2).hi;
}

Rgb gooch(const Vector3d& normal, const Vector3d& to_light, const Rgb& warm,
          const Rgb& cool) noexcept {
  const double warmth = gooch_warmth(normal, to_light);
  const double coolness = gooch_warmth(-normal, to_light);  // 1 - kw, with all its digits
  return detail::sum(detail::product(warmth, warm), detail::product(coolness, cool));
}

bool is_silhouette(const Vector3d& to_eye, const Vector3d& normal0,
                   const Vector3d& normal1) noexcept {
  const double facing0 = dot(precise(to_eye), precise(normal0)).hi;
  const double facing1 = dot(precise(to_eye), precise(normal1)).hi;
  return (facing0 <= 0 && facing1 >= 0) || (facing0 >= 0 && facing1 <= 0);
}

bool is_crease(const Vector3d& normal0, const Vector3d& normal1, double threshold) noexcept {
  return (dot(precise(normal0), precise(normal1)) - threshold).hi <= 0;
}

}  // namespace tristim
