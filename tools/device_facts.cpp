#include <algorithm>
#include <limits>

#include "tools/device_actions.h"
#include "tools/report.h"
#include "tristim/color/gamut.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/channels.h"
#include "tristim/device/level_report.h"
#include "tristim/frame/pack.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

std::string kind_name(DisplayKind kind) {
  for (const NamedDisplayKind& known : kDisplayKinds) {
    if (known.kind == kind) return std::string(known.name);
  }
  return {};
}

Json xy_json(Chromaticity c) { return Json::array({c.x, c.y}); }

Json matrix_json(const Eigen::Matrix3d& m) {
  Json rows = Json::array();
  for (int i = 0; i < 3; ++i) rows.push_back(Json::array({m(i, 0), m(i, 1), m(i, 2)}));
  return rows;
}

Json palette_json(const Display& display) {
  Json list = Json::array();
  const FrameInfo info = frame_info(display, 1, 1);
  for (std::size_t i = 0; i < display.palette.size(); ++i) {
    const CodeColor& entry = display.palette[i];
    list.push_back(
        {{"code", entry.code},
         {"name", entry.name},
         {"xyz", Json::array({entry.appearance.x, entry.appearance.y, entry.appearance.z})},
         {"srgb", info.palette[i].srgb}});
  }
  return list;
}

Json coverage_json(const Primaries& primaries) {
  Json coverage = Json::object();
  for (const std::string_view name : kPictureSets) {
    const Primaries& set = find_by_name(primaries_list(), name)->primaries;
    coverage[std::string(name)] = number_json(gamut_coverage(primaries, set, kCie1976Plane));
  }
  return coverage;
}

bool has_channels(const Display& display) {
  return display.palette.empty() && !display.frame.packing.indexed && !display.press;
}

double ratio(double most, double least) {
  return least > 0 ? most / least : std::numeric_limits<double>::infinity();
}

// Of the palette's luminances, of its levels, or of what its codes show.
double dynamic_range(const Display& display) {
  if (!display.palette.empty()) {
    const auto [dark, bright] = std::minmax_element(
        display.palette.begin(), display.palette.end(),
        [](const CodeColor& a, const CodeColor& b) { return a.appearance.y < b.appearance.y; });
    return ratio(bright->appearance.y, dark->appearance.y);
  }
  if (display.levels) return ratio(1, lowest_intensity(*display.levels));
  const int code_max = (1 << display.frame.packing.bits[0]) - 1;
  return ratio(light_of_code(display.response, code_max, code_max),
               light_of_code(display.response, 0, code_max));
}

std::string range_text(const SharedRun& run) {
  return std::to_string(run.first) + ".." + std::to_string(run.last);
}

// The codes of a curve that show one and the same light.
std::vector<SharedRun> equal_lights(const std::vector<double>& light) {
  std::vector<int> step(light.size(), 0);
  for (std::size_t i = 1; i < light.size(); ++i) {
    step[i] = step[i - 1] + (light[i] > light[i - 1] ? 1 : 0);
  }
  return shared_runs(step);
}

Json channel_json(const Display& display, int channel) {
  const Response& response = response_of(display, channel);
  const int bits = display.frame.packing.bits[static_cast<std::size_t>(channel)];
  const int code_max = (1 << bits) - 1;
  Json json{{"response", describe(response)}, {"codes", code_max + 1}};
  std::vector<SharedRun> dead;
  if (display.levels) {
    const std::vector<int> codes = display_level_codes(display, bits, channel);
    const LevelReport report = level_report(*display.levels, response, codes, code_max);
    json["distinct_levels"] = report.distinct;
    json["largest_lstar_step"] = report.largest_shown_lstar_step;
    dead = report.dead_zones;
  } else {
    const std::vector<double> light = light_of_codes(display, bits, channel);
    dead = equal_lights(light);
    int same = 0;
    for (const SharedRun& run : dead) same += run.count() - 1;
    json["distinct_levels"] = code_max + 1 - same;
  }
  const bool dark = !dead.empty() && dead[0].first == 0;
  json["dead_zone"] =
      dark ? Json("codes " + range_text(dead[0]) + " give the lowest level") : "none";
  return json;
}

void add_levels(const Display& display, Json& json) {
  const LevelTable& levels = *display.levels;
  json["I0"] = lowest_intensity(levels);
  json["n"] = levels.n;
  json["spacing"] = spacing_of(levels).name;
}

