#include "tristim/lut/io/ocio_config.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <stdexcept>

#include "lib/lut/io/clf.h"
#include "lib/lut/io/ocio_text.h"
#include "lib/lut/io/text_lines.h"
#include "tristim/color/transfer.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::ocio_clip;
using detail::ocio_line;
using detail::ocio_matrix;
using detail::ocio_power;
using detail::ocio_table;
using detail::yaml_text;

constexpr const char* kReference = "Linear sRGB";
constexpr std::size_t kStepEntries = 65536;  // about, of curves that are steps
constexpr std::string_view kOtherPrimaries[] = {"aces-ap0", "aces-ap1", "bt2020", "display-p3"};

using Transforms = std::vector<std::string>;  // as ocio_text.h writes them
// Builds what one display needs.
class DisplayWriter {
 public:
  DisplayWriter(const OcioDisplay& display, OcioConfig& config)
      : name_(display.name), display_(display.display), config_(config) {
    if (!display_.palette.empty()) return;
    for (std::size_t c = 0; c < 3; ++c) black_[static_cast<int>(c)] = lights(c).front();
  }

  bool has_codes() const { return display_.palette.empty(); }

  Transforms codes() {
    Transforms steps = picture_light();
    if (has_steps()) {
      const auto fraction = [&](int code, std::size_t c) {
        return code / (std::ldexp(1.0, bits(c)) - 1);
      };
      steps.push_back(ocio_table(write_table("codes", of_levels(fraction))));
    } else {
      append_response(steps);
    }
    return steps;
  }

  Transforms proof() {
    Transforms steps = picture_light();
    const Eigen::Matrix3d srgb =
        rgb_from_rgb(Primaries{}, display_.primaries, Adaptation::kBradford);
    if (!display_.palette.empty()) {
      const std::vector<Rgb> light = palette_light(display_, BlackPoint::kAbsolute);
      const auto darker = [&](const Rgb& a, const Rgb& b) { return luminance(a) < luminance(b); };
      const Rgb black = *std::ranges::min_element(light, darker);
      const Eigen::Vector3d low(black.r, black.g, black.b);
      steps.push_back(ocio_line(Eigen::Vector3d::Ones() - low, low));
    } else if (has_steps()) {
      std::array<std::vector<double>, 3> light;
      for (std::size_t c = 0; c < 3; ++c) light[c] = lights(c);
      const auto shown = [&](std::size_t code, std::size_t c) { return light[c][code]; };
      steps.push_back(ocio_table(write_table("light", of_levels(shown))));
    } else {
      steps.push_back(ocio_line(Eigen::Vector3d::Ones() - black_, black_));
    }
    steps.push_back(ocio_matrix(srgb));
    steps.push_back(ocio_clip());
    steps.push_back(ocio_table(srgb_table()));
    return steps;
  }

 private:
  // Light of every code of a channel.
  std::vector<double> lights(std::size_t channel) const {
    return light_of_codes(display_, bits(channel), static_cast<int>(channel));
  }

  int bits(std::size_t channel) const {
    return display_.frame.packing.bits[display_.frame.packing.samples == 1 ? 0 : channel];
  }

  double luminance(const Rgb& c) const {
    return xyz_from_rgb(display_.primaries).row(1).dot(Eigen::Vector3d(c.r, c.g, c.b));
  }

  // Codes so few that rounding is part of what the device is.
  bool has_steps() const {
    return display_.levels.has_value() || bits(0) < 8 || bits(1) < 8 || bits(2) < 8;
  }

  // From the config's linear sRGB to the device's black .. white, 0 to 1.
  Transforms picture_light() const {
    Eigen::Matrix3d m = rgb_from_rgb(display_.primaries, Primaries{}, Adaptation::kBradford);
    Transforms steps{ocio_matrix(m), ocio_clip()};
    if (display_.frame.packing.samples == 1 && !display_.frame.packing.indexed) {
      const Eigen::RowVector3d weights = xyz_from_rgb(display_.primaries).row(1);
      steps.push_back(ocio_matrix(weights.replicate(3, 1)));
      steps.push_back(ocio_clip());  // weights add up to 1 and a last bit
    }
    return steps;
  }

