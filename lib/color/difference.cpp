#include "tristim/color/difference.h"

#include <cmath>
#include <numbers>

namespace tristim {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

double hue_deg(double a, double b) noexcept {
  if (a == 0 && b == 0) return 0;
  const double h = std::atan2(b, a) / kRadians;
  return h < 0 ? h + 360 : h;
}

double power7(double x) noexcept {
  const double x2 = x * x;
  const double x4 = x2 * x2;
  return x4 * x2 * x;
}

// C^7/(C^7 + 25^7), under a root.
double chroma_term(double c) noexcept {
  const double c7 = power7(c);
  return std::sqrt(c7 / (c7 + power7(25)));
}

struct Hues {
  double difference_deg, mean_deg;
};

// Equations 10 and 14. A difference of exactly 180 degrees takes the first branch, whatever the
// rounding of atan2 made of it: opposite colours are told by their vectors.
Hues hues(double a1, double b1, double a2, double b2) noexcept {
  const double h1 = hue_deg(a1, b1);
  const double h2 = hue_deg(a2, b2);
  const bool grey = (a1 == 0 && b1 == 0) || (a2 == 0 && b2 == 0);
  if (grey) return {0, h1 + h2};
  const bool opposite = a1 * b2 - a2 * b1 == 0 && a1 * a2 + b1 * b2 < 0;
  if (opposite || std::fabs(h2 - h1) <= 180) return {h2 - h1, (h1 + h2) / 2};
  const double turn = h2 > h1 ? -360 : 360;
  return {h2 - h1 + turn, h1 + h2 < 360 ? (h1 + h2 + 360) / 2 : (h1 + h2 - 360) / 2};
}

double sind(double deg) noexcept { return std::sin(deg * kRadians); }
double cosd(double deg) noexcept { return std::cos(deg * kRadians); }

}  // namespace

double ciede2000(Lab first, Lab second) noexcept {
  const double mean_c = (std::hypot(first.a, first.b) + std::hypot(second.a, second.b)) / 2;
  const double g = 0.5 * (1 - chroma_term(mean_c));
  const double a1 = (1 + g) * first.a;
  const double a2 = (1 + g) * second.a;
  const double c1 = std::hypot(a1, first.b);
  const double c2 = std::hypot(a2, second.b);
  const Hues hue = hues(a1, first.b, a2, second.b);

  const double dl = second.l - first.l;
  const double dc = c2 - c1;
  const double dh = 2 * std::sqrt(c1 * c2) * sind(hue.difference_deg / 2);

  const double l50 = (first.l + second.l) / 2 - 50;
  const double c = (c1 + c2) / 2;
  const double t = 1 - 0.17 * cosd(hue.mean_deg - 30) + 0.24 * cosd(2 * hue.mean_deg) +
                   0.32 * cosd(3 * hue.mean_deg + 6) - 0.20 * cosd(4 * hue.mean_deg - 63);
  const double sl = 1 + 0.015 * l50 * l50 / std::sqrt(20 + l50 * l50);
  const double sc = 1 + 0.045 * c;
  const double sh = 1 + 0.015 * c * t;
  const double bump = (hue.mean_deg - 275) / 25;
  const double rt = -2 * chroma_term(c) * sind(60 * std::exp(-bump * bump));

  const double l = dl / sl;
  const double m = dc / sc;
  const double h = dh / sh;
  return std::sqrt(l * l + m * m + h * h + rt * m * h);
}

}  // namespace tristim
