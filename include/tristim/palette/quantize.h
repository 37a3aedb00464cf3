#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "tristim/palette/histogram.h"

namespace tristim {

/// The `colors` most frequent colours, most frequent first; of equally frequent ones the smaller
/// (r, then g, then b) [Heckbert82].
std::vector<Color8> popularity(const Histogram& histogram, int colors);

/// Boxes around the colours used, each tight, split along its longest side at the median pixel, in
/// the order in which they came into being, until there are `colors` of them; each gives the
/// count-weighted mean of its colours, rounded [Heckbert82]. Ascending in luma.
std::vector<Color8> median_cut(const Histogram& histogram, int colors);

/// 3 bits of red, 3 of green, 2 of blue, index rrrgggbb: always 256 colours, i 255/(2^b - 1)
/// rounded [Shoaff 2.2.10].
std::vector<Color8> fixed_332(const Histogram& histogram, int colors);

/// A way to choose the colours of a palette. All but the fixed one return exactly the picture's
/// colours where those are no more than asked for; none returns more than asked for.
struct PaletteMethod {
  std::string_view name;
  std::vector<Color8> (*choose)(const Histogram& histogram, int colors);
  bool needs_histogram;
  std::string_view source;
};

/// Every method. The command line, the docs and the property tests read this list.
inline constexpr std::array kPaletteMethods{
    PaletteMethod{"popularity", popularity, true, "[Heckbert82]"},
    PaletteMethod{"median-cut", median_cut, true, "[Heckbert82]"},
    PaletteMethod{"fixed-332", fixed_332, false, "[Shoaff 2.2.10]"}};

}  // namespace tristim
