#include "tristim/color/illuminant.h"

#include <cmath>
#include <limits>

#include "tristim/core/find.h"

namespace tristim {
namespace {

constexpr double kCells1nm[] = {
#include "luts/illuminants_1nm.csv"
};
constexpr double kCells5nm[] = {
#include "luts/illuminants_5nm.csv"
};
constexpr double kCellsF[] = {
#include "luts/illuminants_f_5nm.csv"
};
constexpr double kCellsLed[] = {
#include "luts/illuminants_led_5nm.csv"
};
constexpr double kCellsHp[] = {
#include "luts/illuminants_hp_5nm.csv"
};

constexpr SpectralTable kStandard{"standard", "standard illuminants", "A D65", "[CIE15] T.1",
                                  kCells1nm};
constexpr SpectralTable kOther{"other", "other illuminants", "B C D50 D55 D75 E", "[CIE15] T.1",
                               kCells5nm};
constexpr SpectralTable kF{"f", "fluorescent lamps", "F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12",
                           "[CIE15] T.10.1", kCellsF};
constexpr SpectralTable kLed{"led", "LED lamps", "B1 B2 B3 B4 B5 BH1 RGB1 V1 V2", "[CIE15] T.12.1",
                             kCellsLed};
constexpr SpectralTable kHp{"hp", "discharge lamps", "HP1 HP2 HP3 HP4 HP5", "[CIE15] T.11",
                            kCellsHp};

constexpr Illuminant kIlluminants[] = {
    {"a", "tungsten, 2856 K", &kStandard, 0},
    {"b", "sunlight at noon (obsolete)", &kOther, 0},
    {"c", "average daylight (obsolete)", &kOther, 1},
    {"d50", "daylight, 5003 K", &kOther, 2},
    {"d55", "daylight, 5503 K", &kOther, 3},
    {"d65", "daylight, 6504 K", &kStandard, 1},
    {"d75", "daylight, 7504 K", &kOther, 4},
    {"e", "equal energy", &kOther, 5},
    {"f1", "fluorescent, 6430 K", &kF, 0},
    {"f2", "fluorescent, cool white, 4230 K", &kF, 1},
    {"f3", "fluorescent, white, 3450 K", &kF, 2},
    {"f4", "fluorescent, warm white, 2940 K", &kF, 3},
    {"f5", "fluorescent, 6350 K", &kF, 4},
    {"f6", "fluorescent, 4150 K", &kF, 5},
    {"f7", "fluorescent, broad band, 6500 K", &kF, 6},
    {"f8", "fluorescent, broad band, 5000 K", &kF, 7},
    {"f9", "fluorescent, broad band, 4150 K", &kF, 8},
    {"f10", "fluorescent, three bands, 5000 K", &kF, 9},
    {"f11", "fluorescent, three bands, 4000 K", &kF, 10},
    {"f12", "fluorescent, three bands, 3000 K", &kF, 11},
    {"led-b1", "LED, blue and phosphor, 2733 K", &kLed, 0},
    {"led-b2", "LED, blue and phosphor, 2998 K", &kLed, 1},
    {"led-b3", "LED, blue and phosphor, 4103 K", &kLed, 2},
    {"led-b4", "LED, blue and phosphor, 5109 K", &kLed, 3},
    {"led-b5", "LED, blue and phosphor, 6598 K", &kLed, 4},
    {"led-bh1", "LED, blue, phosphor and red, 2851 K", &kLed, 5},
    {"led-rgb1", "LED, red, green and blue, 2840 K", &kLed, 6},
    {"led-v1", "LED, violet and phosphor, 2724 K", &kLed, 7},
    {"led-v2", "LED, violet and phosphor, 4070 K", &kLed, 8},
    {"hp1", "high-pressure sodium, 1959 K", &kHp, 0},
    {"hp2", "high-pressure sodium, colour enhanced, 2506 K", &kHp, 1},
    {"hp3", "metal halide, 3144 K", &kHp, 2},
    {"hp4", "metal halide, 4002 K", &kHp, 3},
    {"hp5", "metal halide, 4039 K", &kHp, 4},
};

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double to_three_decimals(double m) { return std::floor(m * 1000 + 0.5) / 1000; }

}  // namespace

std::span<const Illuminant> illuminants() noexcept { return kIlluminants; }

Spectrum illuminant_spectrum(const Illuminant& illuminant) {
  Spectrum listed;
  const Spectrum all = column_of(*illuminant.table, illuminant.column);
  for (std::size_t i = 0; i < all.value.size(); ++i) {
    if (all.value[i] < 0) continue;  // not listed
    listed.lambda_nm.push_back(all.lambda_nm[i]);
    listed.value.push_back(all.value[i]);
  }
  return listed;
}

Chromaticity daylight_chromaticity(double temperature_k) noexcept {
  if (!(temperature_k >= 4000 && temperature_k <= 25000)) return {kNaN, kNaN};
  const double t = 1000 / temperature_k;
  const double x = temperature_k <= 7000 ? 0.244063 + t * (0.09911 + t * (2.9678 - t * 4.6070))
                                         : 0.237040 + t * (0.24748 + t * (1.9018 - t * 2.0064));
  return {x, -3 * x * x + 2.870 * x - 0.275};
}

Spectrum daylight_spectrum(double temperature_k) {
  const Chromaticity c = daylight_chromaticity(temperature_k);
  const double m = 0.0241 + 0.2562 * c.x - 0.7341 * c.y;
  const double m1 = to_three_decimals((-1.3515 - 1.7703 * c.x + 5.9114 * c.y) / m);
  const double m2 = to_three_decimals((0.0300 - 31.4424 * c.x + 30.0717 * c.y) / m);
  const SpectralTable& components = *find_by_name(spectral_tables(), "daylight-components");
  Spectrum spectrum = column_of(components, 0);
  for (std::size_t row = 0; row < spectrum.value.size(); ++row) {
    spectrum.value[row] += m1 * components.value(row, 1) + m2 * components.value(row, 2);
  }
  return spectrum;
}

}  // namespace tristim
