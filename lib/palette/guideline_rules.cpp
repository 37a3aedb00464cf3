#include "lib/palette/guideline_rules.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "lib/core/trigonometry.h"
#include "tristim/color/deficiency.h"
#include "tristim/color/difference.h"
#include "tristim/color/oklab.h"
#include "tristim/color/wavelength.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kFew = 8;  // colours of guidelines 13 and 14

Eigen::Vector3d xyz(Rgb c) {
  static const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  return matrix * Eigen::Vector3d(c.r, c.g, c.b);
}

Lab lab(Rgb c) {
  static const Eigen::Matrix3d matrix = xyz_from_rgb(Primaries{});
  return rgb_to_lab(c, matrix);
}

double luv_distance(Rgb first, Rgb second) {
  const auto luv = [](Rgb c) {
    const Eigen::Vector3d v = xyz(c);
    return xyz_to_luv({v.x(), v.y(), v.z()}, white_xyz(kD65));
  };
  const Luv a = luv(first);
  const Luv b = luv(second);
  return hypotenuse(a.l - b.l, hypotenuse(a.u - b.u, a.v - b.v));
}

DominantWavelength spectral(Rgb c) {
  const Eigen::Vector3d v = xyz(c);
  const Xyy xyy = xyz_to_xyy({v.x(), v.y(), v.z()});
  return dominant_wavelength({xyy.x, xyy.y}, kD65);
}

double chroma(Rgb c) {
  const Oklab ok = linear_srgb_to_oklab(c);
  return hypotenuse(ok.a, ok.b);
}

double hue_deg(Rgb c) {
  const Oklab ok = linear_srgb_to_oklab(c);
  return angle_deg(ok.b, ok.a);
}

double hue_distance(Rgb a, Rgb b) {
  return std::fabs(std::remainder(hue_deg(a) - hue_deg(b), 360));
}

constexpr double kColored = 0.04;  // chroma in Oklab below which a hue says little

Finding pass(std::string text, std::vector<std::pair<std::string, double>> measures = {}) {
  return {Verdict::kPass, std::move(text), std::move(measures)};
}
Finding warn(std::string text, std::vector<std::pair<std::string, double>> measures = {}) {
  return {Verdict::kWarn, std::move(text), std::move(measures)};
}
Finding unjudged(std::string text) { return {Verdict::kUnjudged, std::move(text), {}}; }

std::string both(const ChartColor& a, const ChartColor& b) { return a.name + " and " + b.name; }

// The pair of colours for which `measure` is least, among those for which it is a number.
struct Extreme {
  const ChartColor* first = nullptr;
  const ChartColor* second = nullptr;
  double value = std::numeric_limits<double>::infinity();

  template <typename Measure>
  void offer(const ChartColor& a, const ChartColor& b, Measure&& measure) {
    const double found = measure(a.linear_srgb, b.linear_srgb);
    if (found < value) *this = {&a, &b, found};
  }
};

template <typename Measure>
Extreme least_of_neighbours(const Chart& chart, Measure&& measure) {
  Extreme least;
  for (const auto& [i, j] : chart.neighbours) {
    least.offer(chart.colors[i], chart.colors[j], measure);
  }
  if (chart.background && !chart.has_places) {
    for (const ChartColor& color : chart.colors) least.offer(color, *chart.background, measure);
  }
  return least;
}

template <typename Measure>
Extreme least_of_pairs(const Chart& chart, Measure&& measure) {
  Extreme least;
  for (std::size_t i = 0; i < chart.colors.size(); ++i) {
    for (std::size_t j = i + 1; j < chart.colors.size(); ++j) {
      least.offer(chart.colors[i], chart.colors[j], measure);
    }
  }
  return least;
}

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Finding judge_method(const Chart& chart) {
  const auto n = static_cast<Eigen::Index>(chart.colors.size());
  if (n < 4) return unjudged("three colors always lie in a plane");
  Eigen::MatrixX3d points(n, 3);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Oklab c = linear_srgb_to_oklab(chart.colors[static_cast<std::size_t>(i)].linear_srgb);
    points.row(i) << c.l, c.a, c.b;
  }
  const Eigen::MatrixX3d centred = points.rowwise() - points.colwise().mean();
  const Eigen::Matrix3d covariance = centred.transpose() * centred / static_cast<double>(n);
  const double distance = std::sqrt(
      std::max(0.0, Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvalues()[0]));
  const std::string text = "the colors are " + rounded(distance, 3) + " in Oklab from a plane";
  return distance <= 0.03 ? pass(text, {{"distance", distance}})
                          : warn(text, {{"distance", distance}});
}

