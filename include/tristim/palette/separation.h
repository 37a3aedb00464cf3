#pragma once

#include <span>
#include <vector>

#include "tristim/color/deficiency.h"
#include "tristim/color/lab.h"
#include "tristim/color/rgb.h"

namespace tristim {

/// Two colours of a palette, by their positions, the smaller first.
struct ColorPair {
  std::size_t first = 0, second = 0;
  double difference = 0;  // CIEDE2000
};

/// Linear sRGB as CIELAB under its white.
Lab lab_of_srgb(Rgb linear_srgb) noexcept;

/// For each colour the one that is nearest to it, the first of equal ones: `first` is the colour
/// itself. Empty for fewer than two. Takes n^2 differences.
std::vector<ColorPair> nearest_others(std::span<const Lab> colors);

/// All pairs that are less than `bound` apart, the nearest first.
std::vector<ColorPair> close_pairs(std::span<const Lab> colors, double bound);

/// Two colours that differ clearly, and not to a colour-deficient observer.
struct Confusion {
  const ColorDeficiency* deficiency = nullptr;
  ColorPair pair;         // to others
  double difference = 0;  // to such an observer, CIEDE2000
};

inline constexpr double kClearDifference = 10;    // CIEDE2000 between colours that nobody mixes up
inline constexpr double kConfusedDifference = 5;  // below it colours on a chart are mixed up

/// All such pairs of the palette, kind by kind, those nearest to such an observer first.
std::vector<Confusion> confusions(std::span<const Rgb> linear_srgb);

/// How much of the colours of sRGB a palette reaches.
struct PaletteCoverage {
  double mixed = 0;     // share of the colours that its entries make when mixed in light, 0 to 1
  double mean = 0;      // CIEDE2000 of a colour to the nearest entry
  double farthest = 0;  // the largest of them
};

/// Over the 4096 colours of 16 equal steps of encoded sRGB a channel. Of more than 64 entries those
/// 64 are mixed that reach farthest out.
PaletteCoverage palette_coverage(std::span<const Rgb> linear_srgb);

}  // namespace tristim