void add_channels(const Display& display, Json& json) {
  const bool one =
      has_one_response(display) && display.frame.packing.bits[0] == display.frame.packing.bits[1];
  if (one || display.frame.packing.samples == 1) {
    const Json channel = channel_json(display, 0);
    for (const auto& [key, value] : channel.items()) {
      if (key != "response") json[key] = value;
    }
    return;
  }
  for (int c = 0; c < 3; ++c) json[std::string(kChannelNames[c])] = channel_json(display, c);
}

void add_dots(const Dots& dots, Json& json) {
  json["dpi"] = dots.dpi;
  json["isolated_dots"] = dots.isolated;
  if (dots.lpi > 0) json["lpi"] = dots.lpi;
  const std::string gain = describe(dots.gain);
  json["dot_gain"] = gain.empty() ? "none" : gain;
}

// A value of the JSON on one line, for people.
std::string line_text(const Json& value) {
  if (value.is_string()) return one_line(value.get<std::string>());
  if (value.is_number_float()) return rounded(value.get<double>(), 9);
  if (!value.is_array() && !value.is_object()) return value.dump();
  std::string text;
  for (const auto& [key, item] : value.items()) {
    if (!text.empty()) text += value.is_object() ? ", " : " ";
    if (value.is_object()) text += key + " ";
    text += line_text(item);
  }
  return text;
}

}  // namespace

std::string level_text(const Display& display) {
  const Packing& packing = display.frame.packing;
  if (!display.palette.empty()) return std::to_string(display.palette.size()) + " colours";
  if (packing.indexed) return "palette chosen for the picture";
  std::string text;
  for (int c = 0; c < packing.samples; ++c) {
    const LevelScale scale =
        level_scale(display, packing.bits[static_cast<std::size_t>(c)], BlackPoint::kRelative, c);
    text += (c > 0 ? " x " : "") + std::to_string(scale.light.size());
  }
  return text + " levels";
}

Json display_json(const std::string& id, const Display& display) {
  const Packing& packing = display.frame.packing;
  Json json{{"device", id},
            {"name", display.name},
            {"source", display.source},
            {"kind", kind_name(display.kind)},
            {"packing", packing.name},
            {"bits_per_pixel", packing.bits_per_pixel()},
            {"bit_order", display.frame.bit_order == BitOrder::kMsb ? "msb" : "lsb"},
            {"byte_order", display.frame.byte_order == ByteOrder::kBig ? "big" : "little"},
            {"store", display.frame.store == Store::kValue ? "value" : "index"}};
  if (display.panel) {
    const std::size_t line = packed_row_bytes(packing, display.panel->width);
    json["size"] = Json::array({display.panel->width, display.panel->height});
    json["bytes_per_line"] = line;
    json["bytes_per_picture"] = line * static_cast<std::size_t>(display.panel->height);
  }
  json["levels"] = level_text(display);
  json["dither"] = default_dither(display).name;
  json["response"] = describe_responses(display);
  if (has_channels(display)) add_channels(display, json);
  if (has_channels(display) || !display.palette.empty()) {
    json["dynamic_range"] = number_json(dynamic_range(display));
  }
  if (display.levels) add_levels(display, json);
  const Xyz white = white_xyz(display.primaries.white);
  json["primaries"] = {{"red", xy_json(display.primaries.red)},
                       {"green", xy_json(display.primaries.green)},
                       {"blue", xy_json(display.primaries.blue)},
                       {"white", xy_json(display.primaries.white)}};
  json["white_xyz"] = {white.x, white.y, white.z};
  json["xyz_from_rgb"] = matrix_json(xyz_from_rgb(display.primaries));
  json["rgb_from_xyz"] = matrix_json(rgb_from_xyz(display.primaries));
  if (display.palette.empty()) json["coverage_uv76"] = coverage_json(display.primaries);
  if (display.dots) add_dots(*display.dots, json);
  if (!display.palette.empty()) json["palette"] = palette_json(display);
  return json;
}

std::string facts_text(const Json& json) {
  std::string text;
  constexpr std::size_t kColumn = 20;
  for (const auto& [key, value] : json.items()) {
    const bool lines = value.is_array() && !value.empty() && value[0].is_structured();
    std::string label = key;
    std::replace(label.begin(), label.end(), '_', ' ');
    label.resize(std::max(kColumn, label.size() + 2), ' ');
    if (!lines) {
      text += label + line_text(value) + "\n";
      continue;
    }
    for (const Json& item : value) {
      text += label + line_text(item) + "\n";
      label.assign(label.size(), ' ');
    }
  }
  return text;
}

}  // namespace tristim::tools
