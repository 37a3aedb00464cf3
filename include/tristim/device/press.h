#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tristim/color/cmyk.h"
#include "tristim/color/rgb.h"
#include "tristim/device/dot_gain.h"

namespace tristim {

/// An ink of a press.
struct Ink {
  std::string name;
  Rgb light;  // of the solid, in linear RGB of the device's primaries relative to the paper, (0, 1]
};

/// How the areas of inks are found.
enum class SeparationRule {
  kMeasured,    ///< so that the model of the press (printed_light) gives the colour
  kNormalised,  ///< cmy_to_cmyk_normalised of light: right for ideal inks
  kSubtract,    ///< cmy_to_cmyk_subtract of light: the document's
};

struct NamedSeparation {
  std::string_view name;
  SeparationRule rule;
};
inline constexpr NamedSeparation kSeparations[] = {{"measured", SeparationRule::kMeasured},
                                                   {"normalised", SeparationRule::kNormalised},
                                                   {"subtract", SeparationRule::kSubtract}};

/// Several inks on one sheet: any single one, or cyan, magenta and yellow with black or without, in
/// any order. The code of a dot is the sum of 2^i of the inks on it.
struct Press {
  std::vector<Ink> inks;           // 1 to 8
  std::vector<double> angles_deg;  // of their screens; empty: usual_angles
  SeparationRule rule = SeparationRule::kMeasured;
  BlackGeneration black;
};

/// Light of a tint, relative to the paper: where dots of inks fall on one another by chance
/// [Demichel24] and each lets through its share, light is the product of 1 - a (1 - ink), the
/// [Neugebauer37] equations with multiplied overprints. `areas`: those that seem covered, by ink.
Rgb printed_light(std::span<const Ink> inks, std::span<const double> areas) noexcept;

/// The darkest that a press prints on purpose: its black ink solid, or all inks where it has none.
Rgb darkest_print(const Press& press) noexcept;

/// Light to areas of inks.
class Separation {
 public:
  /// Throws std::invalid_argument for inks that it does not know.
  explicit Separation(const Press& press, bool relative_black = true);

  /// Picture light, linear RGB in [0, 1] of the device's primaries, to the area that each ink shall
  /// seem to cover, [0, 1]. With `relative_black` picture black is the darkest print, else the
  /// absence of light. What the inks can mix within the limit is right to 1e-5 of light by the
  /// measured rule; other colours get the areas whose light is nearest in squares.
  void areas(const Rgb& light, std::span<double> inks) const noexcept;

 private:
  Cmyk measured(const Rgb& light) const noexcept;

  Press press_;
  std::array<int, 4> place_{};  // of cyan, magenta, yellow, black among the inks; -1: none
  std::array<std::array<double, 3>, 4> absorbed_{};  // 1 - light of the solids, by that order
  std::array<double, 3> black_{};                    // light that stands for picture black
};

}  // namespace tristim