  // The response as formulas of OpenColorIO, whose powers end at 0 as ours do.
  void append_response(Transforms& steps) {
    const bool measured = std::holds_alternative<TableResponse>(display_.response) ||
                          std::holds_alternative<GogResponse>(display_.response);
    if (measured || !has_one_response(display_)) {
      const std::string file = name_ + "-response.clf";
      config_.files.push_back(
          {file, detail::clf_text(
                     name_, detail::half_domain_node({positions(0), positions(1), positions(2)}))});
      steps.push_back(ocio_table(file));
    } else if (std::holds_alternative<SrgbResponse>(display_.response)) {
      steps.push_back(ocio_table(srgb_table()));
    } else if (const auto* gamma = std::get_if<GammaResponse>(&display_.response)) {
      const double most = std::ldexp(1.0, bits(0)) - 1;
      if (gamma->k > 0)
        steps.push_back(ocio_line(1 / (gamma->k * std::pow(most, gamma->gamma)), 0));
      steps.push_back(ocio_power(gamma->gamma, true));
      if (gamma->k > 0) steps.push_back(ocio_clip());
    } else if (const auto* studio = std::get_if<Bt1886Response>(&display_.response)) {
      const double root = std::pow(studio->black, 1 / 2.4);
      steps.push_back(ocio_line(1 - black_[0], black_[0]));
      steps.push_back(ocio_power(2.4, true));
      steps.push_back(ocio_line(1 / (1 - root), -root / (1 - root)));
      steps.push_back(ocio_clip());
    }  // linear: light is the code
  }

  // sRGB is exact as a table; the library's own formula has another joint, 1e-5 off.
  std::string srgb_table() {
    const std::string file = "srgb-curve.clf";
    const auto has_name = [&](const OcioConfigFile& f) { return f.name == file; };
    if (std::ranges::none_of(config_.files, has_name)) {
      std::vector<float> curve;
      for (const float light : detail::positive_halfs()) {
        curve.push_back(static_cast<float>(srgb_encode(std::min(light, 1.0F))));
      }
      config_.files.push_back(
          {file, detail::clf_text("sRGB", detail::half_domain_node({curve, curve, curve}))});
    }
    return file;
  }

  // Where picture light lies among the levels of a channel: 0 at the first, 1 at the last, and half
  // way where another one becomes the nearest.
  double position(double light, std::size_t channel) const {
    if (!display_.levels) {
      const double most = std::ldexp(1.0, bits(channel)) - 1;
      const int c = static_cast<int>(channel);
      const double shown = black_[c] + light * (1 - black_[c]);
      return code_of_light(response_of(display_, c), shown, most) / most;
    }
    const double black = lowest_intensity(*display_.levels);
    return level_position(black + light * (1 - black), *display_.levels) / display_.levels->n;
  }

  std::vector<float> positions(std::size_t channel) const {
    std::vector<float> curve;
    for (const float light : detail::positive_halfs()) {
      curve.push_back(static_cast<float>(position(std::min(light, 1.0F), channel)));
    }
    return curve;
  }

  // Values of the levels as a curve of positions, many entries a level, so that the slopes between
  // are steep.
  static std::vector<float> steps_of(const std::vector<double>& levels, std::size_t size) {
    const std::size_t each = (size - 1) / (levels.size() - 1);
    std::vector<float> curve;
    for (std::size_t i = 0; i < size; ++i) {
      curve.push_back(static_cast<float>(levels[(i + each / 2) / each]));
    }
    return curve;
  }

  // A file for which value the nearest level of picture light has: positions at every half float,
  // then steps, as many entries for each level and an odd number, so that a slope has its middle
  // where two levels meet. OpenColorIO would make one table of two, and lose the steps: half the
  // positions and a matrix between them keep them apart.
  std::string write_table(const std::string& what,
                          const std::array<std::vector<double>, 3>& levels) {
    std::size_t intervals = 1;
    for (const auto& channel : levels) intervals = std::lcm(intervals, channel.size() - 1);
    const std::size_t each = std::max<std::size_t>(kStepEntries / intervals, 1) | 1;
    std::array<std::vector<float>, 3> places;
    std::array<std::vector<float>, 3> steps;
    for (std::size_t c = 0; c < 3; ++c) {
      places[c] = positions(c);
      for (float& place : places[c]) place /= 2;
      steps[c] = steps_of(levels[c], intervals * each + 1);
    }
    const Lut twice{"", {LutMatrix{2 * Eigen::Matrix3d::Identity()}}};
    const std::string file = name_ + "-" + what + ".clf";
    config_.files.push_back(
        {file, detail::clf_text(name_ + ", " + what, detail::half_domain_node(places) +
                                                         detail::clf_nodes(twice, false) +
                                                         detail::curves_node(steps))});
    return file;
  }

