#include "tristim/device/display.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "lib/core/math.h"
#include "lib/device/spacing.h"
#include "tristim/device/channels.h"

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

LevelScale curve_scale(const Response& response, int code_max, BlackPoint black_point) {
  const double black = light_of_code(response, 0, code_max);
  LevelScale scale;
  for (int c = 0; c <= code_max; ++c) {
    const double light = light_of_code(response, c, code_max);
    scale.light.push_back(static_cast<float>(picture_light(light, black, black_point)));
    scale.code.push_back(static_cast<std::uint16_t>(c));
    scale.nearest.push_back(static_cast<std::uint16_t>(c));
    if (c == 0) continue;
    const double middle = light_of_code(response, c - 0.5, code_max);
    const auto reaches = [&](double picture) {
      const double i = device_light(picture, black, black_point);
      return code_of_light(response, i, code_max) >= c - 0.5;
    };
    scale.threshold.push_back(
        detail::first_float(picture_light(middle, black, black_point), reaches));
  }
  keep_distinct(scale);
  return scale;
}

LevelScale table_scale(const Display& display, const Response& response, int code_max,
                       BlackPoint black_point) {
  const LevelTable& table = *display.levels;
  const bool index = display.frame.store == Store::kIndex;
  const std::vector<double> levels = intensity_levels(table);
  const std::vector<int> values = level_codes(table, response, code_max);
  const detail::LevelPositions positions(table);
  const double lowest = levels.front();
  const double black = light_of_code(response, values.front(), code_max);
  LevelScale scale;
  for (int j = 0; j <= table.n; ++j) {
    const int value = values[static_cast<std::size_t>(j)];
    const auto stored = static_cast<std::uint16_t>(index ? j : value);
    const double light = light_of_code(response, value, code_max);
    scale.light.push_back(static_cast<float>(picture_light(light, black, black_point)));
    scale.code.push_back(stored);
    scale.nearest.push_back(stored);
    if (j == 0) continue;
    const double lower = levels[static_cast<std::size_t>(j - 1)];
    const double upper = levels[static_cast<std::size_t>(j)];
    // Picture black is the lowest level, I0, whatever code rounding made of it.
    const auto reaches = [&](double picture) {
      return positions.nearest(device_light(picture, lowest, black_point)) >= j;
    };
    scale.threshold.push_back(
        detail::first_float(picture_light(std::sqrt(lower * upper), lowest, black_point), reaches));
  }
  keep_distinct(scale);
  return scale;
}

}  // namespace

bool is_monochrome(const Display& display) noexcept {
  return display.frame.packing.samples == 1 && !display.frame.packing.indexed;
}

const Response& response_of(const Display& display, int channel) noexcept {
  const auto& own = display.channel_response[static_cast<std::size_t>(channel)];
  return own ? *own : display.response;
}

bool has_one_response(const Display& display) noexcept {
  const auto& own = display.channel_response;
  return !own[0] && !own[1] && !own[2];
}

std::string describe_responses(const Display& display) {
  if (has_one_response(display)) return describe(display.response);
  std::string text;
  for (int c = 0; c < 3; ++c) {
    text += (c > 0 ? "; " : "") + std::string(kChannelNames[c]) + ": ";
    text += describe(response_of(display, c));
  }
  return text;
}

std::vector<int> display_level_codes(const Display& display, int bits, int channel) {
  if (!display.levels) throw std::invalid_argument("display: it has no intensity levels");
  return level_codes(*display.levels, response_of(display, channel), code_max_of(bits));
}

LevelScale level_scale(const Display& display, int bits, BlackPoint black_point, int channel) {
  const Response& response = response_of(display, channel);
  const int code_max = code_max_of(bits);
  return display.levels ? table_scale(display, response, code_max, black_point)
                        : curve_scale(response, code_max, black_point);
}

std::vector<double> light_of_codes(const Display& display, int bits, int channel) {
  const int code_max = code_max_of(bits);
  const bool index = display.levels && display.frame.store == Store::kIndex;
  const std::vector<int> values =
      index ? display_level_codes(display, bits, channel) : std::vector<int>{};
  std::vector<double> light;
  for (int c = 0; c <= code_max; ++c) {
    const auto j = static_cast<std::size_t>(c);
    const int value = index ? values[std::min(j, values.size() - 1)] : c;
    light.push_back(light_of_code(response_of(display, channel), value, code_max));
  }
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
