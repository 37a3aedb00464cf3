#pragma once

#include <string>
#include <vector>

#include "tristim/color/spectrum_text.h"

namespace tristim::tools {

/// Spectral functions over common wavelengths, and what they are.
struct SpectralColumns {
  std::string title;  // and source, for people
  std::vector<NamedSpectrum> columns;
};

/// What `text` names: a table (cie1931), an illuminant (d65, daylight:6500, planckian:2700), or a
/// file of spectra. Throws Error: kMisuse for unknown names, with a hint; as read_text_file and
/// parse_spectra do.
SpectralColumns spectral_columns(const std::string& text);

/// The spectra of files, "-" standard input, one after another.
std::vector<NamedSpectrum> read_spectra(const std::vector<std::string>& files);

/// An illuminant by name or temperature, or of a file with one spectrum. Throws Error.
NamedSpectrum read_illuminant(const std::string& text, const std::string& option);

/// The rule of an option's value. Throws Error (kMisuse).
const SumRule& rule_option(const std::string& text);

}  // namespace tristim::tools
