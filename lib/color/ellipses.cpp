#include "tristim/color/ellipses.h"

#include "lib/core/trigonometry.h"

namespace tristim {
namespace {

constexpr DiscriminationEllipse kEllipses[] = {
#include "luts/macadam_ellipses.csv"
};

}  // namespace

std::span<const DiscriminationEllipse> macadam_ellipses() noexcept { return kEllipses; }

std::vector<Chromaticity> ellipse_outline(const DiscriminationEllipse& ellipse, double magnified,
                                          int corners) {
  const double a = magnified * ellipse.semi_major_1e3 / 1000;
  const double b = magnified * ellipse.semi_minor_1e3 / 1000;
  const auto turn = detail::sine_cosine_deg(ellipse.angle_deg);
  std::vector<Chromaticity> outline;
  for (int i = 0; i < corners; ++i) {
    const auto at = detail::sine_cosine_deg(360.0 * i / corners);
    const double along = a * at.cosine;
    const double across = b * at.sine;
    outline.push_back({ellipse.centre.x + along * turn.cosine - across * turn.sine,
                       ellipse.centre.y + along * turn.sine + across * turn.cosine});
  }
  return outline;
}

}  // namespace tristim
