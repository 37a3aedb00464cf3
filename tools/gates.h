#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tristim/measure/figures.h"

namespace tristim::tools {

/// A bound on a figure, which may be no further from 0 than that; a ratio of signal to noise must
/// reach it.
struct Gate {
  std::string name;
  double bound = 0;
};

/// "scielab_mean@40=1.2,hvs_snr@40=27.8". Throws Error (kMisuse) for other texts.
std::vector<Gate> parse_gates(std::string_view text);

/// Throws Error: kMisuse for a name that is no figure's, kGate where one misses its bound.
void check_gates(const std::vector<Gate>& gates, const std::vector<Figure>& figures,
                 const std::string& result);

}  // namespace tristim::tools
