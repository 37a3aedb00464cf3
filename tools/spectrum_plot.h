#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tristim/color/spectrum_text.h"

namespace tristim::tools {

/// A drawing (SVG) of spectra over wavelength with a legend; the spectrum's colours lie above the
/// frame. At least one spectrum, without fault.
std::string spectrum_plot(std::span<const NamedSpectrum> spectra, std::string_view title);

}  // namespace tristim::tools
