#include "lib/dither/level_guess.h"

#include <Eigen/QR>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tristim::detail {
namespace {

constexpr int kMantissaBits = 23;
constexpr float kLookedUp = std::numeric_limits<float>::quiet_NaN();  // of a stretch without guess
constexpr int kFractions = 16;  // at which thresholds between levels are tried

// What a guess should give: at `light` the threshold number `count` of the fraction is reached.
struct Point {
  double light, fraction, count;
};

// What is guessed: thresholds, or levels with thresholds at every fraction between them.
struct Knots {
  std::span<const float> light;
  bool between;
};

// Of floats from `begin` to `end`, in one stretch.
struct Fit {
  double begin, end;
  std::array<double, LevelGuess::kCoefficients> coefficient{};
  double bend = 0;
};

double curvature(double fraction) { return fraction * (1 - fraction) / 2; }

double value(const Fit& fit, double light) {
  double sum = 0;
  for (std::size_t k = fit.coefficient.size(); k-- > 0;) sum = sum * light + fit.coefficient[k];
  return sum;
}

double guessed(const Fit& fit, const Point& point) {
  return value(fit, point.light) - point.fraction - fit.bend * curvature(point.fraction) + 0.5;
}

// Least squares around the middle of the stretch, then as powers of the light.
void solve(std::span<const Point> points, Fit& fit) {
  constexpr auto kPowers = static_cast<Eigen::Index>(LevelGuess::kCoefficients);
  const double middle = (fit.begin + fit.end) / 2;
  const double half = (fit.end - fit.begin) / 2;
  Eigen::MatrixXd rows(static_cast<Eigen::Index>(points.size()), kPowers + 1);
  Eigen::VectorXd wanted(rows.rows());
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    const Point& point = points[static_cast<std::size_t>(i)];
    const double t = (point.light - middle) / half;
    for (Eigen::Index k = 0; k < kPowers; ++k) rows(i, k) = k == 0 ? 1 : rows(i, k - 1) * t;
    rows(i, kPowers) = -curvature(point.fraction);
    wanted[i] = point.count + point.fraction - 0.5;
  }
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
  decomposition.setThreshold(1e-7);  // fewer points, or all on a line: the smallest coefficients
  const Eigen::VectorXd solution = decomposition.compute(rows).solve(wanted);
  fit.bend = solution[kPowers];
  fit.coefficient.fill(0);
  for (Eigen::Index k = kPowers; k-- > 0;) {  // times (light - middle)/half, plus the next
    for (std::size_t j = fit.coefficient.size(); j-- > 0;) {
      const double lower = j == 0 ? 0 : fit.coefficient[j - 1];
      fit.coefficient[j] = (lower - middle * fit.coefficient[j]) / half;
    }
    fit.coefficient[0] += solution[k];
  }
}

// Thresholds in a stretch between each two of the levels that it touches. Their fractions lie as
// the extremes of a Chebyshev polynomial do: between them a quartic hardly rises.
std::vector<Point> points_between(std::span<const float> light, double begin, double end) {
  std::vector<Point> points;
  for (std::size_t i = 1; i < light.size(); ++i) {
    const double low = light[i - 1];
    const double step = light[i] - low;
    const double first = std::max((begin - low) / step, 0.0);
    const double last = std::min((end - low) / step, 1.0);
    if (first > last) continue;
    for (int k = 0; k <= kFractions; ++k) {
      const double along = (1 - std::cos(std::numbers::pi * k / kFractions)) / 2;
      const double fraction = first + (last - first) * along;
      points.push_back({low + fraction * step, fraction, static_cast<double>(i)});
    }
  }
  return points;
}

// Thresholds in a stretch, with those around it where there are few.
std::vector<Point> points_at(std::span<const float> threshold, double begin, double end) {
  const auto number = [&](double light) {
    return std::ranges::lower_bound(threshold, light) - threshold.begin();
  };
  std::ptrdiff_t first = number(begin);
  std::ptrdiff_t last = number(end);
  const auto wanted = std::min<std::ptrdiff_t>(LevelGuess::kCoefficients, std::ssize(threshold));
  while (last - first < wanted) {
    if (first > 0) --first;
    if (last < std::ssize(threshold)) ++last;
  }
  std::vector<Point> points;
  for (std::ptrdiff_t i = first; i < last; ++i) {
    points.push_back({threshold[static_cast<std::size_t>(i)], 0, static_cast<double>(i + 1)});
  }
  return points;
}

// What the guess falls by anywhere in its stretch; it ought to rise.
double largest_fall(const Fit& fit) {
  constexpr int kSteps = 64;
  double highest = value(fit, fit.begin);
  double fall = 0;
  for (int i = 1; i <= kSteps; ++i) {
    const double here = value(fit, fit.begin + (fit.end - fit.begin) * i / kSteps);
    fall = std::max(fall, highest - here);
    highest = std::max(highest, here);
  }
  return fall;
}

// How far the guess at the ends of a stretch lies beyond the counts of thresholds there.
double error_at_ends(std::span<const float> threshold, const Fit& fit) {
  double error = 0;
  for (const double light : {fit.begin, fit.end}) {
    const auto reached = std::ranges::upper_bound(threshold, light) - threshold.begin();
    const double over = value(fit, light) + 0.5 - static_cast<double>(reached);
    error = std::max({error, -over, over - 1});
  }
  return error;
}

