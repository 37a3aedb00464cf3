#include "tristim/device/monotone.h"

#include <algorithm>
#include <cstddef>

namespace tristim {
namespace {

struct Points {
  std::span<const double> x, y;

  double width(std::size_t i) const noexcept { return x[i + 1] - x[i]; }
  double chord(std::size_t i) const noexcept { return (y[i + 1] - y[i]) / width(i); }
};

// At an end: the slope of the parabola through three points, kept within the end's own shape.
// `h` and `d` are the width and the chord of the piece at the end, `h1` and `d1` of the next.
double end_slope(double h, double d, double h1, double d1) noexcept {
  const double slope = ((2 * h + h1) * d - h * d1) / (h + h1);
  return slope > 0 && d > 0 ? slope : 0;
}

// Inside: the harmonic mean of both chords, weighted by the widths; level beside a level piece.
double slope_at(const Points& p, std::size_t i) noexcept {
  const std::size_t last = p.x.size() - 1;
  if (last == 1) return p.chord(0);
  if (i == 0) return end_slope(p.width(0), p.chord(0), p.width(1), p.chord(1));
  if (i == last) {
    return end_slope(p.width(i - 1), p.chord(i - 1), p.width(i - 2), p.chord(i - 2));
  }
  const double before = p.chord(i - 1);
  const double after = p.chord(i);
  if (!(before > 0 && after > 0)) return 0;
  const double w = 2 * p.width(i) + p.width(i - 1);
  const double w1 = p.width(i) + 2 * p.width(i - 1);
  return (w + w1) / (w / before + w1 / after);
}

// Hermite's cubic of one piece, t in [0, 1].
struct Piece {
  double from, rise, start, end;  // y, its rise, and the slopes in units of the piece's width

  double operator()(double t) const noexcept {
    const double s = 1 - t;
    return from + t * (rise * t * (3 - 2 * t) + s * (start * s - end * t));
  }
};

Piece piece_of(const Points& p, std::size_t i) noexcept {
  const double h = p.width(i);
  return {p.y[i], p.y[i + 1] - p.y[i], h * slope_at(p, i), h * slope_at(p, i + 1)};
}

}  // namespace

double monotone_value(std::span<const double> x, std::span<const double> y, double at) noexcept {
  if (at <= x.front()) return y.front();
  if (at >= x.back()) return y.back();
  const auto above = std::upper_bound(x.begin(), x.end(), at);
  const auto i = static_cast<std::size_t>(above - x.begin()) - 1;
  const double t = (at - x[i]) / (x[i + 1] - x[i]);
  return std::clamp(piece_of({x, y}, i)(t), y[i], y[i + 1]);
}

double monotone_inverse(std::span<const double> x, std::span<const double> y,
                        double value) noexcept {
  if (value <= y.front()) return x.front();
  if (value > y.back()) return x.back();
  const auto i =
      static_cast<std::size_t>(std::lower_bound(y.begin(), y.end(), value) - y.begin()) - 1;
  if (y[i + 1] == value) return x[i + 1];
  const Piece piece = piece_of({x, y}, i);
  double low = 0;
  double high = 1;
  for (int halvings = 0; halvings < 60; ++halvings) {
    const double middle = low + (high - low) / 2;
    (piece(middle) < value ? low : high) = middle;
  }
  return x[i] + high * (x[i + 1] - x[i]);
}

}  // namespace tristim
