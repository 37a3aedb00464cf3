#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tools/cli.h"
#include "tools/levels_job.h"

namespace tristim::tools {

/// The options of `tristim levels` that say what is computed; what is absent comes from the device
/// or the measurement where one is named, else from the defaults.
struct LevelsOptions {
  std::optional<int> n, vmax;
  std::optional<double> i0, peak, white, black;
  const LevelSpacing* spacing = nullptr;
  std::vector<double> gamma;  // one, or of red, green and blue
  std::optional<double> k;
  std::string response;
  std::string device;
  std::vector<std::string> measured;
  bool monotone = false, from_zero = false, dimming = false, dead_reckoned = false;
  int temporal_bits = 0;
  std::optional<Store> store;
};

/// Declares them, in sections of the help page.
void declare_levels(CommandLine& line, LevelsOptions& options);

/// What they ask for. Throws Error: kMisuse where they contradict each other, kSystem and kContent
/// of the files that they name.
LevelsJob levels_job(const LevelsOptions& options);

}  // namespace tristim::tools
