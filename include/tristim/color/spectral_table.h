#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "tristim/color/spectrum.h"

namespace tristim {

/// A published table of spectral functions at equal steps.
struct SpectralTable {
  std::string_view name;
  std::string_view title;
  std::string_view columns;  // their names, separated by spaces
  std::string_view source;
  std::span<const double> cells;  // rows of a wavelength in nm and one value for each column

  std::size_t column_count() const noexcept;
  std::size_t row_count() const noexcept { return cells.size() / (column_count() + 1); }
  double lambda_nm(std::size_t row) const noexcept { return cells[row * (column_count() + 1)]; }
  double value(std::size_t row, std::size_t column) const noexcept {
    return cells[row * (column_count() + 1) + 1 + column];
  }
};

/// The matching functions, luminous efficiencies and daylight components. The command line reads
/// this list.
std::span<const SpectralTable> spectral_tables() noexcept;

/// One column of a table as a spectrum; column in [0, column_count()).
Spectrum column_of(const SpectralTable& table, std::size_t column);

}  // namespace tristim