// What floats add to it: each product and sum rounded, and once more for the fraction.
double rounding(const Fit& fit, double count) {
  double sum = 2 * count + std::fabs(fit.bend);
  double power = 1;
  for (std::size_t k = 0; k < fit.coefficient.size(); ++k, power *= fit.end) {
    sum += static_cast<double>(k + 2) * std::fabs(fit.coefficient[k]) * power;
  }
  return sum * 0x1p-24;
}

// The largest error anywhere in a stretch. kFractions extremes hold a quartic between them to
// 1/cos(4/kFractions pi/2) of what it is there [Ehlich64].
double largest_error(const Knots& knots, std::span<const Point> points, const Fit& fit) {
  constexpr double kBetweenFractions = 1.09;
  double error = knots.between ? 0 : error_at_ends(knots.light, fit);
  for (const Point& point : points) {
    if (!knots.between && (point.light < fit.begin || point.light > fit.end)) continue;
    const double here = std::fabs(guessed(fit, point) - point.count);
    error = std::max(error, knots.between ? here * kBetweenFractions : here);
  }
  const double all =
      error + largest_fall(fit) + rounding(fit, static_cast<double>(knots.light.size()));
  return std::isfinite(all) ? all : std::numeric_limits<double>::infinity();
}

// What a stretch may be wrong by. Of each vector's 16 lights some are looked up with a probability
// of 32 times as much; more levels cannot be guessed as well.
double most_error(std::size_t levels) {
  return std::clamp(4e-6 * static_cast<double>(levels), 1e-3, 4e-3);
}

std::int32_t exponent(float light) { return std::bit_cast<std::int32_t>(light) >> kMantissaBits; }

// The first float of a stretch.
double begin_of(const LevelGuess& guess, std::int32_t stretch) {
  if (stretch == guess.first) return 0;
  const bool half = stretch >= 2 * guess.halved;
  const std::int32_t bits =
      half ? stretch << (kMantissaBits - 1) : (stretch - guess.halved) << kMantissaBits;
  return std::bit_cast<float>(bits);
}

// Half octaves from the top down as long as the stretches last. False where they do not reach.
bool lay_out(const Knots& knots, LevelGuess& guess) {
  const float top = knots.light.back();
  const float bottom = knots.light[std::min<std::size_t>(1, knots.light.size() - 1)];
  if (!(knots.light.front() >= 0) || !(bottom > 0) || !std::isfinite(top)) return false;
  const std::int32_t bits = std::bit_cast<std::int32_t>(top);
  // not a stretch of its own for the last level; a threshold's count goes on to the stretch's end
  const std::int32_t half_octave = (1 << (kMantissaBits - 1)) - 1;
  const std::int32_t last =
      knots.between ? (bits & half_octave) == 0 ? bits - 1 : bits : bits | half_octave;
  guess.highest = std::bit_cast<float>(last);
  const std::int32_t octaves = exponent(guess.highest) - exponent(bottom) + 1;
  const auto spare = static_cast<std::int32_t>(LevelGuess::kStretches) - 1 - octaves;
  if (spare < 0) return false;
  guess.halved = exponent(guess.highest) + 1 - std::min(octaves, spare);
  guess.first = exponent(bottom) - 1 + guess.halved;
  return true;
}

// Of the floats from `begin` to `end`, rounded as the guess will hold it.
Fit fit_stretch(std::span<const Point> points, double begin, double end) {
  Fit fit{begin, end};
  if (!points.empty()) solve(points, fit);
  for (double& c : fit.coefficient) c = static_cast<float>(c);
  fit.bend = static_cast<float>(fit.bend);
  return fit;
}

std::optional<LevelGuess> guess(const Knots& knots) {
  LevelGuess guess{};
  if (knots.light.empty() || !lay_out(knots, guess)) return std::nullopt;
  const std::int32_t last = guess.stretch(guess.highest);
  double error = 0;
  double looked_up = 0;  // light without a guess
  for (std::int32_t s = guess.first; s <= last; ++s) {
    const double begin = begin_of(guess, s);
    const double end = s == last ? guess.highest : begin_of(guess, s + 1);
    const auto points = knots.between ? points_between(knots.light, begin, end)
                                      : points_at(knots.light, begin, end);
    const Fit fit = fit_stretch(points, begin, end);
    const double here = largest_error(knots, points, fit);
    const bool good = here <= most_error(knots.light.size());
    if (good) error = std::max(error, here);
    if (!good) looked_up += end - begin;
    const auto column = static_cast<std::size_t>(s) % LevelGuess::kStretches;
    for (std::size_t k = 0; k < LevelGuess::kCoefficients; ++k) {
      guess.coefficient[k][column] = good ? static_cast<float>(fit.coefficient[k]) : kLookedUp;
    }
    guess.half_bend[column] = static_cast<float>(fit.bend / 2);
  }
  guess.sure = static_cast<float>(0.5 - error);
  if (looked_up > guess.highest / 4) return std::nullopt;
  return guess;
}

}  // namespace

std::int32_t LevelGuess::stretch(float light) const noexcept {
  const std::int32_t bits = std::bit_cast<std::int32_t>(light);
  return std::max({first, bits >> (kMantissaBits - 1), (bits >> kMantissaBits) + halved});
}

std::optional<LevelGuess> guess_thresholds(std::span<const float> threshold) {
  return guess({threshold, false});
}

std::optional<LevelGuess> guess_between(std::span<const float> light) {
  return guess({light, true});
}

}  // namespace tristim::detail
