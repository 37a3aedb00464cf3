#pragma once

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "tristim/palette/histogram.h"
#include "tristim/palette/metric.h"
#include "tristim/palette/remap.h"

namespace tristim {

/// In what order the colours of a palette come.
enum class PaletteOrder {
  kFound,       ///< as the method gives them
  kLuminance,   ///< dark to light; of equal ones ascending in r, g, b, a
  kHue,         ///< greys dark to light, then by hue from red on
  kPopularity,  ///< those with most pixels nearest to them first; of equal ones as kLuminance
};

struct NamedPaletteOrder {
  std::string_view name;
  PaletteOrder order;
};
inline constexpr std::array kPaletteOrders{
    NamedPaletteOrder{"found", PaletteOrder::kFound},
    NamedPaletteOrder{"luminance", PaletteOrder::kLuminance},
    NamedPaletteOrder{"hue", PaletteOrder::kHue},
    NamedPaletteOrder{"popularity", PaletteOrder::kPopularity}};

namespace detail {
struct ColorCells;
}

/// What a palette method is asked.
struct PaletteTask {
  std::span<const Histogram::Entry> entries;  // more than `colors`; in the method's order
  int colors = 0;                             // to be chosen, 1 or more
  const Metric* metric = nullptr;             // where methods that measure do so
  std::span<const Color8> fixed;              // in the palette whatever is chosen
  std::array<int, 3> bits{};                  // of a fixed palette; 0: as `colors` allows
  std::vector<Color8> inks;                   // on white paper
  const detail::ColorCells* cells = nullptr;  // `entries` with their places, where they are known
};

/// A way to choose the colours of a palette: at most `task.colors`, all distinct. Ties go to the
/// smaller colour (r, then g, then b, then a), between boxes to the one that came first.
struct PaletteMethod {
  std::string_view name;
  std::vector<Color8> (*choose)(const PaletteTask& task);
  bool needs_histogram;  // not: the same colours for every picture
  std::string_view source;
  int always = 0;           // the colours that it has whatever is asked for; 0: no more than asked
  bool neighbours = false;  // takes entries in the order of Histogram::neighbours(), else ascending
};

/// The most frequent colours, most frequent first [Heckbert82].
std::vector<Color8> choose_popularity(const PaletteTask& task);

/// Boxes around the colours used, each tight, split along its longest side at the median pixel, in
/// the order in which they came into being; each gives the count-weighted mean of its colours,
/// rounded. Measures in codes. Ascending in luma [Heckbert82].
std::vector<Color8> choose_median_cut(const PaletteTask& task);

/// `bits` of red, green and blue, index rrrgggbb: i 255/(2^b - 1) rounded [Shoaff 2.2.10]. Without
/// `bits` as many as fit, green before red before blue.
std::vector<Color8> choose_fixed(const PaletteTask& task);
/// Always 3, 3 and 2 bits: 256 colours.
std::vector<Color8> choose_fixed_332(const PaletteTask& task);
/// The largest cube of n x n x n colours in equal steps, and greys between with what is left.
std::vector<Color8> choose_uniform(const PaletteTask& task);

/// Tones of one ink on white paper, of two (duotone) or three (tritone): the first in all tones,
/// each further one as a higher power deeper in the shadows; inks over each other multiply
/// [Demichel24]. From all of every ink to paper in equal steps of the cube root of luminance.
std::vector<Color8> choose_inks(const PaletteTask& task);

/// Cuts of sets of colours in two, in the metric. They differ in the set that is cut next and
/// where. The set of the largest variance, along the axis of the largest, where that gains most
/// [Wan90].
std::vector<Color8> choose_variance_cut(const PaletteTask& task);
/// Likewise across the principal axis of the set [Orchard91].
std::vector<Color8> choose_principal_cut(const PaletteTask& task);
/// The cut that gains most of all sets and axes [Wu92].
std::vector<Color8> choose_wu(const PaletteTask& task);

/// A tree that halves each channel at each level; the rarest of the deepest branches are merged
/// until few enough leaves are left [Gervautz88].
std::vector<Color8> choose_octree(const PaletteTask& task);

/// principal-cut, then means of what is nearest, over and over [Lloyd82].
std::vector<Color8> choose_k_means(const PaletteTask& task);

/// Within a hundredth of the error of choose_k_means in a fraction of its time, and less of it
/// where colours are few; docs/palettes.md says how.
std::vector<Color8> choose_best(const PaletteTask& task);

/// Every method. The command line, the docs and the property tests read this list.
inline constexpr std::array kPaletteMethods{
    PaletteMethod{"best", choose_best, true, "docs/palettes.md", 0, true},
    PaletteMethod{"popularity", choose_popularity, true, "[Heckbert82]"},
    PaletteMethod{"median-cut", choose_median_cut, true, "[Heckbert82]"},
    PaletteMethod{"variance-cut", choose_variance_cut, true, "[Wan90]"},
    PaletteMethod{"principal-cut", choose_principal_cut, true, "[Orchard91]"},
    PaletteMethod{"wu", choose_wu, true, "[Wu92]"},
    PaletteMethod{"octree", choose_octree, true, "[Gervautz88]"},
    PaletteMethod{"k-means", choose_k_means, true, "[Lloyd82]", 0, true},
    PaletteMethod{"fixed-332", choose_fixed_332, false, "[Shoaff 2.2.10]", 256},
    PaletteMethod{"fixed", choose_fixed, false, "[Shoaff 2.2.10]"},
    PaletteMethod{"uniform", choose_uniform, false, "a cube and a grey ramp"},
    PaletteMethod{"inks", choose_inks, false, "[Demichel24]"}};

/// The most entries of a palette.
inline constexpr int kMostColors = 65536;

/// What a palette is to be.
struct PaletteOptions {
  int colors = 256;  // with the fixed ones and the transparent entry; 1 to kMostColors
  const Metric* metric = nullptr;             // nullptr: kMetrics' "balanced"
  std::vector<Color8> fixed;                  // at indices 0, 1, ... whatever the picture
  std::optional<int> transparent;             // index of an entry of alpha 0 that no colour takes
  PaletteOrder order = PaletteOrder::kFound;  // of those that are not fixed
  std::array<int, 3> bits{};                  // of `fixed`, 0 to 8 each, together at most 16
  std::vector<Color8> inks{{0, 0, 0}};        // of `inks`, one to three
};

/// A palette for all that `histogram` counted: at most `options.colors` colours. Where the
/// histogram has no more colours than that leaves room for, exactly those, ascending. Else what
/// `method` chooses. Of an empty histogram nothing but what is fixed. A transparent index beyond
/// the colours is reached by repeating the last one, which nothing takes then.
///
/// Merged histograms give the same palette in whatever order they were merged. Throws
/// std::invalid_argument where colours are not in 1..kMostColors, where there are more fixed ones,
/// where the transparent index is that of a fixed one or not below colours, and for a fixed
/// method's palette of more than colours, and for no ink or more than three.
std::vector<Color8> build_palette(const Histogram& histogram, const PaletteMethod& method,
                                  const PaletteOptions& options);

/// A palette and where its picture's colours go.
struct Quantized {
  std::vector<Color8> palette;
  PaletteMap map;
};

/// build_palette() and the map to its colours in the same metric, with less work than both take.
/// Throws as they do.
Quantized quantize(const Histogram& histogram, const PaletteMethod& method,
                   const PaletteOptions& options);

}  // namespace tristim
