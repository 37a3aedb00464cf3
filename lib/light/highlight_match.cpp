#include "tristim/light/highlight_match.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "lib/core/math.h"
#include "lib/light/degrees.h"
#include "lib/light/extreme.h"
#include "tristim/core/text.h"
#include "tristim/light/fisher_woo.h"
#include "tristim/light/vector.h"

namespace tristim {
namespace {

using detail::Extreme;
using detail::greatest_on_unit_interval;
using detail::SineCosine;
using Eigen::Vector3d;

constexpr double kTwoPi = 6.283185307179586;

double checked(const char* what, double value, double least) {
  // The comparison is false for NaN.
  if (value >= least && std::isfinite(value)) return value;
  throw std::invalid_argument(std::string(what) + ": " + shortest(value) + "; expected " +
                              (least == 0 ? "0 or more" : "a number above 0"));
}

constexpr double kAboveZero = 5e-324;  // the smallest double

double lobe(double cosine, double exponent) noexcept {
  return cosine > 0 ? detail::pow(cosine, exponent) : 0;
}

double cos_squared_beta(double le_deg) noexcept {
  const double cos_beta = detail::cos_deg(le_deg / 2);
  return cos_beta * cos_beta;
}

double limit_of_ratio(double a) noexcept {
  return a < 1 ? 255 * (1 - a) * detail::pow(a, a / (1 - a)) : 0;
}

// The angles of a grid from `first` to `last`, as far as they are in 0..180.
struct AngleSteps {
  std::vector<double> degrees;
  std::vector<SineCosine> turns;

  AngleSteps(double first, double last, double step) {
    for (double angle = std::max(first, 0.0); angle <= std::min(last, 180.0); angle += step) {
      degrees.push_back(angle);
      turns.push_back(detail::sine_cosine_deg(angle));
    }
  }
};

// As highlight_frame places it.
Vector3d normal_at(const SineCosine& theta, const SineCosine& phi) noexcept {
  return {-theta.sine * phi.cosine, theta.cosine, theta.sine * phi.sine};
}

// The error on one of the two circles, where R.E = 1 - 2 k sin^2 nu: k is 1 in the plane of L and E
// and cos^2 beta across it. The place is t in [0, 1] with t^4 = (N.H)^(2r), on which the lobe of
// any exponent is wide.
struct CircleError {
  double r, f, k;

  double cos_squared_nu(double t) const noexcept { return detail::pow(t, 4 / r); }
  double operator()(double t) const noexcept {
    const double r_dot_e = 1 - 2 * k * (1 - cos_squared_nu(t));
    return 255 * (lobe(r_dot_e, r) - lobe(t, 2 * f));
  }
};

// The shapes of Beckmann's and Blinn's distributions at t^4 = cos^n b.
struct BeckmannError {
  double n;

