#include "tristim/color/cct.h"

#include <cmath>
#include <limits>

#include "lib/color/planckian_locus.h"

namespace tristim {
namespace {

using detail::PlanckianLocus;
using detail::Uv;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kFarthest = 0.1;  // |Duv| beyond which a temperature says nothing

Uv uv_from_xy(Chromaticity c) noexcept {
  const double d = -2 * c.x + 12 * c.y + 3;
  return {4 * c.x / d, 6 * c.y / d};
}

Chromaticity xy_from_uv(Uv c) noexcept {
  const double d = 2 * c.u - 8 * c.v + 4;
  return {3 * c.u / d, 2 * c.v / d};
}

double length(Uv c) noexcept { return std::sqrt(c.u * c.u + c.v * c.v); }

}  // namespace

ColorTemperature color_temperature(Chromaticity c, double c2) noexcept {
  const Uv color = uv_from_xy(c);
  const auto place = PlanckianLocus::get().nearest(color);
  if (!place) return {kNaN, kNaN};
  const Uv offset{color.u - place->point.u, color.v - place->point.v};
  const double distance = length(offset);
  if (!(distance <= kFarthest)) return {kNaN, kNaN};
  const double side = place->tangent.u * offset.v - place->tangent.v * offset.u;
  // A radiator's colour depends on c2/T alone.
  return {1e6 / place->mired * (c2 / kC2), std::copysign(distance, side)};
}

Chromaticity chromaticity_of(ColorTemperature t, double c2) noexcept {
  const double mired = 1e6 / t.temperature_k * (c2 / kC2);
  if (!(mired >= 0 && mired <= PlanckianLocus::kLastMired)) return {kNaN, kNaN};
  const auto [at, point, tangent] = PlanckianLocus::get().at(mired);
  const double scale = t.duv / length(tangent);
  return xy_from_uv({point.u - scale * tangent.v, point.v + scale * tangent.u});
}

}  // namespace tristim
