#include "tools/commands.h"
#include "tools/device_actions.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim device list\n"
    "  tristim device show epaper-7color\n"
    "  tristim device show crt-p22 --toml > my-crt.toml\n"
    "  tristim device check my-crt.toml --plot my-crt.svg\n"
    "  tristim device new --name 'LED strip' --packing rgb888 --response linear -o strip.toml\n"
    "  printf '0,0.4\\n64,6\\n128,22\\n192,55\\n255,102\\n' > panel.csv && tristim device fit "
    "panel.csv -o panel.toml\n";

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
    return print(json ? json_line(facts) : facts_text(facts));
  }
  const auto* built_in = find_by_name(built_in_displays(), id);
  if (built_in == nullptr) {
    throw Error(ErrorKind::kMisuse, "--toml", "prints built-in devices only", "yours is " + id);
  }
  print(built_in->text);
}

struct CheckOptions {
  std::string plot;
  bool force = false;
};

void check(const std::string& path, const CheckOptions& options, bool json) {
  const Display display = load_display(path);
  if (!options.plot.empty()) write_device_plot(display, options.plot, options.force);
  if (options.plot == "-") return;  // the drawing alone
  const Json facts{{"device", path}, {"name", display.name}, {"valid", true}};
  print(json ? json_line(facts)
             : one_line(path) + ": good: " + one_line(display.name) + ", " + level_text(display) +
                   "\n");
}

struct Action {
  std::string_view name;
};
constexpr Action kActions[] = {{"list"}, {"show"}, {"check"}, {"new"}, {"fit"}};

// The maker that an action is, or nullptr: those have options of their own.
const Command* maker(std::string_view action) {
  for (const Command& command : kDeviceMakers) {
    if (same_name(command.name.substr(std::string_view("device ").size()), action)) return &command;
  }
  return nullptr;
}

// What does not go together is told, not ignored.
void check_arguments(const std::vector<std::string>& words, const CheckOptions& options, bool json,
                     bool toml) {
  if (!options.plot.empty() && (!same_name(words[0], "check") || words.size() > 2)) {
    throw Error(ErrorKind::kMisuse, "--plot", "draws one device",
                "use: tristim device check D --plot OUT.svg");
  }
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
  if (!arguments.empty()) {
    if (const Command* command = maker(arguments[0])) return command->run(arguments.subspan(1));
  }
  std::vector<std::string> words;
  CheckOptions options;
  bool json = false;
  bool toml = false;
  CommandLine line(*find_by_name(kCommands, "device"), kExamples);
  line.positional("list|show|check|new|fit",
                  "what to do, followed by devices: names of `tristim device list`, or files: "
                  "./panel.toml; `tristim device new --help` and `tristim device fit --help` tell "
                  "how files are made",
                  words, 1, 1 << 20);
  line.flag("--json", "print the facts as JSON, a line a device", json);
  line.flag("--toml", "show: the device file itself, to start one's own from", toml);
  line.option("--plot", "OUT", "check: draw response and gamut, to OUT.svg or into a folder",
              options.plot);
  line.flag("--force", "replace an existing drawing", options.force);
  if (!line.parse(arguments)) return;
  const Action* action = find_by_name(kActions, words[0]);
  if (action == nullptr) {
    throw Error(ErrorKind::kMisuse, "device", "unknown action '" + words[0] + "'",
                name_hint(kActions, words[0]));
  }
  check_arguments(words, options, json, toml);
  if (action->name == "list") return list(json);
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (action->name == "show") show(words[i], json, toml);
    if (action->name == "check") check(words[i], options, json);
  }
}

}  // namespace tristim::tools
