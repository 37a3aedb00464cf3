#include "tristim/palette/guidelines.h"

#include <algorithm>

#include "lib/palette/guideline_rules.h"

namespace tristim {
namespace {

constexpr Guideline kGuidelines[] = {
    {1, "Select colors by some method, such as a smooth curve or a plane in color space.",
     detail::judge_method,
     "root mean square distance in Oklab from the plane that fits best: at "
     "most .03"},
    {2, "Avoid the simultaneous display of highly saturated, spectrally extreme colors.",
     detail::judge_extremes,
     "excitation purity above .6 and dominant wavelengths below 490 and above 590 nm together"},
    {3, "Pure blue should be avoided for text, thin lines, and small shapes.",
     detail::judge_pure_blue,
     "dominant wavelength 430 to 490 nm, excitation purity above .6; a program does not know what "
     "is text"},
    {4, "Avoid adjacent colors that differ only in the amount of blue.", detail::judge_blue_only,
     "L*u*v* distance of neighbours above 5, of which below a tenth is left with the blue made "
     "equal"},
    {5, "Older operators need higher brightness levels to distinguish colors.", nullptr,
     "it depends on who looks"},
    {6, "Colors change in appearance as the ambient light level changes.", nullptr,
     "it depends on the light of the room"},
    {7, "The magnitude of a detectable change in color varies across the spectrum.",
     detail::judge_steps, "CIEDE2000, which allows for it, of any two colors: at least 5"},
    {8, "It is difficult to focus upon edges created by color alone.", detail::judge_edges,
     "contrast ratio of neighbours: at least 1.25 [WCAG2]"},
    {9, "Avoid red and green in the periphery of large-scale displays.", detail::judge_rim,
     "share of strong reds and greens within a tenth of the picture's size from its edges: at most "
     "5 %"},
    {10, "Opponent colors go well together.", detail::judge_opponents,
     "two colors with Oklab hues 150 to 180 degrees apart"},
    {11, "For color-deficient observers, avoid single-color distinctions.",
     detail::judge_deficiency,
     "CIEDE2000 as protanopes, deuteranopes and tritanopes see it of colors that are 10 apart: at "
     "least 5"},
    {12, "Random selection of different hues is usually garish.", detail::judge_many_hues,
     "sixths of the hue circle with colors of chroma above .08 in Oklab: at most 4"},
    {13,
     "If a display contains only a few colors, the complement of one color should be used as the "
     "background.",
     detail::judge_complement_background,
     "up to 8 colors: a hue in Oklab 150 to 180 degrees from the background's"},
    {14, "A neutral (gray) should be used for the background for an image with many colors.",
     detail::judge_neutral_background,
     "more than 8 colors: chroma of the background below .02 in "
     "Oklab"},
    {15, "If two adjoining colors are not harmonious, place thin black border between them.",
     nullptr, "harmony has no agreed measure, and borders are part of the drawing"},
};

}  // namespace

Chart palette_chart(std::vector<ChartColor> colors, std::optional<ChartColor> background) {
  Chart chart{std::move(colors), std::move(background), {}, false};
  for (std::size_t i = 0; i < chart.colors.size(); ++i) {
    for (std::size_t j = i + 1; j < chart.colors.size(); ++j) chart.neighbours.emplace_back(i, j);
  }
  return chart;
}

std::string_view verdict_name(Verdict verdict) noexcept {
  switch (verdict) {
    case Verdict::kPass:
      return "pass";
    case Verdict::kWarn:
      return "warn";
    default:
      return "cannot be judged";
  }
}

std::span<const Guideline> guidelines() noexcept { return kGuidelines; }

Finding judge(const Guideline& guideline, const Chart& chart) {
  if (guideline.judge != nullptr) return guideline.judge(chart);
  return {Verdict::kUnjudged, std::string(guideline.measure), {}};
}

double contrast_ratio(Rgb first, Rgb second) noexcept {
  const auto luminance = [](Rgb c) { return 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b; };
  const double a = luminance(first) + 0.05;
  const double b = luminance(second) + 0.05;
  return std::max(a, b) / std::min(a, b);
}

}  // namespace tristim
