#include "tristim/color/spectral_table.h"

#include <algorithm>

namespace tristim {
namespace {

constexpr double kCie1931Xyz[] = {
#include "luts/cie1931_xyz_1nm.csv"
};
constexpr double kCie1964Xyz[] = {
#include "luts/cie1964_xyz_1nm.csv"
};
constexpr double kCie1931Rgb[] = {
#include "luts/cie1931_rgb_5nm.csv"
};
constexpr double kPhotopic[] = {
#include "luts/luminous_efficiency_photopic_1nm.csv"
};
constexpr double kScotopic[] = {
#include "luts/luminous_efficiency_scotopic_1nm.csv"
};
constexpr double kDaylight[] = {
#include "luts/daylight_components_5nm.csv"
};

constexpr SpectralTable kTables[] = {
    {"cie1931", "matching functions of the 2 degree observer", "xbar ybar zbar", "[CIE15]",
     kCie1931Xyz},
    {"cie1964", "matching functions of the 10 degree observer", "xbar10 ybar10 zbar10", "[CIE15]",
     kCie1964Xyz},
    {"cie1931-rgb", "matching functions of primaries 700, 546.1, 435.8 nm, 2 degrees",
     "rbar gbar bbar", "[Broadbent04]", kCie1931Rgb},
    {"photopic", "luminous efficiency in daylight, V(lambda)", "V", "[ISO23539]", kPhotopic},
    {"scotopic", "luminous efficiency in the dark, V'(lambda)", "V'", "[ISO23539]", kScotopic},
    {"daylight-components", "mean and variations of daylight", "S0 S1 S2", "[Judd64]", kDaylight},
};

}  // namespace

std::size_t SpectralTable::column_count() const noexcept {
  return 1 + static_cast<std::size_t>(std::count(columns.begin(), columns.end(), ' '));
}

std::span<const SpectralTable> spectral_tables() noexcept { return kTables; }

Spectrum column_of(const SpectralTable& table, std::size_t column) {
  Spectrum spectrum;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    spectrum.lambda_nm.push_back(table.lambda_nm(row));
    spectrum.value.push_back(table.value(row, column));
  }
  return spectrum;
}

}  // namespace tristim
