#include "tristim/device/display.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lib/core/math.h"

namespace tristim {
namespace {

int code_max_of(int bits) { return (1 << bits) - 1; }

// Picture light from the device's light, where the device's black is `black`.
double picture_light(double light, double black, BlackPoint black_point) {
  return black_point == BlackPoint::kRelative ? (light - black) / (1 - black) : light;
}

double device_light(double picture, double black, BlackPoint black_point) {
  return black_point == BlackPoint::kRelative ? black + picture * (1 - black) : picture;
}

// Levels whose light does not rise above the one before add nothing to mix with.
void keep_distinct(LevelScale& scale) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < scale.light.size(); ++i) {
    if (kept > 0 && !(scale.light[i] > scale.light[kept - 1])) continue;
    scale.light[kept] = scale.light[i];
    scale.code[kept] = scale.code[i];
    ++kept;
  }
  scale.light.resize(kept);
  scale.code.resize(kept);
}

LevelScale curve_scale(const Display& display, int bits, BlackPoint black_point) {
  const int code_max = code_max_of(bits);
  const double black = light_of_code(display.response, 0, code_max);
  LevelScale scale;
  for (int c = 0; c <= code_max; ++c) {
    const double light = light_of_code(display.response, c, code_max);
    scale.light.push_back(static_cast<float>(picture_light(light, black, black_point)));
    scale.code.push_back(static_cast<std::uint16_t>(c));
    scale.nearest.push_back(static_cast<std::uint16_t>(c));
    if (c == 0) continue;
    const double middle = light_of_code(display.response, c - 0.5, code_max);
    const auto reaches = [&](double picture) {
      const double i = device_light(picture, black, black_point);
      return code_of_light(display.response, i, code_max) >= c - 0.5;
    };
    scale.threshold.push_back(
        detail::first_float(picture_light(middle, black, black_point), reaches));
  }
  keep_distinct(scale);
  return scale;
}

double emitted(const Display& display, int code, int code_max) {
  return light_of_code(display.response, code, code_max);
}

LevelScale table_scale(const Display& display, int bits, BlackPoint black_point) {
  const LevelTable& table = *display.levels;
  const int code_max = code_max_of(bits);
  const bool index = display.frame.store == Store::kIndex;
  const std::vector<double> levels = intensity_levels(table);
  const std::vector<int> values = display_level_codes(display, bits);
  const double black = emitted(display, values.front(), code_max);
  LevelScale scale;
  for (int j = 0; j <= table.n; ++j) {
    const int value = values[static_cast<std::size_t>(j)];
    const auto stored = static_cast<std::uint16_t>(index ? j : value);
    const double light = emitted(display, value, code_max);
    scale.light.push_back(static_cast<float>(picture_light(light, black, black_point)));
    scale.code.push_back(stored);
    scale.nearest.push_back(stored);
    if (j == 0) continue;
    const double lower = levels[static_cast<std::size_t>(j - 1)];
    const double upper = levels[static_cast<std::size_t>(j)];
    // Picture black is the lowest level, I0, whatever code rounding made of it.
    const auto reaches = [&](double picture) {
      const double i = device_light(picture, table.i0, black_point);
      return nearest_level(i, table).value_or(0) >= j;
    };
    scale.threshold.push_back(detail::first_float(
        picture_light(std::sqrt(lower * upper), table.i0, black_point), reaches));
  }
  keep_distinct(scale);
  return scale;
}

double gamma_of(const Response& response) {
  const auto* gamma = std::get_if<GammaResponse>(&response);
  return gamma != nullptr ? gamma->gamma : 0;
}

// V_j by the document's formula where the response is a pure power; by the response's inverse
// elsewhere.
int value_of_level(const Display& display, double intensity, int code_max) {
  const double v = code_of_light(display.response, intensity, code_max);
  return static_cast<int>(std::floor(v + 0.5));
}

}  // namespace

bool is_monochrome(const Display& display) noexcept {
  return display.frame.packing.samples == 1 && !display.frame.packing.indexed;
}

std::vector<int> display_level_codes(const Display& display, int bits) {
  if (!display.levels) throw std::invalid_argument("display: it has no intensity levels");
  const int code_max = code_max_of(bits);
  const std::vector<double> levels = intensity_levels(*display.levels);
  const double gamma = gamma_of(display.response);
  const auto* power = std::get_if<GammaResponse>(&display.response);
  if (gamma > 0 && power->i0 == 0) return level_codes(levels, gamma, code_max, power->k);
  std::vector<int> values;
  for (const double i : levels) values.push_back(value_of_level(display, i, code_max));
  return values;
}

LevelScale level_scale(const Display& display, int bits, BlackPoint black_point) {
  return display.levels ? table_scale(display, bits, black_point)
                        : curve_scale(display, bits, black_point);
}

std::vector<double> light_of_codes(const Display& display, int bits) {
  const int code_max = code_max_of(bits);
  std::vector<double> light;
  if (display.levels && display.frame.store == Store::kIndex) {
    const std::vector<int> values = display_level_codes(display, bits);
    for (int c = 0; c <= code_max; ++c) {
      const auto j = std::min(static_cast<std::size_t>(c), values.size() - 1);
      light.push_back(emitted(display, values[j], code_max));
    }
    return light;
  }
  for (int c = 0; c <= code_max; ++c) light.push_back(emitted(display, c, code_max));
  return light;
}

std::vector<Rgb> palette_light(const Display& display, BlackPoint black_point) {
  if (display.palette.empty()) return {};
  const auto by_luminance = [](const CodeColor& a, const CodeColor& b) {
    return a.appearance.y < b.appearance.y;
  };
  const auto [darkest, lightest] =
      std::minmax_element(display.palette.begin(), display.palette.end(), by_luminance);
  const bool own_white = display.palette_has_white;
  const Xyz w = own_white ? lightest->appearance : white_xyz(display.viewing_white);
  const Xyy white = xyz_to_xyy(w);
  const Eigen::Matrix3d matrix =
      rgb_from_xyz(display.primaries) *
      adaptation_matrix({white.x, white.y}, display.primaries.white, display.adaptation);
  const auto light = [&](const Xyz& c) -> Eigen::Vector3d {
    return matrix * Eigen::Vector3d(c.x / w.y, c.y / w.y, c.z / w.y);
  };
  Eigen::Vector3d zero = Eigen::Vector3d::Zero();
  if (own_white && black_point == BlackPoint::kRelative) zero = light(darkest->appearance);
  // A channel in which black is as bright as white cannot be stretched: it stays.
  const Eigen::Vector3d range =
      (Eigen::Vector3d::Ones() - zero).unaryExpr([](double r) { return r > 1e-6 ? r : 1.0; });
  std::vector<Rgb> palette;
  for (const CodeColor& entry : display.palette) {
    const Eigen::Vector3d c = (light(entry.appearance) - zero).cwiseQuotient(range);
    palette.push_back({c.x(), c.y(), c.z()});
  }
  return palette;
}

}  // namespace tristim
