#include "tristim/color/munsell.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lib/color/munsell_slice.h"
#include "tristim/color/illuminant.h"
#include "tristim/color/macadam.h"
#include "tristim/color/munsell_value.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kNeutral = 1e-6;  // chroma below it is what rounding leaves
constexpr double kHues = 100;

bool equal(double a, double b) noexcept { return a == b || (std::isnan(a) && std::isnan(b)); }

// [0, 40), of any finite hue.
double column_of(double hue) noexcept {
  double column = std::fmod(hue, kHues) / detail::kMunsellHueStep - 1;
  if (column < 0) column += detail::kMunsellColumns;
  return column < detail::kMunsellColumns ? column : 0;
}

double hue_of(double column) noexcept {
  const double hue = std::fmod((column + 1) * detail::kMunsellHueStep, kHues);
  return hue > 0 ? hue : hue + kHues;
}

// Made when the first colour asks for it: that takes a while.
const OptimalColors& optimal_colors_c() {
  static const OptimalColors colors = optimal_colors(*find_by_name(illuminants(), "c"));
  return colors;
}

}  // namespace

bool same(Munsell a, Munsell b) noexcept {
  return equal(a.hue, b.hue) && equal(a.value, b.value) && equal(a.chroma, b.chroma);
}

Xyy munsell_to_xyy(Munsell munsell) noexcept {
  const double luminance = luminance_from_munsell_value(munsell.value);
  if (munsell.chroma == 0 && !std::isnan(luminance)) {
    return {kMunsellWhite.x, kMunsellWhite.y, luminance};
  }
  constexpr Xyy kNoColor{kNone, kNone, kNone};
  const double ring = munsell.chroma / detail::kMunsellChromaStep;
  if (std::isnan(luminance) || !std::isfinite(munsell.hue)) return kNoColor;
  if (!(ring >= 0 && ring <= detail::kMunsellRings)) return kNoColor;
  const auto position =
      detail::MunsellSlice(munsell.value, luminance).position({column_of(munsell.hue), ring});
  return position ? Xyy{position->x(), position->y(), luminance} : kNoColor;
}

Munsell xyy_to_munsell(Xyy xyy) noexcept {
  const double value = munsell_value_from_luminance(xyy.luminance);
  if (value == 0) return {kNone, 0, 0};
  constexpr Munsell kNoColor{kNone, kNone, kNone};
  const Eigen::Vector2d position(xyy.x, xyy.y);
  const Eigen::Vector2d offset = position - detail::munsell_center();
  if (std::isnan(value) || !std::isfinite(offset.squaredNorm())) return kNoColor;
  if (offset.norm() < 1e-12) return {kNone, value, 0};
  const detail::MunsellSlice slice(value, xyy.luminance);
  const auto place = slice.locate(position);
  if (!place || !(slice.is_real(*place) || optimal_colors_c().contains(xyy))) return kNoColor;
  const double chroma = place->ring * detail::kMunsellChromaStep;
  if (chroma < kNeutral) return {kNone, value, 0};
  return {hue_of(place->column), value, chroma};
}

double munsell_largest_chroma(double hue, double value) noexcept {
  if (!(value >= 0 && value <= 10) || !std::isfinite(hue)) return kNone;
  const detail::MunsellSlice slice(value, luminance_from_munsell_value(value));
  const double place = column_of(hue);
  const int column = static_cast<int>(place);
  const int rings = place > column ? slice.cell_rings(column) : slice.rings(column);
  return rings * detail::kMunsellChromaStep;
}

std::string munsell_refusal(Munsell munsell) {
  if (!std::isnan(munsell_to_xyy(munsell).luminance)) return {};
  if (!(munsell.value >= 0 && munsell.value <= 10)) {
    return "Munsell value " + shortest(munsell.value) + " is not between 0 and 10";
  }
  if (!std::isfinite(munsell.hue)) return "a Munsell colour with chroma needs a hue";
  if (!(munsell.chroma >= 0)) return "Munsell chroma " + shortest(munsell.chroma) + " is below 0";
  return "Munsell chroma " + shortest(munsell.chroma) +
         " is beyond the renotation, which ends at " +
         shortest(munsell_largest_chroma(munsell.hue, munsell.value)) + " there";
}

std::string munsell_refusal(Xyy xyy) {
  if (!std::isnan(xyy_to_munsell(xyy).value)) return {};
  if (std::isnan(munsell_value_from_luminance(xyy.luminance))) {
    return "Y " + shortest(xyy.luminance) + " is not between 0 and 1";
  }
  if (!(std::isfinite(xyy.x) && std::isfinite(xyy.y))) return "it has no chromaticity";
  const double limit = optimal_colors_c().limit({xyy.x, xyy.y});
  if (xyy.luminance <= limit) return "the Munsell renotation does not reach so far";
  return "it lies outside the MacAdam limits of illuminant C: at x " + rounded(xyy.x, 4) +
         " and y " + rounded(xyy.y, 4) + " Y is " + rounded(limit, 4) + " at the most, not " +
         rounded(xyy.luminance, 4);
}

}  // namespace tristim
