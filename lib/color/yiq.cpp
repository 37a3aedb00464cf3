#include "tristim/color/yiq.h"

#include "lib/core/double_double.h"

namespace tristim {
namespace {

using Dd = detail::DoubleDouble;

Dd product(double a, double b) noexcept { return detail::two_product(a, b); }

// What I and Q say about R - G and B - G.
struct Differences {
  Dd red_i, red_q, blue_i, blue_q;
};

Differences differences_from_iq(const YiqSystem& s) noexcept {
  const Dd determinant = detail::subtract(product(s.i_r, s.q_b), product(s.i_b, s.q_r));
  const auto over = [&](double entry) { return detail::divide({entry, 0}, determinant); };
  return {over(s.q_b), over(-s.i_b), over(-s.q_r), over(s.i_r)};
}

// The rows R, G, B of the inverse, but for their first entry, 1: G = Y - y_r (R-G) - y_b (B-G).
struct Inverse {
  double red_i, red_q, green_i, green_q, blue_i, blue_q;
};

Inverse inverse(const YiqSystem& s) noexcept {
  const Differences d = differences_from_iq(s);
  const auto green = [&](Dd red, Dd blue) {
    return detail::negate(detail::add(detail::multiply(red, s.y_r), detail::multiply(blue, s.y_b)));
  };
  const Dd green_i = green(d.red_i, d.blue_i);
  const Dd green_q = green(d.red_q, d.blue_q);
  return {detail::add(green_i, d.red_i).value(),
          detail::add(green_q, d.red_q).value(),
          green_i.value(),
          green_q.value(),
          detail::add(green_i, d.blue_i).value(),
          detail::add(green_q, d.blue_q).value()};
}

}  // namespace

Yiq rgb_to_yiq(EncodedRgb rgb, const YiqSystem& system) noexcept {
  const double red = rgb.r - rgb.g;
  const double blue = rgb.b - rgb.g;
  return {rgb.g + (system.y_r * red + system.y_b * blue), system.i_r * red + system.i_b * blue,
          system.q_r * red + system.q_b * blue};
}

EncodedRgb yiq_to_rgb(Yiq yiq, const YiqSystem& system) noexcept {
  const Inverse m = inverse(system);
  return {yiq.y + (m.red_i * yiq.i + m.red_q * yiq.q),
          yiq.y + (m.green_i * yiq.i + m.green_q * yiq.q),
          yiq.y + (m.blue_i * yiq.i + m.blue_q * yiq.q)};
}

Eigen::Matrix3d yiq_from_rgb(const YiqSystem& s) {
  const auto green = [](double total, double red, double blue) {
    return detail::add(detail::two_sum(total, -red), {-blue, 0}).value();
  };
  Eigen::Matrix3d m;
  m << s.y_r, green(1, s.y_r, s.y_b), s.y_b,  //
      s.i_r, green(0, s.i_r, s.i_b), s.i_b,   //
      s.q_r, green(0, s.q_r, s.q_b), s.q_b;
  return m;
}

Eigen::Matrix3d rgb_from_yiq(const YiqSystem& system) {
  const Inverse inverted = inverse(system);
  Eigen::Matrix3d m;
  m << 1, inverted.red_i, inverted.red_q,     //
      1, inverted.green_i, inverted.green_q,  //
      1, inverted.blue_i, inverted.blue_q;
  return m;
}

}  // namespace tristim
