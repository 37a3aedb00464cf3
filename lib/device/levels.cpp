#include "tristim/device/levels.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/core/math.h"
#include "tristim/color/lab.h"
#include "tristim/color/transfer.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

void check(const LevelTable& table) {
  if (table.n < 1 || table.n > 65535) {
    throw std::invalid_argument("n: " + std::to_string(table.n) + " is not in 1..65535");
  }
  if (!(table.i0 > 0 && table.i0 < 1)) {
    throw std::invalid_argument("i0: " + shortest(table.i0) + " is not between 0 and 1");
  }
  if (!(table.gamma > 0) || !std::isfinite(table.gamma)) {
    throw std::invalid_argument("gamma: " + shortest(table.gamma) + " is not above 0");
  }
}

const LevelSpacing& spacing_of(const LevelTable& table) {
  return table.spacing != nullptr ? *table.spacing : level_spacings().front();
}

}  // namespace

const std::vector<LevelSpacing>& level_spacings() {
  static const std::vector<LevelSpacing> spacings = {
      {"ratio", [](double i, double) { return detail::log(i); },
       [](double p, double) { return detail::exp(p); }, "I_j = I0^((n-j)/n)", "[Shoaff 2.1.1]"},
      {"lstar", [](double i, double) { return lstar_from_luminance(i); },
       [](double p, double) { return luminance_from_lstar(p); }, "equal steps of L*",
       "[CIE15 8.2.1]"},
      {"srgb", [](double i, double) { return srgb_encode(i); },
       [](double p, double) { return srgb_decode(p); }, "equal steps of the sRGB curve",
       "[IEC61966]"},
      {"gamma", [](double i, double gamma) { return gamma_encode(i, gamma); },
       [](double p, double gamma) { return gamma_decode(p, gamma); }, "equal steps of I^(1/gamma)",
       "[Shoaff 2.1.1]"}};
  return spacings;
}

std::vector<double> intensity_levels(const LevelTable& table) {
  check(table);
  const LevelSpacing& spacing = spacing_of(table);
  const bool ratio = &spacing == &level_spacings().front();
  const double low = spacing.position(table.i0, table.gamma);
  const double high = spacing.position(1, table.gamma);
  std::vector<double> levels;
  for (int j = 0; j <= table.n; ++j) {
    const double step = double(j) / table.n;
    levels.push_back(ratio ? detail::pow(table.i0, double(table.n - j) / table.n)
                           : spacing.intensity(low + (high - low) * step, table.gamma));
  }
  levels.front() = table.i0;
  levels.back() = 1;
  return levels;
}

std::optional<int> nearest_level(double intensity, const LevelTable& table) {
  check(table);
  if (std::isnan(intensity)) return std::nullopt;
  if (intensity <= 0) return 0;
  if (intensity > 1) return table.n;
  const LevelSpacing& spacing = spacing_of(table);
  const double low = spacing.position(table.i0, table.gamma);
  const double high = spacing.position(1, table.gamma);
  const double j =
      std::floor((spacing.position(intensity, table.gamma) - low) / (high - low) * table.n + 0.5);
  return static_cast<int>(std::clamp(j, 0.0, double(table.n)));
}

std::vector<int> level_codes(const std::vector<double>& intensities, double gamma, int code_max,
                             double k) {
  if (!(gamma > 0) || !std::isfinite(gamma)) {
    throw std::invalid_argument("gamma: " + shortest(gamma) + " is not above 0");
  }
  if (code_max < 1) {
    throw std::invalid_argument("Vmax: " + std::to_string(code_max) + " is not above 0");
  }
  std::vector<int> codes;
  for (const double i : intensities) {
    const double v = k > 0 ? gamma_encode(i / k, gamma) : code_max * gamma_encode(i, gamma);
    codes.push_back(static_cast<int>(std::clamp(std::floor(v + 0.5), 0.0, double(code_max))));
  }
  return codes;
}

}  // namespace tristim
