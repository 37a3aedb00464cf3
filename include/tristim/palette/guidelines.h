#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tristim/color/rgb.h"

namespace tristim {

/// A colour of a chart or a picture.
struct ChartColor {
  std::string name;         // as messages call it: "#ff0000"
  Rgb linear_srgb;          // [0, 1]
  std::uint64_t count = 0;  // pixels; 0 where there is no picture
  std::uint64_t rim = 0;    // pixels within a tenth of the picture's size from its edges
};

/// Colours that are shown together.
struct Chart {
  std::vector<ChartColor> colors;
  std::optional<ChartColor> background;
  /// Indices of colours that touch; of a palette, which has no places, every pair.
  std::vector<std::pair<std::size_t, std::size_t>> neighbours;
  bool has_places = false;  // a picture's
};

/// A chart of colours alone, each a neighbour of each.
Chart palette_chart(std::vector<ChartColor> colors, std::optional<ChartColor> background);

enum class Verdict { kPass, kWarn, kUnjudged };

/// "pass", "warn", "cannot be judged".
std::string_view verdict_name(Verdict verdict) noexcept;

/// What a guideline says about a chart.
struct Finding {
  Verdict verdict = Verdict::kUnjudged;
  std::string text;  // what was found, or why it cannot be judged
  std::vector<std::pair<std::string, double>> measures;
};

/// One of the guidelines for colour [Shoaff 2.2.11].
struct Guideline {
  int number;
  std::string_view text;
  Finding (*judge)(const Chart& chart);  // nullptr: no program can
  std::string_view measure;              // or why no program can
};

/// All 15, in their order. The command line, the docs and the tests read this list.
std::span<const Guideline> guidelines() noexcept;

/// The finding of one guideline.
Finding judge(const Guideline& guideline, const Chart& chart);

/// (Y1 + .05)/(Y2 + .05) of the relative luminances, the larger above [WCAG2]; 1 to 21.
double contrast_ratio(Rgb first, Rgb second) noexcept;

}  // namespace tristim
