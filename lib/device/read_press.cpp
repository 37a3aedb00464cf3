#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

#include "lib/color/toml_color.h"
#include "lib/device/read_display.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kMostInks = 8;
constexpr double kLeastLight = 1e-3;  // of a solid: what a channel shows below it is stray light

// Inks whose light needs no telling: each keeps back one third of the light, black all.
struct IdealInk {
  std::string_view name;
  Rgb light;
};
constexpr IdealInk kIdealInks[] = {{"cyan", {kLeastLight, 1, 1}},
                                   {"magenta", {1, kLeastLight, 1}},
                                   {"yellow", {1, 1, kLeastLight}},
                                   {"black", {kLeastLight, kLeastLight, kLeastLight}}};

// Appearances under the viewing white in linear RGB of the device's primaries.
Eigen::Vector3d rgb_appearance(const Display& display, const Xyz& seen) {
  return rgb_from_xyz(display.primaries) *
         adaptation_matrix(display.viewing_white, display.primaries.white, display.adaptation) *
         Eigen::Vector3d(seen.x, seen.y, seen.z);
}

// The [[ink]] tables: lights by name, "paper" among them.
struct InkLight {
  std::string name;
  Eigen::Vector3d light;
};

std::vector<InkLight> read_lights(const TomlTable& root, const Display& display) {
  std::vector<InkLight> lights;
  for (const TomlTable& table : root.tables("ink")) {
    const std::string name = table.string("name").value_or("");
    const bool known = same_name(name, "paper") ||
                       (display.press && find_by_name(display.press->inks, name) != nullptr);
    if (!known) {
      table.fail("name", "ink '" + name + "' is not in [dots] inks", "add it there");
    }
    if (find_by_name(lights, name) != nullptr) table.fail("name", "ink '" + name + "' comes twice");
    const Xyz seen = read_appearance(table, display.viewing_white, display.adaptation);
    lights.push_back({name, rgb_appearance(display, seen)});
    table.finish();
  }
  return lights;
}

// The light of an ink relative to the paper's.
Rgb relative_light(const InkLight& ink, const Eigen::Vector3d& paper) {
  const auto channel = [&](Eigen::Index j) {
    return std::clamp(ink.light[j] / paper[j], kLeastLight, 1.0);
  };
  return {channel(0), channel(1), channel(2)};
}

// All overprints: entry i holds the inks whose bits i has.
void add_palette(Display& display) {
  const std::vector<Ink>& inks = display.press->inks;
  const Eigen::Matrix3d xyz = xyz_from_rgb(display.primaries);
  for (unsigned code = 0; code < 1u << inks.size(); ++code) {
    std::vector<double> areas;
    std::string name;
    for (std::size_t i = 0; i < inks.size(); ++i) {
      const bool on = (code >> i & 1) != 0;
      areas.push_back(on ? 1 : 0);
      if (on) name += (name.empty() ? "" : "+") + inks[i].name;
    }
    const Rgb light = printed_light(inks, areas);
    const Eigen::Vector3d c = xyz * Eigen::Vector3d(light.r, light.g, light.b);
    display.palette.push_back(
        {static_cast<std::uint16_t>(code), {c.x(), c.y(), c.z()}, name.empty() ? "paper" : name});
  }
  display.viewing_white = display.primaries.white;
}

void choose_packing(const TomlTable& root, Display& display) {
  const std::size_t count = display.press->inks.size();
  if (!root.has("frame_buffer")) {
    const char* name = count == 1   ? "index1"
                       : count == 2 ? "index2"
                       : count <= 4 ? "index4"
                                    : "index8";
    display.frame.packing = *find_by_name(kPackings, name);
  }
  const Packing& packing = display.frame.packing;
  if (packing.indexed && packing.bits[0] >= static_cast<int>(count)) return;
  root.fail("frame_buffer",
            "packing " + std::string(packing.name) + " does not hold a bit for each of " +
                std::to_string(count) + " inks",
            "give an indexed packing, or none");
}

}  // namespace

std::optional<Press> read_press(const TomlTable& dots) {
  const auto names = dots.strings("inks");
  const char* const of_inks[] = {"angles", "separation", "black", "ink_limit"};
  if (!names) {
    for (const char* key : of_inks) {
      if (dots.has(key)) dots.fail(key, std::string(key) + " needs inks", "add inks = [...]");
    }
    return std::nullopt;
  }
  Press press;
  if (names->empty() || names->size() > kMostInks) {
    dots.fail("inks", "a press has 1 to 8 inks, not " + std::to_string(names->size()));
  }
  for (const std::string& name : *names) {
    const bool taken = find_by_name(press.inks, name) != nullptr || same_name(name, "paper");
    if (name.empty() || taken || name.find_first_of("/\\.") != std::string::npos) {
      dots.fail("inks", "'" + name + "' cannot be the name of an ink here",
                "give names without '/' and '.', each once, other than paper");
    }
    press.inks.push_back({name, {}});
  }
  if (const auto angles = dots.numbers("angles")) {
    if (angles->size() != press.inks.size()) {
      dots.fail("angles", "there are not as many angles as inks", "give one for each, in order");
    }
    press.angles_deg = *angles;
  }
  press.rule = choice(dots, "separation", kSeparations, kSeparations[0]).rule;
  press.black.replacement = number_in(dots, "black", 1, 0, 1, "from 0 to 1: the share of grey");
  press.black.limit = number_in(dots, "ink_limit", 4, 1, 8, "from 1 to 8: 3 is 300 %");
  try {
    (void)Separation(press);
  } catch (const std::invalid_argument&) {
    dots.fail("inks", "no separation into " + list_names(press.inks) + " is known",
              "give one ink, or cyan, magenta and yellow with black or without");
  }
  return press;
}

void read_inks(const TomlTable& root, Display& display) {
  const std::vector<InkLight> lights = read_lights(root, display);
  if (!display.press) return;
  if (!display.palette.empty()) {
    root.fail("palette", "a press has no [[palette]]",
              "its colours are those of its [[ink]] tables");
  }
  if (display.levels) root.fail("levels", "a press has no [levels]", "remove one");
  Eigen::Vector3d paper = Eigen::Vector3d::Ones();
  if (const InkLight* own = find_by_name(lights, "paper")) paper = own->light;
  if (!(paper.minCoeff() > kLeastLight)) root.fail("ink", "the paper is black", "give its colour");
  for (Ink& ink : display.press->inks) {
    const InkLight* seen = find_by_name(lights, ink.name);
    const IdealInk* ideal = find_by_name(kIdealInks, ink.name);
    if (seen == nullptr && ideal == nullptr) {
      root.fail("dots", "ink '" + ink.name + "' has no colour",
                "add [[ink]] name = \"" + ink.name + "\" with lab, xyz or rgb");
    }
    ink.light = seen != nullptr ? relative_light(*seen, paper) : ideal->light;
  }
  choose_packing(root, display);
  add_palette(display);
}

}  // namespace tristim::detail
