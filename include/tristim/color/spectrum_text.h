#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/spectrum.h"

namespace tristim {

/// A spectrum and what it is called.
struct NamedSpectrum {
  std::string name;
  Spectrum spectrum;
};

/// Spectra of a text in rows: a wavelength in nm and the value of each spectrum there, at any
/// steps, parted by semicolons, commas, tabs or spaces. A first row that is not all numbers names
/// the columns; comments go from # on, or are lines that begin with //. Without a header a spectrum
/// is called by its column, "2" the first.
///
/// `name` is what messages call the text. Throws Error (kContent) that names row and column for
/// what is no finite number, rows of other lengths, and faulty wavelengths (spectrum_fault).
std::vector<NamedSpectrum> parse_spectra(std::string_view text, std::string_view name);

/// A kind of light that a temperature makes.
struct ThermalLight {
  std::string_view name;
  std::string_view title;
  double least_k, most_k;
  Spectrum (*spectrum)(double temperature_k);  // relative power
};

/// daylight and planckian, by temperature. The command line reads this list.
std::span<const ThermalLight> thermal_lights() noexcept;

/// Whether the text begins with the name of one, as "daylight:6500" does.
bool names_thermal_light(std::string_view text) noexcept;

/// An illuminant as text names it: one of the list ("d65", "F11"), "daylight:6500" or
/// "planckian:2700" in kelvins. Throws Error (kMisuse) "<thing>: ..." for others.
NamedSpectrum parse_illuminant(std::string_view text, std::string_view thing);

}  // namespace tristim
