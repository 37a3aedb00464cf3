#include "tristim/device/fit.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>

#include "lib/core/math.h"
#include "tristim/color/difference.h"
#include "tristim/color/lab.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

// What is fitted: logarithms of what must be above 0. Luminances are in units of the greatest
// measured.
using Parameters = Eigen::Vector4d;
enum Index { kLogRange, kLogGamma, kOffset, kBlack };

constexpr double kMostOffset = 0.9;

struct Ramp {
  std::vector<double> drive;  // V/Vmax
  std::vector<double> light;  // of the greatest luminance measured
  std::vector<double> lstar;  // of light
};

Ramp ramp_of(const TableResponse& measured, double code_max) {
  Ramp ramp;
  for (std::size_t i = 0; i < measured.code.size(); ++i) {
    ramp.drive.push_back(measured.code[i] / code_max);
    ramp.light.push_back(measured.luminance[i] / measured.luminance.back());
    ramp.lstar.push_back(lstar_from_luminance(ramp.light.back()));
  }
  return ramp;
}

double modelled(const Parameters& p, double drive) {
  const double v = p[kOffset] + (1 - p[kOffset]) * drive;
  const double power = v > 0 ? detail::pow(v, detail::exp(p[kLogGamma])) : 0;
  return p[kBlack] + detail::exp(p[kLogRange]) * power;
}

