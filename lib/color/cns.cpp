#include "tristim/color/cns.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "tristim/color/primaries.h"

namespace tristim {
namespace {

constexpr CnsHue kHues[] = {
#include "luts/cns_hues.csv"
};
constexpr int kHueCount = static_cast<int>(std::size(kHues));
constexpr int kRing = 24;
constexpr int kLevels = 5;
constexpr int kSaturations = 4;

// docs/color-names.md reasons for the numbers below.

// Munsell hues of red, orange, yellow, green, blue, purple, and red again.
constexpr std::array kGenericHues{7.5, 15.0, 30.0, 40.0, 77.5, 87.5, 107.5};

// Values at which a lightness gives way to the next, from where names of a hue begin to where they
// end, and the values that stand for them.
struct Lightness {
  std::array<double, kLevels> begin, anchor;
};
constexpr Lightness kLightness{{0, 2, 4, 6, 8}, {1.5, 3, 5, 7, 8.25}};

// From red over orange to yellow, where browns take the dark end: orange and its two neighbours,
// the halfway hues, the hues next to red and yellow. Names of the browns end where these begin.
constexpr std::array<Lightness, 3> kBrightLightness{{
    {{5, 5.5, 6, 7.5, 8.5}, {5.25, 5.75, 6.75, 8, 8.75}},
    {{4.25, 4.75, 5.5, 7, 8.25}, {4.5, 5.125, 6.25, 7.625, 8.45}},
    {{3.5, 4, 5, 6.5, 8}, {3.75, 4.5, 5.75, 7.25, 8.25}},
}};
// Of the browns, as fractions of the value where they end.
constexpr Lightness kBrownLightness{{0, 0.3, 0.5, 0.8, 0.9}, {0.25, 0.4, 0.65, 0.85, 0.95}};

// Value at which black, very dark gray, ... begin.
constexpr std::array kGrayBegin{0.0, 1.0, 2.0, 4.0, 6.0, 8.0, 9.5};
constexpr std::array kGrayAnchor{0.0, 1.5, 3.0, 5.0, 7.0, 8.75, 10.0};

// Chroma relative to the largest that sRGB has at the anchor of hue and lightness.
constexpr std::array kSaturationBegin{0.0, 0.25, 0.5, 0.75};
constexpr std::array kSaturationAnchor{0.21, 0.375, 0.625, 0.875};
constexpr double kNeutralRatio = 1.0 / 12;
constexpr double kNeutralChroma = 0.5;

template <std::size_t N>
int step_of(const std::array<double, N>& begin, double x) noexcept {
  return static_cast<int>(std::upper_bound(begin.begin() + 1, begin.end(), x) - begin.begin()) - 1;
}

Lightness scaled(const Lightness& lightness, double factor) {
  Lightness result = lightness;
  for (double& value : result.begin) value *= factor;
  for (double& value : result.anchor) value *= factor;
  return result;
}

Lightness lightness_of(const CnsHue& hue) {
  if (hue.quarter <= 0 || hue.quarter >= 8) return kLightness;
  const int from_orange = std::abs(hue.quarter - 4);
  const Lightness& bright =
      kBrightLightness[static_cast<std::size_t>(std::max(from_orange - 1, 0))];
  return hue.brown ? scaled(kBrownLightness, bright.begin[0]) : bright;
}

double munsell_hue(int quarter) {
  const auto generic = static_cast<std::size_t>(quarter / 4);
  const double fraction = (quarter % 4) / 4.0;
  const double hue =
      kGenericHues[generic] + fraction * (kGenericHues[generic + 1] - kGenericHues[generic]);
  return hue > 100 ? hue - 100 : hue;
}

// The nearest quarter step of a Munsell hue.
int quarter_of(double hue) noexcept {
  const double turned = std::fmod(hue - kGenericHues[0], 100);
  const double number = kGenericHues[0] + (turned < 0 ? turned + 100 : turned);
  std::size_t generic = 0;
  while (generic < 5 && number >= kGenericHues[generic + 1]) ++generic;
  const double fraction =
      (number - kGenericHues[generic]) / (kGenericHues[generic + 1] - kGenericHues[generic]);
  return (4 * static_cast<int>(generic) + static_cast<int>(std::floor(4 * fraction + 0.5))) % kRing;
}

// The largest chroma that sRGB has at a hue and a value, illuminant C in place of its white.
double srgb_chroma(double hue, double value) {
  static const Eigen::Matrix3d matrix =
      (adaptation_matrix(kD65, kMunsellWhite, Adaptation::kBradford) * xyz_from_rgb(Primaries{}))
          .inverse();
  double inside = 0;
  double outside = munsell_largest_chroma(hue, value);
  for (int i = 0; i < 24; ++i) {  // to a millionth
    const double chroma = (inside + outside) / 2;
    const Xyz xyz = xyy_to_xyz(munsell_to_xyy({hue, value, chroma}));
    const Eigen::Vector3d rgb = matrix * Eigen::Vector3d(xyz.x, xyz.y, xyz.z);
    (rgb.minCoeff() >= 0 && rgb.maxCoeff() <= 1 ? inside : outside) = chroma;
  }
  return inside;
}

// What a hue's names are told by.
struct Anchors {
  double hue;
  Lightness lightness;
  std::array<double, kLevels> chroma;  // the largest of sRGB
};

Anchors make_anchors(const CnsHue& hue) {
  Anchors anchors{munsell_hue(hue.quarter), lightness_of(hue), {}};
  for (std::size_t i = 0; i < kLevels; ++i) {
    anchors.chroma[i] = srgb_chroma(anchors.hue, anchors.lightness.anchor[i]);
  }
  return anchors;
}

const Anchors& anchors_of(int hue) {
  static const auto all = [] {
    std::array<Anchors, kHueCount> anchors;
    std::transform(std::begin(kHues), std::end(kHues), anchors.begin(), make_anchors);
    return anchors;
  }();
  return all[static_cast<std::size_t>(hue)];
}

// The hue of a colour: one of the ring, or the brown of the same position below its names.
int hue_of(const Munsell& munsell) {
  const int quarter = quarter_of(munsell.hue);
  const bool dark = munsell.value < anchors_of(quarter).lightness.begin[0];
  return dark ? kRing + quarter - 1 : quarter;
}

CnsName gray_of(double value) { return {step_of(kGrayBegin, value) - 1, 0, std::nullopt}; }

}  // namespace

std::span<const CnsHue> cns_hues() noexcept { return kHues; }

std::vector<CnsName> cns_names() {
  std::vector<CnsName> names;
  for (int hue = 0; hue < kHueCount; ++hue) {
    for (int lightness = 0; lightness < kLevels; ++lightness) {
      for (int saturation = 0; saturation < kSaturations; ++saturation) {
        names.push_back({lightness, saturation, hue});
      }
    }
  }
  for (int lightness = -1; lightness <= kLevels; ++lightness) {
    names.push_back({lightness, 0, std::nullopt});
  }
  return names;
}

Munsell cns_color(const CnsName& name) {
  if (!name.hue) {
    return {std::nan(""), kGrayAnchor[static_cast<std::size_t>(name.lightness + 1)], 0};
  }
  const Anchors& anchors = anchors_of(*name.hue);
  const auto lightness = static_cast<std::size_t>(name.lightness);
  const double ratio = kSaturationAnchor[static_cast<std::size_t>(name.saturation)];
  return {anchors.hue, anchors.lightness.anchor[lightness], ratio * anchors.chroma[lightness]};
}

std::optional<CnsName> cns_name(Munsell munsell) {
  if (!(munsell.value >= 0 && munsell.value <= 10 && munsell.chroma >= 0)) return std::nullopt;
  if (munsell.chroma == 0) return gray_of(munsell.value);
  if (!std::isfinite(munsell.hue)) return std::nullopt;
  const int hue = hue_of(munsell);
  const Anchors& anchors = anchors_of(hue);
  const int lightness = step_of(anchors.lightness.begin, munsell.value);
  const double largest = anchors.chroma[static_cast<std::size_t>(lightness)];
  if (munsell.chroma < std::min(kNeutralChroma, kNeutralRatio * largest)) {
    return gray_of(munsell.value);
  }
  return CnsName{lightness, step_of(kSaturationBegin, munsell.chroma / largest), hue};
}

}  // namespace tristim
