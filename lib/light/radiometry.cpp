#include "tristim/light/radiometry.h"

#include <cmath>
#include <limits>
#include <stdexcept>

#include "lib/core/trigonometry.h"
#include "lib/light/angle.h"
#include "lib/light/product.h"
#include "tristim/core/text.h"
#include "tristim/light/phong.h"

namespace tristim {
namespace {

using detail::product;
using detail::sum;
using Eigen::Vector3d;

template <typename Color>
Color reflected(const ReflectivitySplit& split, const Color& rho_d, const Color& ambient,
                const Vector3d& normal, std::span<const RadiantSourceOf<Color>> sources) noexcept {
  Color radiance = product(rho_d, ambient);
  for (const RadiantSourceOf<Color>& source : sources) {
    const double foreshortened = product(lambert(normal, source.to_light), source.domega_sr);
    const Color rho = sum(product(split.kd, rho_d), product(split.ks, source.rho_s));
    radiance = sum(radiance, product(product(foreshortened, source.radiance), rho));
  }
  return radiance;
}

double quotient(double a, double b) noexcept {
  if (a == 0) return 0;
  return b > 0 ? a / b : std::numeric_limits<double>::infinity();
}

}  // namespace

double cone_solid_angle_sr(double half_angle_deg) noexcept {
  // 1 - cos t = 2 sin^2(t/2), whose digits do not cancel for a narrow cone.
  const detail::DoubleDouble sine = detail::precise_sine_cosine_deg(half_angle_deg / 2).sine;
  return (4 * detail::kPi * sine * sine).hi;
}

double radiant_intensity(double flux_w, double solid_angle_sr) noexcept {
  return quotient(flux_w, solid_angle_sr);
}

double foreshortened_area(double area_m2, const Vector3d& normal,
                          const Vector3d& direction) noexcept {
  return product(area_m2, lambert(normal, direction));
}

double radiance(double intensity_w_sr, double area_m2, const Vector3d& normal,
                const Vector3d& direction) noexcept {
  return quotient(intensity_w_sr, foreshortened_area(area_m2, normal, direction));
}

double irradiance(double incident_radiance, const Vector3d& normal, const Vector3d& to_light,
                  double domega_sr) noexcept {
  return product(product(incident_radiance, lambert(normal, to_light)), domega_sr);
}

double lambert_reflectivity(double albedo) noexcept {
  return (detail::DoubleDouble(albedo) / detail::kPi).hi;
}

void check_split(const ReflectivitySplit& split) {
  constexpr double kTolerance = 1e-6;
  const bool good =
      split.kd >= 0 && split.ks >= 0 && std::fabs(split.kd + split.ks - 1) <= kTolerance;
  if (good) return;
  throw std::invalid_argument("kd " + shortest(split.kd) + " and ks " + shortest(split.ks) +
                              " are not 0..1 and together 1");
}

double reflectivity(const ReflectivitySplit& split, double rho_d, double rho_s) noexcept {
  return product(split.kd, rho_d) + product(split.ks, rho_s);
}

double reflected_radiance(const ReflectivitySplit& split, double rho_d, double ambient,
                          const Vector3d& normal, std::span<const RadiantSource> sources) noexcept {
  return reflected(split, rho_d, ambient, normal, sources);
}

Rgb reflected_radiance(const ReflectivitySplit& split, const Rgb& rho_d, const Rgb& ambient,
                       const Vector3d& normal,
                       std::span<const RadiantSourceOf<Rgb>> sources) noexcept {
  return reflected(split, rho_d, ambient, normal, sources);
}

SpectralColor reflected_radiance(const ReflectivitySplit& split, const SpectralColor& rho_d,
                                 const SpectralColor& ambient, const Vector3d& normal,
                                 std::span<const RadiantSourceOf<SpectralColor>> sources) noexcept {
  return reflected(split, rho_d, ambient, normal, sources);
}

}  // namespace tristim
