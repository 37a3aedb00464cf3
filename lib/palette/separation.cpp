#include "tristim/palette/separation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "tristim/color/difference.h"
#include "tristim/color/primaries.h"
#include "tristim/color/transfer.h"
#include "tristim/palette/hull.h"

namespace tristim {
namespace {

constexpr int kSteps = 16;              // of a channel
constexpr float kMixTolerance = 1e-5F;  // of light

std::vector<Lab> labs_of(std::span<const Rgb> colors) {
  std::vector<Lab> labs;
  for (const Rgb& c : colors) labs.push_back(lab_of_srgb(c));
  return labs;
}

void sort_by_difference(std::vector<ColorPair>& pairs) {
  std::ranges::stable_sort(pairs, {}, &ColorPair::difference);
}

PaletteHull::Color float_color(const Rgb& c) {
  return {static_cast<float>(c.r), static_cast<float>(c.g), static_cast<float>(c.b)};
}

// The entry that lies farthest in each of many directions, spread evenly over the sphere by the
// golden angle.
std::vector<PaletteHull::Color> outermost(std::span<const Rgb> colors) {
  std::vector<PaletteHull::Color> all;
  for (const Rgb& c : colors) all.push_back(float_color(c));
  if (all.size() <= PaletteHull::kMost) return all;
  constexpr double kGoldenAngle = 2.39996322972865332;
  std::set<std::size_t> chosen;
  for (std::size_t i = 0; i < PaletteHull::kMost; ++i) {
    const double z = 1 - (2 * static_cast<double>(i) + 1) / double{PaletteHull::kMost};
    const double r = std::sqrt(1 - z * z);
    const double angle = kGoldenAngle * static_cast<double>(i);
    const std::array<double, 3> direction{r * std::cos(angle), r * std::sin(angle), z};
    const auto reach = [&](const Rgb& c) {
      return direction[0] * c.r + direction[1] * c.g + direction[2] * c.b;
    };
    const auto farthest = std::ranges::max_element(colors, {}, reach);
    chosen.insert(static_cast<std::size_t>(farthest - colors.begin()));
  }
  std::vector<PaletteHull::Color> outer;
  for (const std::size_t i : chosen) outer.push_back(all[i]);
  return outer;
}

bool is_inside(const PaletteHull& hull, const PaletteHull::Color& color) {
  const PaletteHull::Color inside = hull.inside(color);
  for (std::size_t c = 0; c < 3; ++c) {
    if (std::fabs(inside[c] - color[c]) > kMixTolerance) return false;
  }
  return true;
}

}  // namespace

Lab lab_of_srgb(Rgb linear_srgb) noexcept {
  static const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  return rgb_to_lab(linear_srgb, matrix);
}

std::vector<ColorPair> nearest_others(std::span<const Lab> colors) {
  std::vector<ColorPair> nearest;
  if (colors.size() < 2) return nearest;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    nearest.push_back({i, i, std::numeric_limits<double>::infinity()});
  }
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (std::size_t k = i + 1; k < colors.size(); ++k) {
      const double difference = ciede2000(colors[i], colors[k]);
      if (difference < nearest[i].difference) nearest[i] = {i, k, difference};
      if (difference < nearest[k].difference) nearest[k] = {k, i, difference};
    }
  }
  return nearest;
}

std::vector<ColorPair> close_pairs(std::span<const Lab> colors, double bound) {
  std::vector<ColorPair> pairs;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    for (std::size_t k = i + 1; k < colors.size(); ++k) {
      const double difference = ciede2000(colors[i], colors[k]);
      if (difference < bound) pairs.push_back({i, k, difference});
    }
  }
  sort_by_difference(pairs);
  return pairs;
}

std::vector<Confusion> confusions(std::span<const Rgb> linear_srgb) {
  const std::vector<Lab> labs = labs_of(linear_srgb);
  std::vector<Confusion> all;
  for (const ColorDeficiency& deficiency : kColorDeficiencies) {
    std::vector<Lab> seen;
    for (const Rgb& c : linear_srgb)
      seen.push_back(lab_of_srgb(simulate_deficiency(c, deficiency)));
    for (const ColorPair& pair : close_pairs(seen, kConfusedDifference)) {
      const double to_others = ciede2000(labs[pair.first], labs[pair.second]);
      if (to_others < kClearDifference) continue;
      all.push_back({&deficiency, {pair.first, pair.second, to_others}, pair.difference});
    }
  }
  return all;
}

PaletteCoverage palette_coverage(std::span<const Rgb> linear_srgb) {
  const std::vector<Lab> labs = labs_of(linear_srgb);
  const PaletteHull hull(outermost(linear_srgb));
  PaletteCoverage coverage;
  const auto light = [](int step) { return srgb_decode(step / double{kSteps - 1}); };
  for (int i = 0; i < kSteps * kSteps * kSteps; ++i) {
    const Rgb color{light(i / kSteps / kSteps), light(i / kSteps % kSteps), light(i % kSteps)};
    coverage.mixed += is_inside(hull, float_color(color)) ? 1 : 0;
    const Lab lab = lab_of_srgb(color);
    double least = std::numeric_limits<double>::infinity();
    for (const Lab& entry : labs) least = std::min(least, ciede2000(lab, entry));
    coverage.mean += least;
    coverage.farthest = std::max(coverage.farthest, least);
  }
  coverage.mixed /= kSteps * kSteps * kSteps;
  coverage.mean /= kSteps * kSteps * kSteps;
  return coverage;
}

}  // namespace tristim
