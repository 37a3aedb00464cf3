#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "tristim/device/characterize.h"
#include "tristim/device/display.h"
#include "tristim/device/fit.h"

namespace tristim::tools {

/// One channel, measured and fitted.
struct ChannelFit {
  std::string name;  // empty: the only one
  TableResponse ramp;
  double code_max = 255;
  ResponseFit fit;
};

/// What `tristim device fit` found.
struct FitReport {
  std::vector<ChannelFit> channels;
  std::optional<MeasuredPrimaries> measured;
  bool has_primaries = false;  // measured or given
  double largest_ciede2000 = 0;
  bool writes_table = false;
  Display display;
};

/// The parameters, residuals row by row, and of primaries the matrix, additivity and coverage.
nlohmann::ordered_json fit_json(const FitReport& report);
std::string fit_text(const FitReport& report);

/// A drawing (SVG): the measured points on the fitted curves, and the residuals in L*.
std::string fit_plot(const FitReport& report);

}  // namespace tristim::tools
