#include <algorithm>

#include "tools/commands.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/frame/pack.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim device list\n"
    "  tristim device show epaper-7color\n"
    "  tristim device show crt-p22 --toml > my-crt.toml\n"
    "  tristim device check my-crt.toml\n";

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

std::string level_text(const Display& display) {
  const Packing& packing = display.frame.packing;
  if (!display.palette.empty()) return std::to_string(display.palette.size()) + " colours";
  if (packing.indexed) return "palette chosen for the picture";
  std::string text;
  for (int c = 0; c < packing.samples; ++c) {
    const LevelScale scale =
        level_scale(display, packing.bits[static_cast<std::size_t>(c)], BlackPoint::kRelative);
    text += (c > 0 ? " x " : "") + std::to_string(scale.light.size());
  }
  return text + " levels";
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
    json["size"] = Json::array({display.panel->width, display.panel->height});
    json["bytes_per_line"] = packed_row_bytes(packing, display.panel->width);
  }
  json["levels"] = level_text(display);
  json["dither"] = default_dither(display).name;
  json["response"] = describe(display.response);
  json["primaries"] = {{"red", xy_json(display.primaries.red)},
                       {"green", xy_json(display.primaries.green)},
                       {"blue", xy_json(display.primaries.blue)},
                       {"white", xy_json(display.primaries.white)}};
  json["xyz_from_rgb"] = matrix_json(xyz_from_rgb(display.primaries));
  json["rgb_from_xyz"] = matrix_json(rgb_from_xyz(display.primaries));
  if (display.levels) {
    json["I0"] = display.levels->i0;
    json["n"] = display.levels->n;
    json["dynamic_range"] = 1 / display.levels->i0;
  }
  if (display.dots) {
    json["dpi"] = display.dots->dpi;
    json["isolated_dots"] = display.dots->isolated;
    if (display.dots->lpi > 0) json["lpi"] = display.dots->lpi;
    const std::string gain = describe(display.dots->gain);
    json["dot_gain"] = gain.empty() ? "none" : gain;
  }
  if (!display.palette.empty()) json["palette"] = palette_json(display);
  return json;
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

std::string show_text(const Json& json) {
  std::string text;
  constexpr std::size_t kColumn = 16;
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

void list(bool json) {
  std::string text;
  Json all = Json::array();
  for (const BuiltInDisplay& built_in : built_in_displays()) {
    const std::string id(built_in.name);
    const Display display = load_display(id);
    all.push_back(display_json(id, display));
    std::string line = id;
    line.resize(std::max<std::size_t>(16, line.size() + 1), ' ');
    text += line + display.name + "; " + std::string(display.frame.packing.name) + ", " +
            level_text(display) + "\n";
  }
  print(json ? json_line(all) : text);
}

void show(const std::string& id, bool json, bool toml) {
  const Display display = load_display(id);
  if (!toml) {
    const Json facts = display_json(id, display);
    return print(json ? json_line(facts) : show_text(facts));
  }
  const auto* built_in = find_by_name(built_in_displays(), id);
  if (built_in == nullptr) {
    throw Error(ErrorKind::kMisuse, "--toml", "prints built-in devices only", "yours is " + id);
  }
  print(built_in->text);
}

void check(const std::string& path, bool json) {
  const Display display = load_display(path);
  const Json facts{{"device", path}, {"name", display.name}, {"valid", true}};
  print(json ? json_line(facts)
             : one_line(path) + ": good: " + one_line(display.name) + ", " + level_text(display) +
                   "\n");
}

struct Action {
  std::string_view name;
};
constexpr Action kActions[] = {{"list"}, {"show"}, {"check"}};

// What does not go together is told, not ignored.
void check_arguments(const std::vector<std::string>& words, bool json, bool toml) {
  const bool listed = same_name(words[0], "list");
  if (toml && (json || !same_name(words[0], "show"))) {
    throw Error(ErrorKind::kMisuse, "--toml",
                "does not go with " + (json ? std::string("--json") : words[0]),
                "use: tristim device show D --toml");
  }
  if (listed && words.size() > 1) {
    throw Error(ErrorKind::kMisuse, words[1], "is one argument too many",
                "use: tristim device list, or tristim device show " + words[1]);
  }
  if (!listed && words.size() < 2) {
    throw Error(ErrorKind::kMisuse, "device " + words[0], "no device is named",
                "give one of " + list_names(built_in_displays()) + ", or a file");
  }
}

}  // namespace

void run_device(Arguments arguments) {
  std::vector<std::string> words;
  bool json = false;
  bool toml = false;
  CommandLine line(*find_by_name(kCommands, "device"), kExamples);
  line.positional("list|show|check",
                  "what to do, followed by devices: names of `tristim device "
                  "list`, or files: ./panel.toml",
                  words, 1, 1 << 20);
  line.flag("--json", "print the facts as JSON, a line a device", json);
  line.flag("--toml", "show: the device file itself, to start one's own from", toml);
  if (!line.parse(arguments)) return;
  const Action* action = find_by_name(kActions, words[0]);
  if (action == nullptr) {
    throw Error(ErrorKind::kMisuse, "device", "unknown action '" + words[0] + "'",
                name_hint(kActions, words[0]));
  }
  check_arguments(words, json, toml);
  if (action->name == "list") return list(json);
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (action->name == "show") show(words[i], json, toml);
    if (action->name == "check") check(words[i], json);
  }
}

}  // namespace tristim::tools