  double cos_squared(double t) const noexcept { return detail::pow(t, 8 / n); }
  double operator()(double t) const noexcept {
    const double c2 = cos_squared(t);
    if (!(c2 > 0)) return 0;
    const double per_m2 = (n + 2) / 2;
    return 255 * (detail::exp(-(1 / c2 - 1) * per_m2) / (c2 * c2) - detail::pow(t, 4));
  }
};

}  // namespace

double blinn_exponent(double phong_r, double f) {
  return checked("Phong exponent", phong_r, 0) * checked("factor of the exponents", f, kAboveZero);
}

double phong_exponent(double blinn_n, double f) {
  return checked("Blinn exponent", blinn_n, 0) / checked("factor of the exponents", f, kAboveZero);
}

double beckmann_roughness(double blinn_n) {
  return std::sqrt(2 / (checked("Blinn exponent", blinn_n, 0) + 2));
}

double blinn_exponent_of_roughness(double beckmann_m) {
  const double m = checked("Beckmann roughness", beckmann_m, kAboveZero);
  return std::max(2 / (m * m) - 2, 0.0);
}

double blinn_normalisation(double blinn_n) {
  return (checked("Blinn exponent", blinn_n, 0) + 2) / kTwoPi;
}

double phong_normalisation(double phong_r) {
  return (checked("Phong exponent", phong_r, 0) + 1) / kTwoPi;
}

ErrorRange highlight_errors(double phong_r, double f, double le_deg) {
  const double r = checked("Phong exponent", phong_r, kAboveZero);
  checked("factor of the exponents", f, kAboveZero);
  const CircleError in_plane{r, f, 1};
  const CircleError across{r, f, cos_squared_beta(le_deg)};
  // In the plane R.E falls faster than across it, so each end has its circle.
  const Extreme least = greatest_on_unit_interval([&](double t) { return -in_plane(t); });
  const Extreme greatest = greatest_on_unit_interval(across);
  return {.least = std::min(-least.value, 0.0),
          .greatest = std::max(greatest.value, 0.0),
          .least_n_dot_h = std::sqrt(in_plane.cos_squared_nu(least.place)),
          .greatest_n_dot_h = std::sqrt(across.cos_squared_nu(greatest.place))};
}

double limit_error(double le_deg) noexcept { return limit_of_ratio(cos_squared_beta(le_deg)); }

double minimax_factor(double phong_r, double le_deg) {
  checked("Phong exponent", phong_r, kAboveZero);
  if (cos_squared_beta(le_deg) == 0) return 0;
  // Both ends rise with the factor.
  const auto too_large = [&](double f) {
    const ErrorRange errors = highlight_errors(phong_r, f, le_deg);
    return errors.greatest + errors.least > 0;
  };
  double low = 4;
  double high = 4;
  while (too_large(low)) low /= 2;
  while (!too_large(high)) high *= 2;
  for (int i = 0; i < 44; ++i) {
    const double middle = (low + high) / 2;
    (too_large(middle) ? high : low) = middle;
  }
  return (low + high) / 2;
}

double minimax_factor_limit(double le_deg) noexcept { return 4 * detail::cos_deg(le_deg / 2); }

double minimax_limit_error(double le_deg) noexcept {
  return limit_of_ratio(detail::cos_deg(le_deg / 2));
}

ErrorRange beckmann_match_errors(double blinn_n) {
  const BeckmannError error{checked("Blinn exponent", blinn_n, kAboveZero)};
  const Extreme least = greatest_on_unit_interval([&](double t) { return -error(t); });
  const Extreme greatest = greatest_on_unit_interval(error);
  return {.least = std::min(-least.value, 0.0),
          .greatest = std::max(greatest.value, 0.0),
          .least_n_dot_h = std::sqrt(error.cos_squared(least.place)),
          .greatest_n_dot_h = std::sqrt(error.cos_squared(greatest.place))};
}

ErrorStatistics highlight_error_statistics(double phong_r, double f, double le_deg) {
  checked("Phong exponent", phong_r, 0);
  checked("factor of the exponents", f, kAboveZero);
  HighlightFrame frame = highlight_frame(0, 0, le_deg);
  const AngleSteps angles(0, 180, 1);
  double sum = 0;
  double sum_of_squares = 0;
  for (const SineCosine& theta : angles.turns) {
    for (const SineCosine& phi : angles.turns) {
      frame.normal = normal_at(theta, phi);
      const double error = pixel_error(frame, phong_r, f);
      sum += error;
      sum_of_squares += error * error;
    }
  }
  const double count = static_cast<double>(angles.turns.size() * angles.turns.size());
  const double mean = sum / count;
  return {mean, std::sqrt(std::max(sum_of_squares / count - mean * mean, 0.0))};
}

double near_eye_extreme(double phong_r, double f, double le_deg, double eye_distance) {
  checked("Phong exponent", phong_r, 0);
  checked("factor of the exponents", f, kAboveZero);
  if (!(eye_distance > 1)) {
    throw std::invalid_argument("distance of the eye: " + shortest(eye_distance) +
                                "; expected more than 1, the sphere's radius");
  }
  HighlightFrame frame = highlight_frame(0, 0, le_deg);
  const Vector3d eye(0, 0, eye_distance);
  // A grid, then ever finer ones about its best place.
  double best = 0;
  double best_theta = 90;
  double best_phi = 90;
  for (double reach = 90, step = 3; step > 1e-3; reach = 2 * step, step /= 8) {
    const AngleSteps thetas(best_theta - reach, best_theta + reach, step);
    const AngleSteps phis(best_phi - reach, best_phi + reach, step);
    for (std::size_t t = 0; t < thetas.turns.size(); ++t) {
      for (std::size_t p = 0; p < phis.turns.size(); ++p) {
        frame.normal = normal_at(thetas.turns[t], phis.turns[p]);
        frame.to_eye = normalize(eye - frame.normal);
        const double error = pixel_error(frame, phong_r, f);
        if (std::fabs(error) <= std::fabs(best)) continue;
        best = error;
        best_theta = thetas.degrees[t];
        best_phi = phis.degrees[p];
      }
    }
  }
  return best;
}

}  // namespace tristim
