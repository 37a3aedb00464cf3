#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tools/cli.h"
#include "tools/convert_rows.h"
#include "tristim/color/observer.h"
#include "tristim/color/spectrum.h"

namespace tristim::tools {

/// How `--from spectrum` makes colours.
struct SpectrumSettings {
  std::string illuminant;  // "": the spectra are light themselves
  const Observer* observer = &observers()[0];
  const SumRule* rule = &kSum5nm;
  double white_luminance = 0;  // cd/m2 of light that becomes Y = 1; 0: not given
  bool given = false;          // whether any of these was
};

/// Their options, in a section of their own.
void declare_spectrum_options(CommandLine& line, SpectrumSettings& settings);

/// Spectra as colours.
struct SpectrumColors {          // NOLINT(bugprone-exception-escape): JSON moves without
  std::vector<ColorRow> rows;    // X Y Z
  ModelReference model;          // xyz, with the white of the illuminant
  std::string explanation;       // the step from spectrum to XYZ in words
  nlohmann::ordered_json facts;  // names, rule, illuminant, observer, white
};

/// The colours of every spectrum in the files ("-" is standard input). What a spectrum lacks of the
/// rule's wavelengths is 0, and is said in a note. Throws Error where a file cannot be read, holds
/// no spectra, or none of the rule's wavelengths.
SpectrumColors read_spectrum_colors(const std::vector<std::string>& files,
                                    const SpectrumSettings& settings);

}  // namespace tristim::tools
