#pragma once

#include <string_view>
#include <vector>

#include "tristim/device/response.h"

namespace tristim {

/// A model of how luminance follows from codes; all are cases of GogResponse.
struct FitModel {
  std::string_view name;
  std::string_view formula;
  bool has_offset, has_black;  // besides the white and gamma
  int parameters() const noexcept { return 2 + (has_offset ? 1 : 0) + (has_black ? 1 : 0); }
};

/// Every model, the simplest first [Berns93, Shoaff 2.1.1].
inline constexpr FitModel kFitModels[] = {
    {"gamma", "L = Lw (V/Vmax)^gamma", false, false},
    {"gamma-black", "L = Lb + (Lw - Lb) (V/Vmax)^gamma", false, true},
    {"gog", "L = Lw max(gain V/Vmax + offset, 0)^gamma, gain = 1 - offset", true, false},
    {"gog-black", "L = Lb + (Lw - Lb) max(gain V/Vmax + offset, 0)^gamma, gain = 1 - offset", true,
     true},
};

/// What a fit leaves over at one measured code.
struct FitResidual {
  double code = 0;
  double measured = 0, fitted = 0;  // luminance, in the unit of the measurement
  double lstar = 0;                 // L* of the fitted less that of the measured, white 100
  double ciede2000 = 0;             // between both as greys
};

/// A model fitted to a measurement.
struct ResponseFit {
  const FitModel* model = nullptr;
  GogResponse response;  // relative to `white`
  double white = 0;      // Lw, the fitted luminance of Vmax
  double black = 0;      // Lb, the light that no code takes away
  double k = 0;          // of L = Lb + K (V + offset/gain Vmax)^gamma
  std::vector<FitResidual> residuals;
  double rms_lstar = 0, largest_lstar = 0;  // of the residuals, without sign
  double rms_luminance = 0;
  double largest_ciede2000 = 0;
};

/// Fits a model by least squares in L* (white the greatest luminance measured), where errors are
/// seen [Levenberg44, Marquardt63]. Without a model the one that Schwarz's criterion prefers
/// [Schwarz78]: more parameters only where they pay.
///
/// `code_max` is Vmax, at least the highest code measured. Throws std::invalid_argument where it is
/// not, as check_response does, and where there are fewer rows than the model has parameters.
ResponseFit fit_response(const TableResponse& measured, double code_max,
                         const FitModel* model = nullptr);

/// A fit with no larger CIEDE2000 than this describes a channel; beyond it the table does better.
inline constexpr double kGoodFit = 1;

}  // namespace tristim