Finding judge_extremes(const Chart& chart) {
  const ChartColor* blue = nullptr;
  const ChartColor* red = nullptr;
  double purity = 0;
  for (const ChartColor& color : chart.colors) {
    const DominantWavelength w = spectral(color.linear_srgb);
    if (!(w.excitation_purity > 0.6)) continue;
    purity = std::max(purity, w.excitation_purity);
    if (w.dominant_nm > 0 && w.dominant_nm < 490 && blue == nullptr) blue = &color;
    if (w.dominant_nm > 590 && red == nullptr) red = &color;
  }
  if (blue == nullptr || red == nullptr) {
    return pass("no pure blue together with a pure red", {{"purity", purity}});
  }
  const double blue_nm = spectral(blue->linear_srgb).dominant_nm;
  const double red_nm = spectral(red->linear_srgb).dominant_nm;
  return warn(both(*blue, *red) + ": " + rounded(blue_nm, 4) + " and " + rounded(red_nm, 4) + " nm",
              {{"short_nm", blue_nm}, {"long_nm", red_nm}});
}

Finding judge_pure_blue(const Chart& chart) {
  for (const ChartColor& color : chart.colors) {
    const DominantWavelength w = spectral(color.linear_srgb);
    const bool is_blue = w.dominant_nm >= 430 && w.dominant_nm <= 490;
    if (!is_blue || !(w.excitation_purity > 0.6)) continue;
    return warn(color.name + " is pure blue (" + rounded(w.dominant_nm, 4) + " nm, purity " +
                    rounded(w.excitation_purity, 2) + "): none of it for text and thin lines",
                {{"wavelength_nm", w.dominant_nm}, {"purity", w.excitation_purity}});
  }
  return pass("no pure blue");
}

Finding judge_blue_only(const Chart& chart) {
  const auto rest = [](Rgb a, Rgb b) {
    const double whole = luv_distance(a, b);
    return whole > 5 ? luv_distance({a.r, a.g, b.b}, b) / whole : kNone;
  };
  const Extreme least = least_of_neighbours(chart, rest);
  if (least.first == nullptr) return pass("no neighbours that differ");
  const double whole = luv_distance(least.first->linear_srgb, least.second->linear_srgb);
  const std::string text = both(*least.first, *least.second) + ": " +
                           rounded(100 * least.value, 2) + " % of their L*u*v* distance of " +
                           rounded(whole, 3) + " is not of blue";
  const std::vector<std::pair<std::string, double>> measures{{"luv_distance", whole},
                                                             {"share_without_blue", least.value}};
  return least.value < 0.1 ? warn(text, measures) : pass(text, measures);
}

Finding judge_steps(const Chart& chart) {
  const Extreme least =
      least_of_pairs(chart, [](Rgb a, Rgb b) { return ciede2000(lab(a), lab(b)); });
  if (least.first == nullptr) return unjudged("one color has no difference");
  const std::string text = "the nearest colors, " + both(*least.first, *least.second) + ", are " +
                           rounded(least.value, 3) + " apart in CIEDE2000";
  return least.value >= 5 ? pass(text, {{"ciede2000", least.value}})
                          : warn(text, {{"ciede2000", least.value}});
}

Finding judge_edges(const Chart& chart) {
  const Extreme least = least_of_neighbours(chart, contrast_ratio);
  if (least.first == nullptr) return unjudged("one color has no edges");
  const std::string text = "the least contrast, of " + both(*least.first, *least.second) + ", is " +
                           rounded(least.value, 3) + ":1";
  return least.value >= 1.25 ? pass(text, {{"contrast", least.value}})
                             : warn(text, {{"contrast", least.value}});
}

