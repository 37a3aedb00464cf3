#include "lib/pipeline/screen_settings.h"
#include "lib/pipeline/setting_values.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

Result set_positive(double& number, std::string_view what, std::string_view value,
                    std::string_view remedy) {
  const auto given = parse_number(value);
  if (!given || !(*given > 0) || !std::isfinite(*given)) return not_a(what, value, remedy);
  number = *given;
  return {};
}

Result set_lpi(Settings& settings, std::string_view value) {
  return set_positive(settings.dither_parameters.screen.lpi, "ruling", value,
                      "give lines an inch, as in --lpi 85");
}

Result set_dpi(Settings& settings, std::string_view value) {
  return set_positive(settings.dither_parameters.screen.dpi, "resolution", value,
                      "give dots an inch, as in --dpi 600");
}

Result set_angles(Settings& settings, std::string_view value) {
  std::vector<double> angles;
  for (const std::string_view part : split(value, ',')) {
    const auto angle = parse_number(part);
    if (!angle || !std::isfinite(*angle)) {
      return not_a("angle", part, "give degrees, one or one for each channel: 45 or 15,75,0,45");
    }
    angles.push_back(*angle);
  }
  settings.dither_parameters.screen.angles_deg = angles;
  return {};
}

Result set_smallest_dot(Settings& settings, std::string_view value) {
  const auto dots = parse_integer(value);
  if (!dots || *dots < 1 || *dots > 10000) {
    return not_a("size of a dot", value, "give the device dots of the smallest dot, 1 or more");
  }
  settings.dither_parameters.screen.smallest_dot = static_cast<int>(*dots);
  return {};
}

Result set_single_cell(Settings& settings, std::string_view value) {
  return set_switch(value, [&](bool on) { settings.dither_parameters.screen.single_cell = on; });
}

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

// "cell.png": behind the last dot stands a letter, where a number has a digit.
bool names_a_picture(std::string_view value) {
  const std::size_t dot = value.rfind('.');
  return dot != std::string_view::npos && dot + 1 < value.size() && is_letter(value[dot + 1]);
}

// One word that is no variable: the name of a spot, however it is spelled.
bool is_word(std::string_view value) {
  return value.size() > 1 &&
         std::all_of(value.begin(), value.end(),
                     [](char c) { return is_letter(c) || c == '-' || c == '_'; }) &&
         is_letter(value.front()) && is_letter(value.back()) &&
         value.find('x') == std::string_view::npos && value.find('y') == std::string_view::npos;
}

Result set_spot(Settings& settings, std::string_view value) {
  ScreenParameters& screen = settings.dither_parameters.screen;
  settings.spot_picture.clear();
  if (const SpotFunction* named = find_by_name(kSpotFunctions, value)) {
    screen.spot = *named;
    return {};
  }
  if (names_a_picture(value)) {
    settings.spot_picture = std::string(value);
    return {};
  }
  if (is_word(value)) {
    return Refusal{"unknown spot '" + std::string(value) + "'", name_hint(kSpotFunctions, value)};
  }
  try {
    const Spot spot = Formula(value);
    check_spot(spot);
    screen.spot = spot;
  } catch (const std::invalid_argument& wrong) {
    return Refusal{wrong.what(), "give one of " + list_names(kSpotFunctions) +
                                     ", a picture, or a formula: 'cos(pi*x) + cos(pi*y)'"};
  }
  return {};
}

}  // namespace

std::vector<Setting> screen_settings() {
  return {
      {"lpi", "L",
       "ruling of a screen, lines an inch; default: the device's, else the finest up to 150 whose "
       "cells at 45 degrees lie on whole dots: 53 at 300 dpi, 106 at 600",
       set_lpi},
      {"angle", "DEG[,DEG...]",
       "of a screen, counterclockwise, one or one for each channel; default: 45, colours "
       "15,75,0,45",
       set_angles},
      {"spot", list_names(kSpotFunctions, "|") + "|FORMULA|PICTURE",
       "how its dots grow: larger values in x and y from -1 to 1 are inked first; default: "
       "euclidean",
       set_spot},
      {"smallest-dot", "N", "device dots that come together; default: 1, of a hybrid-screen 4",
       set_smallest_dot},
      {"single-cell", "",
       "one cell of whole dots (rational tangent) instead of a supercell, whatever angle that has",
       set_single_cell},
      {"dpi", "D", "dots an inch, for the ruling; default: the device's, else 600", set_dpi},
  };
}

}  // namespace tristim::detail
