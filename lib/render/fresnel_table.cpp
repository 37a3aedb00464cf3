#include "lib/render/fresnel_table.h"

#include <algorithm>

namespace tristim::detail {

Rgb FresnelTable::at(double cosine) const noexcept {
  const double place = std::clamp(cosine, 0.0, 1.0) * kSteps;
  const auto i = std::min(static_cast<std::size_t>(place), static_cast<std::size_t>(kSteps - 1));
  const double t = place - static_cast<double>(i);
  // Lagrange's weights of the places -1, 0, 1, 2.
  const double a = t - 1;
  const double b = t - 2;
  const double c = t + 1;
  const std::array<double, 4> w{-t * a * b / 6, c * a * b / 2, -c * t * b / 2, c * t * a / 6};
  Rgb sum;
  for (std::size_t k = 0; k < 4; ++k) {
    const Rgb& at = places_[i + k];
    sum = {sum.r + w[k] * at.r, sum.g + w[k] * at.g, sum.b + w[k] * at.b};
  }
  return sum;
}

}  // namespace tristim::detail
