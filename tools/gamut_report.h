#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tristim/color/illuminant.h"
#include "tristim/color/xyz.h"
#include "tristim/plot/chromaticity.h"

namespace tristim::tools {

/// A colour whose place in gamuts is asked for.
struct GamutColor {
  std::string name;
  Xyz xyz;  // relative to its own white
};

/// What `tristim gamut` was asked for.
struct GamutQuestion {
  std::vector<DiagramGamut> sets;
  std::vector<GamutColor> colors;
  Chromaticity white = kD65;  // of the colours
  Adaptation adaptation = Adaptation::kBradford;
  const Illuminant* illuminant = nullptr;  // of the MacAdam limits
};

/// Areas, coverage, what is common to all sets, and where the colours lie.
nlohmann::ordered_json gamut_json(const GamutQuestion& question);
std::string gamut_text(const GamutQuestion& question);

}  // namespace tristim::tools
