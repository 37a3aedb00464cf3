#include "lib/color/planckian_locus.h"

#include <algorithm>
#include <cmath>

#include "lib/color/planck_sums.h"
#include "tristim/color/planckian.h"

namespace tristim::detail {
namespace {

// Nodes stand at 3 i + i^2/16 mired: dense where the locus bends, and its colours are told apart.
double node_mired(std::size_t i) noexcept {
  const auto n = static_cast<double>(i);
  return n * (3 + n / 16);
}

// The piece of a place in [0, kLastMired].
std::size_t piece_of(double mired, std::size_t pieces) noexcept {
  const double n = 4 * (std::sqrt(36 + mired) - 6);  // node_mired's inverse
  const auto i = std::min(static_cast<std::size_t>(n), pieces - 1);
  return mired < node_mired(i) ? i - 1 : i;  // n may be rounded up to an integer
}

struct Jet {
  double value, first, second;
};

// numerator/denominator with derivatives.
Jet quotient(const Jet& n, const Jet& d) noexcept {
  Jet q{};
  q.value = n.value / d.value;
  q.first = (n.first - q.value * d.first) / d.value;
  q.second = (n.second - 2 * q.first * d.first - q.value * d.second) / d.value;
  return q;
}

struct JetUv {
  Jet u, v;
};

JetUv exact_locus(double mired) noexcept {
  const PlanckSums s = planck_sums(mired, kC2);
  const auto combined = [&](double x, double y, double z) {
    const auto of = [=](const Xyz& c) { return x * c.x + y * c.y + z * c.z; };
    return Jet{of(s.value), of(s.first), of(s.second)};
  };
  const Jet d = combined(1, 15, 3);
  return {quotient(combined(4, 0, 0), d), quotient(combined(0, 6, 0), d)};
}

// The polynomial of fifth degree on [0, 1], h wide, between two jets.
std::array<double, 6> hermite(const Jet& a, const Jet& b, double h) noexcept {
  const double c1 = h * a.first;
  const double c2 = h * h * a.second / 2;
  const double d = b.value - a.value - c1 - c2;
  const double e = h * b.first - c1 - 2 * c2;
  const double f = h * h * b.second / 2 - c2;
  return {a.value, c1, c2, 10 * d - 4 * e + f, -15 * d + 7 * e - 2 * f, 6 * d - 3 * e + f};
}

Jet evaluate(const std::array<double, 6>& c, double t) noexcept {
  return {c[0] + t * (c[1] + t * (c[2] + t * (c[3] + t * (c[4] + t * c[5])))),
          c[1] + t * (2 * c[2] + t * (3 * c[3] + t * (4 * c[4] + t * 5 * c[5]))),
          2 * c[2] + t * (6 * c[3] + t * (12 * c[4] + t * 20 * c[5]))};
}

double squared_distance(Uv a, Uv b) noexcept {
  return (a.u - b.u) * (a.u - b.u) + (a.v - b.v) * (a.v - b.v);
}

}  // namespace

const PlanckianLocus& PlanckianLocus::get() {
  static const PlanckianLocus locus;
  return locus;
}

PlanckianLocus::PlanckianLocus() {
  JetUv left = exact_locus(0);
  for (std::size_t i = 0; i <= kPieces; ++i) {
    points_[i] = {left.u.value, left.v.value};
    tangents_[i] = {left.u.first, left.v.first};
    if (i == kPieces) break;
    const JetUv right = exact_locus(node_mired(i + 1));
    const double h = node_mired(i + 1) - node_mired(i);
    pieces_[i] = {hermite(left.u, right.u, h), hermite(left.v, right.v, h)};
    left = right;
  }
}

PlanckianLocus::Place PlanckianLocus::at(std::size_t piece, double t) const noexcept {
  const double h = node_mired(piece + 1) - node_mired(piece);
  const Jet u = evaluate(pieces_[piece].u, t);
  const Jet v = evaluate(pieces_[piece].v, t);
  return {node_mired(piece) + t * h, {u.value, v.value}, {u.first / h, v.first / h}};
}

PlanckianLocus::Place PlanckianLocus::at(double mired) const noexcept {
  const std::size_t piece = piece_of(mired, kPieces);
  const double h = node_mired(piece + 1) - node_mired(piece);
  return at(piece, (mired - node_mired(piece)) / h);
}

// How the distance to a colour changes at a node: below 0 where it falls.
double PlanckianLocus::slope(std::size_t node, Uv color) const noexcept {
  return (points_[node].u - color.u) * tangents_[node].u +
         (points_[node].v - color.v) * tangents_[node].v;
}

// The minimum in a piece at whose ends the distance falls and rises: Newton's method for the root
// of (P - color) P', halving where a step would leave the bracket.
PlanckianLocus::Place PlanckianLocus::minimum(std::size_t piece, Uv color) const noexcept {
  double low = 0;
  double high = 1;
  double t = 0.5;
  for (int i = 0; i < 60; ++i) {
    const Jet u = evaluate(pieces_[piece].u, t);
    const Jet v = evaluate(pieces_[piece].v, t);
    const double f = (u.value - color.u) * u.first + (v.value - color.v) * v.first;
    const double df = u.first * u.first + v.first * v.first + (u.value - color.u) * u.second +
                      (v.value - color.v) * v.second;
    (f < 0 ? low : high) = t;
    double next = t - f / df;
    if (!(next >= low && next <= high)) next = (low + high) / 2;
    const bool settled = std::fabs(next - t) < 1e-9;  // each step squares the error
    t = next;
    if (settled) break;
  }
  return at(piece, t);
}

std::optional<PlanckianLocus::Place> PlanckianLocus::nearest(Uv color) const noexcept {
  constexpr std::size_t kStride = 10;  // of the first look, over pieces that bend by a few degrees
  static_assert(kPieces % kStride == 0);
  Place best = at(0, 0);
  double least = squared_distance(points_[0], color);
  for (std::size_t low = 0; low < kPieces; low += kStride) {
    if (!(slope(low, color) < 0) || slope(low + kStride, color) < 0) continue;
    std::size_t piece = low;
    while (piece + 1 < low + kStride && slope(piece + 1, color) < 0) ++piece;
    const Place place = minimum(piece, color);
    const double distance = squared_distance(place.point, color);
    if (!(distance < least)) continue;
    best = place;
    least = distance;
  }
  if (squared_distance(points_[kPieces], color) < least) return std::nullopt;
  return best;
}

}  // namespace tristim::detail
