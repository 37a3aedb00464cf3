#include "tristim/color/difference.h"

#include <cmath>
#include <numbers>

#include "lib/core/math.h"

namespace tristim {
namespace {

// a* and b* with their chroma.
struct Chroma {
  double a = 0, b = 0, c = 0;
};

// Two colours in the plane of a* and b*; their differences before a* was stretched and rounded, on
// which tiny distances depend.
struct Pair {
  Chroma first, second;
  double da = 0, db = 0;
};

Chroma chroma(double a, double b) noexcept { return {a, b, std::sqrt(a * a + b * b)}; }

Pair pair(Lab first, Lab second, double stretch = 1) noexcept {
  return {chroma(stretch * first.a, first.b), chroma(stretch * second.a, second.b),
          stretch * (second.a - first.a), second.b - first.b};
}

// C2 - C1 without the cancellation of nearly equal chromas.
double chroma_difference(const Pair& p) noexcept {
  const double sum = p.first.c + p.second.c;
  if (sum == 0) return 0;
  return (p.da * (p.first.a + p.second.a) + p.db * (p.first.b + p.second.b)) / sum;
}

// Whether the way of at most 180 degrees from the first hue to the second is clockwise. Between
// opposite hues it is so from the one that is not in [0, 180).
bool turns_back(const Chroma& first, const Chroma& second) noexcept {
  const double cross = first.a * second.b - second.a * first.b;
  if (cross != 0) return cross < 0;
  return first.b < 0 || (first.b == 0 && first.a < 0);
}

// 2 sqrt(C1 C2) sin(dh/2) from the vectors [Seve91], so that no angle's rounding comes in.
double hue_difference(const Pair& p) noexcept {
  const double product = p.first.c * p.second.c;
  if (product == 0) return 0;
  const double dot = p.first.a * p.second.a + p.first.b * p.second.b;
  if (dot < 0) {
    const double size = std::sqrt(2 * (product - dot));
    return turns_back(p.first, p.second) ? -size : size;
  }
  const double cross = (p.first.a + p.second.a) / 2 * p.db - (p.first.b + p.second.b) / 2 * p.da;
  return cross / std::sqrt((product + dot) / 2);
}

struct Weights {
  double lightness, chroma, hue;
  double rotation = 0;
};

double weighted(double dl, const Pair& p, const Weights& weights,
                const DifferenceFactors& factors) noexcept {
  const double l = dl / (factors.lightness * weights.lightness);
  const double c = chroma_difference(p) / (factors.chroma * weights.chroma);
  const double h = hue_difference(p) / (factors.hue * weights.hue);
  return std::sqrt(l * l + c * c + h * h + weights.rotation * c * h);
}

double distance(double x, double y, double z) noexcept { return std::sqrt(x * x + y * y + z * z); }

struct Direction {
  double cosine = 1, sine = 0;
};

Direction unit(double a, double b) noexcept {
  const double size = std::sqrt(a * a + b * b);
  return {a / size, b / size};
}

// The mean hue [Sharma05 eq 14] of two that are not grey: the bisector, from the difference of the
// unit vectors where their sum cancels.
Direction mean_hue(const Chroma& first, const Chroma& second) noexcept {
  const Direction u{first.a / first.c, first.b / first.c};
  const Direction v{second.a / second.c, second.b / second.c};
  if (u.cosine * v.cosine + u.sine * v.sine >= 0) {
    return unit(u.cosine + v.cosine, u.sine + v.sine);
  }
  const double a = v.sine - u.sine;
  const double b = u.cosine - v.cosine;
  return turns_back(first, second) ? unit(-a, -b) : unit(a, b);
}

constexpr Direction operator*(Direction u, Direction v) noexcept {  // adds the angles
  return {u.cosine * v.cosine - u.sine * v.sine, u.cosine * v.sine + u.sine * v.cosine};
}

constexpr double kRadians = std::numbers::pi / 180;
constexpr Direction kMinus275{0.087155742747658173, 0.99619469809174553};
constexpr Direction kMinus30{0.86602540378443865, -0.5};
constexpr Direction kPlus6{0.99452189536827333, 0.10452846326765347};
constexpr Direction kMinus63{0.45399049973954675, -0.89100652418836786};

// [Sharma05 eq 15]
double hue_weight(Direction h) noexcept {
  const Direction h2 = h * h;
  return 1 - 0.17 * (h * kMinus30).cosine + 0.24 * h2.cosine + 0.32 * (h2 * h * kPlus6).cosine -
         0.20 * (h2 * h2 * kMinus63).cosine;
}

// sqrt(C^7/(C^7 + 25^7))
double chroma_term(double c) noexcept {
  const double x = 25 / c;
  const double x2 = x * x;
  return 1 / std::sqrt(1 + x2 * x2 * x2 * x);
}

// The angle of a unit vector in (-180, 180) degrees, within 1e-13; halved until its series is
// short.
double angle_deg(Direction h) noexcept {
  double t = h.sine / (1 + h.cosine);  // the tangent of a half, then of a sixteenth
  for (int i = 0; i < 3; ++i) t /= 1 + std::sqrt(1 + t * t);
  const double t2 = t * t;
  double series = 0;
  for (int n = 21; n >= 1; n -= 2) series = 1.0 / n - t2 * series;
  return 16 * t * series / kRadians;
}

// sin x of [0, pi/3].
double sine(double x) noexcept {
  double series = 1;
  for (int n = 20; n >= 2; n -= 2) series = 1 - x * x / (n * (n + 1)) * series;
  return x * series;
}

// RT of [Sharma05 eqs 17, 18, 22]: blues are rotated.
double rotation(double mean_chroma, Direction hue) noexcept {
  // The bump's far ends are below 2^-60. It does not go round: beyond 360 degrees it ends.
  if (hue.sine >= 0 && hue.cosine >= 0) return 0;
  const double bump = angle_deg(hue * kMinus275) / 25;
  if (!(std::fabs(bump) < 6.5)) return 0;  // so at 95 degrees, where there is no angle
  return -2 * chroma_term(mean_chroma) * sine(60 * kRadians * detail::exp(-bump * bump));
}

constexpr Direction kPlus168{-0.97814760073380564, 0.20791169081775934};
constexpr Direction kPlus35{0.81915204428899179, 0.57357643635104609};
constexpr Direction k164{-0.96126169593831886, 0.27563735581699916};
constexpr Direction k345{0.96592582628906829, -0.25881904510252076};

// T of [Clarke84]: one formula for hues of 164 to 345 degrees, another for the rest, which is less
// than half a turn.
double cmc_hue_weight(Direction h) noexcept {
  const bool rest = k345.cosine * h.sine - k345.sine * h.cosine > 0 &&
                    h.cosine * k164.sine - h.sine * k164.cosine > 0;
  return rest ? 0.36 + std::fabs(0.4 * (h * kPlus35).cosine)
              : 0.56 + std::fabs(0.2 * (h * kPlus168).cosine);
}

}  // namespace

double cie76(Lab first, Lab second) noexcept {
  return distance(second.l - first.l, second.a - first.a, second.b - first.b);
}

double cie94(Lab reference, Lab sample, Cie94Weights weights, DifferenceFactors factors) noexcept {
  const Pair p = pair(reference, sample);
  return weighted(sample.l - reference.l, p,
                  {1, 1 + weights.chroma * p.first.c, 1 + weights.hue * p.first.c}, factors);
}

double cmc(Lab reference, Lab sample, DifferenceFactors factors) noexcept {
  const Pair p = pair(reference, sample);
  const double l = reference.l;
  const double c = p.first.c;
  const double sl = l < 16 ? 0.511 : 0.040975 * l / (1 + 0.01765 * l);
  const double sc = 0.0638 * c / (1 + 0.0131 * c) + 0.638;
  const double f = c * c / std::sqrt(c * c * c * c + 1900);
  const double t = c == 0 ? 0 : cmc_hue_weight(unit(p.first.a, p.first.b));
  return weighted(sample.l - l, p, {sl, sc, sc * (f * t + 1 - f)}, factors);
}

double ciede2000(Lab first, Lab second, DifferenceFactors factors) noexcept {
  const double c_ab = (chroma(first.a, first.b).c + chroma(second.a, second.b).c) / 2;
  const Pair p = pair(first, second, 1 + 0.5 * (1 - chroma_term(c_ab)));
  const double l50 = (first.l + second.l) / 2 - 50;
  const double c = (p.first.c + p.second.c) / 2;
  const bool grey = p.first.c == 0 || p.second.c == 0;  // without a hue to differ
  const Direction h = grey ? Direction{} : mean_hue(p.first, p.second);
  return weighted(second.l - first.l, p,
                  {1 + 0.015 * l50 * l50 / std::sqrt(20 + l50 * l50), 1 + 0.045 * c,
                   1 + 0.015 * c * hue_weight(h), grey ? 0 : rotation(c, h)},
                  factors);
}

double delta_e_ok(Oklab first, Oklab second) noexcept {
  return distance(second.l - first.l, second.a - first.a, second.b - first.b);
}

}  // namespace tristim