Eigen::VectorXd residuals(const Ramp& ramp, const Parameters& p) {
  Eigen::VectorXd r(static_cast<Eigen::Index>(ramp.drive.size()));
  for (Eigen::Index i = 0; i < r.size(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    r[i] = lstar_from_luminance(modelled(p, ramp.drive[at])) - ramp.lstar[at];
  }
  return r;
}

Parameters within_bounds(Parameters p) {
  p[kLogGamma] = std::clamp(p[kLogGamma], -4.0, 4.0);
  p[kOffset] = std::clamp(p[kOffset], -kMostOffset, kMostOffset);
  p[kBlack] = std::clamp(p[kBlack], 0.0, 0.99);
  return p;
}

std::vector<Index> free_parameters(const FitModel& model) {
  std::vector<Index> free{kLogRange, kLogGamma};
  if (model.has_offset) free.push_back(kOffset);
  if (model.has_black) free.push_back(kBlack);
  return free;
}

// Derivatives by central differences.
Eigen::MatrixXd jacobian(const Ramp& ramp, const Parameters& p, const std::vector<Index>& free) {
  constexpr double kStep = 1e-6;
  Eigen::MatrixXd j(ramp.drive.size(), free.size());
  for (std::size_t c = 0; c < free.size(); ++c) {
    Parameters up = p;
    Parameters down = p;
    up[free[c]] += kStep;
    down[free[c]] -= kStep;
    j.col(static_cast<Eigen::Index>(c)) =
        (residuals(ramp, up) - residuals(ramp, down)) / (2 * kStep);
  }
  return j;
}

struct Fit {
  Parameters parameters;
  double cost;  // sum of squares
};

// Levenberg's and Marquardt's way down from `start`; steps end at the bounds.
Fit descend(const Ramp& ramp, const Parameters& start, const FitModel& model) {
  const std::vector<Index> free = free_parameters(model);
  Fit fit{within_bounds(start), 0};
  Eigen::VectorXd r = residuals(ramp, fit.parameters);
  fit.cost = r.squaredNorm();
  double damping = 1e-3;
  for (int step = 0; step < 200 && damping < 1e12 && fit.cost > 1e-24; ++step) {
    const Eigen::MatrixXd j = jacobian(ramp, fit.parameters, free);
    Eigen::MatrixXd normal = j.transpose() * j;
    normal.diagonal() *= 1 + damping;
    normal.diagonal().array() +=
        1e-12;  // of what moves nothing, as gamma where no code gives light
    const Eigen::VectorXd change = normal.ldlt().solve(-j.transpose() * r);
    Parameters next = fit.parameters;
    for (std::size_t c = 0; c < free.size(); ++c)
      next[free[c]] += change[static_cast<Eigen::Index>(c)];
    next = within_bounds(next);
    const Eigen::VectorXd next_r = residuals(ramp, next);
    const double cost = next_r.squaredNorm();
    if (!(cost < fit.cost)) {
      damping *= 10;
      continue;
    }
    const bool settled = fit.cost - cost < 1e-15 * fit.cost;
    fit = {next, cost};
    r = next_r;
    damping /= 10;
    if (settled) break;
  }
  return fit;
}

// The exponent that the row nearest to half drive would have.
double first_gamma(const Ramp& ramp) {
  std::size_t at = 0;
  for (std::size_t i = 0; i < ramp.drive.size(); ++i) {
    if (std::fabs(ramp.drive[i] - 0.5) < std::fabs(ramp.drive[at] - 0.5)) at = i;
  }
  const double light = ramp.light[at] - ramp.light[0];
  if (!(light > 0 && light < 1 && ramp.drive[at] > 0 && ramp.drive[at] < 1)) return 2.2;
  const double gamma = detail::log(light / (1 - ramp.light[0])) / detail::log(ramp.drive[at]);
  return std::clamp(gamma, 0.2, 8.0);
}

// The offset of a curve that leaves black behind the last code as dark as the first.
double dark_offset(const Ramp& ramp) {
  std::size_t last = 0;
  while (last + 1 < ramp.light.size() && ramp.light[last + 1] == ramp.light[0]) ++last;
  const double drive = std::min(ramp.drive[last], 0.4);
  return -drive / (1 - drive);
}

std::vector<Parameters> starts(const Ramp& ramp, const FitModel& model) {
  const double gamma = first_gamma(ramp);
  const double black = ramp.light[0];
  const double log_gamma = detail::log(gamma);
  if (!model.has_offset) {
    return {{0, log_gamma, 0, model.has_black ? black : 0}};
  }
  const double lift = black > 0 ? detail::pow(black, 1 / gamma) : 0;
  std::vector<Parameters> all;
  for (const double offset : {lift, dark_offset(ramp)}) all.push_back({0, log_gamma, offset, 0});
  if (model.has_black) {
    for (const double offset : {0.0, dark_offset(ramp)}) {
      all.push_back({0, log_gamma, offset, black});
    }
  }
  return all;
}

Fit fit_model(const Ramp& ramp, const FitModel& model) {
  std::optional<Fit> best;
  for (const Parameters& start : starts(ramp, model)) {
    const Fit fit = descend(ramp, start, model);
    if (!best || fit.cost < best->cost) best = fit;
  }
  return *best;
}

// Schwarz's criterion. Residuals of a hundredth of L* are none: nobody sees them.
double criterion(const Fit& fit, const FitModel& model, std::size_t rows) {
  constexpr double kNone = 0.01 * 0.01;
  const auto n = static_cast<double>(rows);
  return n * detail::log(fit.cost / n + kNone) + model.parameters() * detail::log(n);
}

ResponseFit report(const TableResponse& measured, double code_max, const FitModel& model,
                   const Fit& fit) {
  const Parameters& p = fit.parameters;
  const double unit = measured.luminance.back();
  const double range = detail::exp(p[kLogRange]);
  const double gamma = detail::exp(p[kLogGamma]);
  ResponseFit result{.model = &model,
                     .response = {gamma, p[kOffset], p[kBlack] / (p[kBlack] + range)},
                     .white = unit * (p[kBlack] + range),
                     .black = unit * p[kBlack],
                     .residuals = {}};
  result.k = unit * range * detail::pow((1 - p[kOffset]) / code_max, gamma);
  double squares = 0;
  double lstar_squares = 0;
  for (std::size_t i = 0; i < measured.code.size(); ++i) {
    const double fitted = unit * modelled(p, measured.code[i] / code_max);
    const Lab first{lstar_from_luminance(measured.luminance[i] / unit), 0, 0};
    const Lab second{lstar_from_luminance(fitted / unit), 0, 0};
    const FitResidual residual{measured.code[i], measured.luminance[i], fitted, second.l - first.l,
                               ciede2000(first, second)};
    squares += (fitted - residual.measured) * (fitted - residual.measured);
    lstar_squares += residual.lstar * residual.lstar;
    result.largest_lstar = std::max(result.largest_lstar, std::fabs(residual.lstar));
    result.largest_ciede2000 = std::max(result.largest_ciede2000, residual.ciede2000);
    result.residuals.push_back(residual);
  }
  const auto rows = static_cast<double>(measured.code.size());
  result.rms_luminance = std::sqrt(squares / rows);
  result.rms_lstar = std::sqrt(lstar_squares / rows);
  return result;
}

void check(const TableResponse& measured, double code_max, const FitModel& model) {
  check_response(measured);
  if (!(code_max >= measured.code.back())) {
    throw std::invalid_argument("Vmax: " + shortest(code_max) + " is below the code " +
                                shortest(measured.code.back()));
  }
  if (measured.code.size() < static_cast<std::size_t>(model.parameters())) {
    throw std::invalid_argument("rows: " + std::to_string(measured.code.size()) +
                                " are too few for the " + std::to_string(model.parameters()) +
                                " figures of " + std::string(model.name));
  }
}

}  // namespace

ResponseFit fit_response(const TableResponse& measured, double code_max, const FitModel* model) {
  check(measured, code_max, model != nullptr ? *model : kFitModels[0]);
  const Ramp ramp = ramp_of(measured, code_max);
  if (model != nullptr) return report(measured, code_max, *model, fit_model(ramp, *model));
  const std::size_t rows = measured.code.size();
  const FitModel* best = nullptr;
  Fit best_fit{};
  double least = 0;
  for (const FitModel& candidate : kFitModels) {
    const bool spare = rows > static_cast<std::size_t>(candidate.parameters());
    if (best != nullptr && !spare) continue;  // a curve through all rows proves nothing
    const Fit fit = fit_model(ramp, candidate);
    const double value = criterion(fit, candidate, rows);
    if (best != nullptr && !(value < least)) continue;
    least = value;
    best = &candidate;
    best_fit = fit;
  }
  return report(measured, code_max, *best, best_fit);
}

}  // namespace tristim