  // What the levels of each channel have, by their codes.
  template <typename Value>
  std::array<std::vector<double>, 3> of_levels(const Value& value) const {
    std::array<std::vector<double>, 3> levels;
    for (std::size_t c = 0; c < 3; ++c) {
      const LevelScale scale =
          level_scale(display_, bits(c), BlackPoint::kRelative, static_cast<int>(c));
      for (const std::uint16_t code : scale.nearest) levels[c].push_back(value(code, c));
    }
    return levels;
  }

  const std::string& name_;
  const Display& display_;
  OcioConfig& config_;
  Eigen::Vector3d black_{0, 0, 0};  // light of code 0, by channel
};

std::string space_text(const std::string& name, const std::string& description,
                       const std::string& encoding, const char* direction,
                       const Transforms& steps) {
  std::string text = "  - !<ColorSpace>\n    name: " + yaml_text(name) +
                     "\n    description: " + yaml_text(description) +
                     "\n    encoding: " + encoding + "\n    isdata: false\n";
  if (steps.empty()) return text + "\n";
  text += std::string("    ") + direction + ": !<GroupTransform>\n      children:\n";
  for (const std::string& step : steps) text += "        - " + step + "\n";
  return text + "\n";
}

void check_names(std::span<const OcioDisplay> displays) {
  if (displays.empty()) throw std::invalid_argument("ocio_config: no displays");
  std::set<std::string> seen;
  for (const OcioDisplay& display : displays) {
    if (!seen.insert(display.name).second) {
      throw std::invalid_argument("ocio_config: two displays are called " + display.name);
    }
  }
}

constexpr const char* kHead =
    "ocio_profile_version: 2\n\n"
    "description: Displays of tristim. Codes are what a frame buffer holds, divided by its highest "
    "code; Proof is what the display shows, for an sRGB screen.\n"
    "search_path: \".\"\nstrictparsing: true\nluma: [0.2126, 0.7152, 0.0722]\n\n"
    "roles:\n  default: \"Linear sRGB\"\n  scene_linear: \"Linear sRGB\"\n"
    "  rendering: \"Linear sRGB\"\n  data: Raw\n\n"
    "file_rules:\n  - !<Rule> {name: Default, colorspace: default}\n\n";

}  // namespace

OcioConfig ocio_config(std::span<const OcioDisplay> displays) {
  check_names(displays);
  OcioConfig config;
  std::string shown = "displays:\n";
  std::string spaces = "colorspaces:\n";
  spaces += space_text(kReference, "light of the primaries of sRGB", "scene-linear", "", {});
  spaces += "  - !<ColorSpace>\n    name: Raw\n    isdata: true\n\n";
  for (const NamedPrimaries& named : primaries_list()) {
    if (std::ranges::find(kOtherPrimaries, named.name) == std::end(kOtherPrimaries)) continue;
    spaces += space_text(
        "Linear " + std::string(named.name), "light of these primaries", "scene-linear",
        "to_scene_reference",
        {ocio_matrix(rgb_from_rgb(Primaries{}, named.primaries, Adaptation::kBradford))});
  }
  for (const OcioDisplay& display : displays) {
    DisplayWriter writer(display, config);
    shown += "  " + yaml_text(display.name) + ":\n";
    const auto add = [&](const char* view, const Transforms& steps) {
      const std::string space = display.name + " " + view;
      shown +=
          std::string("    - !<View> {name: ") + view + ", colorspace: " + yaml_text(space) + "}\n";
      spaces += space_text(space, display.display.name, "sdr-video", "from_scene_reference", steps);
    };
    if (writer.has_codes()) add("Codes", writer.codes());
    add("Proof", writer.proof());
  }
  config.text = kHead + shown + "\nactive_displays: []\nactive_views: []\n\n" + spaces;
  return config;
}

}  // namespace tristim
