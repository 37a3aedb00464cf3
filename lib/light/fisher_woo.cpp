#include "tristim/light/fisher_woo.h"

#include <cmath>
#include <limits>

#include "lib/core/math.h"
#include "lib/light/degrees.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::cos_deg;
using detail::sin_deg;
using Eigen::Vector3d;

double square(double x) noexcept { return x * x; }

double lobe(double cosine, double exponent) noexcept {
  return cosine > 0 ? detail::pow(cosine, exponent) : 0;
}

// ln(1 - x) for 0 <= x < 1 without the digits that 1 - x loses: the quotient corrects for its
// rounding.
double log_one_minus(double x) noexcept {
  const double y = 1 - x;
  return y == 1 ? -x : detail::log(y) * (x / (1 - y));
}

}  // namespace

HighlightFrame highlight_frame(double theta_deg, double phi_deg, double le_deg) noexcept {
  const detail::SineCosine theta = detail::sine_cosine_deg(theta_deg);
  const detail::SineCosine phi = detail::sine_cosine_deg(phi_deg);
  const detail::SineCosine le = detail::sine_cosine_deg(le_deg);
  return {{-le.sine, 0, le.cosine},
          {0, 0, 1},
          {-theta.sine * phi.cosine, theta.cosine, theta.sine * phi.sine}};
}

double coplanar_r_dot_e(double n_dot_h) noexcept { return 2 * n_dot_h * n_dot_h - 1; }

double r_dot_e(double nu_deg, double beta_deg, double theta_deg) noexcept {
  return cos_deg(2 * nu_deg) + 2 * square(sin_deg(beta_deg) * cos_deg(theta_deg));
}

double r_dot_e_from_half(const Vector3d& normal, const Vector3d& to_light,
                         const Vector3d& to_eye) noexcept {
  const Vector3d half = half_vector(to_light, to_eye);
  return coplanar_r_dot_e(dot(normal, half)) + 2 * square(triple_product(to_light, half, normal));
}

double r_dot_e_from_eye(const Vector3d& normal, const Vector3d& to_light,
                        const Vector3d& to_eye) noexcept {
  const double coplanar = coplanar_r_dot_e(dot(normal, half_vector(to_light, to_eye)));
  const double aside = square(triple_product(to_light, to_eye, normal));
  return aside == 0 ? coplanar : coplanar + aside / (1 + dot(to_light, to_eye));
}

double triple_product(const Vector3d& a, const Vector3d& b, const Vector3d& c) noexcept {
  return (a.y() * b.z() - a.z() * b.y()) * c.x() + (a.z() * b.x() - a.x() * b.z()) * c.y() +
         (a.x() * b.y() - a.y() * b.x()) * c.z();
}

double gram_determinant(const Vector3d& a, const Vector3d& b, const Vector3d& c) noexcept {
  const double ab = dot(a, b);
  const double bc = dot(b, c);
  const double ca = dot(c, a);
  return dot(a, a) * dot(b, b) * dot(c, c) + 2 * ab * bc * ca - dot(a, a) * bc * bc -
         dot(b, b) * ca * ca - dot(c, c) * ab * ab;
}

double unit_gram_identity(const Vector3d& to_light, const Vector3d& to_eye,
                          const Vector3d& normal) noexcept {
  const double le = dot(to_light, to_eye);
  const double en = dot(to_eye, normal);
  const double nl = dot(normal, to_light);
  return le * le + en * en + nl * nl - 2 * le * en * nl - 1 +
         square(triple_product(to_light, to_eye, normal));
}

double exponent_factor(double rho_deg) noexcept {
  if (std::fabs(rho_deg) < 1e-7) return 4;  // f = 4 + rho^2/2 + ...
  if (cos_deg(rho_deg) <= 0) return std::numeric_limits<double>::infinity();
  // log cos x = log(1 - sin^2 x) / 2: near 0 the cosine alone has lost x.
  const double log_cos_nu = log_one_minus(square(sin_deg(rho_deg / 2)));
  const double log_cos_rho = std::fabs(rho_deg) < 45 ? log_one_minus(square(sin_deg(rho_deg)))
                                                     : 2 * detail::log(cos_deg(rho_deg));
  return log_cos_rho / log_cos_nu;
}

double coplanar_pixel_error(double rho_deg, double r) noexcept {
  return 255 * (lobe(cos_deg(rho_deg / 2), 4 * r) - lobe(cos_deg(rho_deg), r));
}

double pixel_error(const HighlightFrame& frame, double r, double f) noexcept {
  const auto& [to_light, to_eye, normal] = frame;
  const double n_dot_h = dot(normal, half_vector(to_light, to_eye));
  return 255 * (lobe(dot(reflect(to_light, normal), to_eye), r) - lobe(n_dot_h, f * r));
}

double zero_error_cos_theta(double n_dot_h, double f, double le_deg) noexcept {
  const double aside = lobe(n_dot_h, f) - coplanar_r_dot_e(n_dot_h);  // 2 sin^2 beta cos^2 theta
  const double cos_theta = std::sqrt(aside / 2) / sin_deg(le_deg / 2);
  return square(cos_theta) <= 1 - n_dot_h * n_dot_h ? cos_theta : std::nan("");
}

}  // namespace tristim