Finding judge_rim(const Chart& chart) {
  if (!chart.has_places) return unjudged("a palette has no places; give a picture");
  double strong = 0;
  double all = 0;
  for (const ChartColor& color : chart.colors) {
    const double hue = hue_deg(color.linear_srgb);
    const bool red_or_green = (hue < 50 || hue > 345) || (hue > 120 && hue < 165);
    all += static_cast<double>(color.rim);
    if (red_or_green && chroma(color.linear_srgb) > 0.1) strong += static_cast<double>(color.rim);
  }
  const double share = all > 0 ? strong / all : 0;
  const std::string text = rounded(100 * share, 3) + " % of the rim is strong red or green";
  return share <= 0.05 ? pass(text, {{"share", share}}) : warn(text, {{"share", share}});
}

Finding judge_opponents(const Chart& chart) {
  const Extreme nearest = least_of_pairs(chart, [](Rgb a, Rgb b) {
    return chroma(a) > kColored && chroma(b) > kColored ? 180 - hue_distance(a, b) : kNone;
  });
  if (nearest.first == nullptr) return unjudged("there are no two colors with a hue");
  const double apart = 180 - nearest.value;
  const std::string text =
      both(*nearest.first, *nearest.second) + " are " + rounded(apart, 3) + " degrees of hue apart";
  return apart >= 150 ? pass(text, {{"hue_deg", apart}})
                      : warn("no opponents: " + text, {{"hue_deg", apart}});
}

Finding judge_deficiency(const Chart& chart) {
  Finding finding = pass("");
  for (const ColorDeficiency& deficiency : kColorDeficiencies) {
    const Extreme least = least_of_neighbours(chart, [&](Rgb a, Rgb b) {
      if (ciede2000(lab(a), lab(b)) < 10) return kNone;
      return ciede2000(lab(simulate_deficiency(a, deficiency)),
                       lab(simulate_deficiency(b, deficiency)));
    });
    if (least.first == nullptr) continue;
    if (!finding.text.empty()) finding.text += "; ";
    finding.text += std::string(deficiency.name) + ": " + both(*least.first, *least.second) +
                    " are " + rounded(least.value, 3) + " apart";
    finding.measures.emplace_back(deficiency.name, least.value);
    if (least.value < 5) finding.verdict = Verdict::kWarn;
  }
  if (finding.text.empty()) return unjudged("there are no two colors that differ clearly");
  return finding;
}

Finding judge_many_hues(const Chart& chart) {
  std::set<int> sixths;
  for (const ChartColor& color : chart.colors) {
    if (chroma(color.linear_srgb) <= 0.08) continue;
    sixths.insert(static_cast<int>(hue_deg(color.linear_srgb) / 60));
  }
  const std::string text =
      "strong colors in " + std::to_string(sixths.size()) + " of 6 parts of the hue circle";
  const double count = static_cast<double>(sixths.size());
  return count <= 4 ? pass(text, {{"parts", count}}) : warn(text, {{"parts", count}});
}

Finding judge_complement_background(const Chart& chart) {
  if (chart.colors.size() > kFew) return unjudged("there are more than 8 colors: see 14");
  if (!chart.background) return unjudged("the background is not known; give --background");
  const Rgb background = chart.background->linear_srgb;
  if (chroma(background) <= kColored) {
    return warn("the background has no hue", {{"chroma", chroma(background)}});
  }
  double farthest = 0;
  for (const ChartColor& color : chart.colors) {
    if (chroma(color.linear_srgb) <= kColored) continue;
    farthest = std::max(farthest, hue_distance(color.linear_srgb, background));
  }
  const std::string text =
      "the hue farthest from the background's is " + rounded(farthest, 3) + " degrees from it";
  return farthest >= 150 ? pass(text, {{"hue_deg", farthest}})
                         : warn(text, {{"hue_deg", farthest}});
}

Finding judge_neutral_background(const Chart& chart) {
  if (chart.colors.size() <= kFew) return unjudged("there are at most 8 colors: see 13");
  if (!chart.background) return unjudged("the background is not known; give --background");
  const double c = chroma(chart.background->linear_srgb);
  const std::string text = "the background's chroma in Oklab is " + rounded(c, 2);
  return c < 0.02 ? pass(text, {{"chroma", c}}) : warn(text, {{"chroma", c}});
}

}  // namespace tristim::detail
