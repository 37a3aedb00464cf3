#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tools/halftone.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tools/screen_chart.h"
#include "tools/spot_picture.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/display_file.h"
#include "tristim/dither/moire.h"
#include "tristim/pipeline/chain.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim halftone screen --dpi 600 --lpi 85 --angle 45 --spot round\n"
    "  tristim halftone screen --dpi 2400 --lpi 150 --angle 15,75,0,45\n"
    "  tristim halftone screen --dpi 300 --lpi 50 --spot 'cos(pi*x) + cos(pi*y)' -o dots.png\n"
    "  tristim halftone screen --device offset-cmyk --json\n"
    "  tristim halftone screen --dpi 600 --lpi 100 --angle 30 -o matrix.json\n\n"
    "Separations of a picture, one file for each ink:\n"
    "  tristim render spheres -o spheres.exr\n"
    "  tristim process spheres.exr --device offset-cmyk --size 1200x -o page.tif\n";

// The settings of `process` that are about screens.
constexpr std::string_view kSettings[] = {"dpi",  "lpi",          "angle",
                                          "spot", "smallest-dot", "single-cell"};

struct Options {
  Settings settings;
  std::string device, output, kind = "screen", tones;
  double least_beat = kLeastBeat;
  bool json = false, force = false;
};

void declare(CommandLine& line, Options& options) {
  for (const std::string_view name : kSettings) {
    const Setting* setting = find_by_name(settings_list(), name);
    const auto set = [&options, setting](const std::string& value) {
      if (const auto refusal = setting->set(options.settings, value)) {
        throw Error(ErrorKind::kMisuse, "--" + std::string(setting->name), refusal->wrong,
                    refusal->remedy);
      }
    };
    if (setting->argument.empty()) {
      line.toggle(std::string(name), setting->help, set);
    } else {
      line.option("--" + std::string(name), setting->argument, setting->help, set);
    }
  }
  line.option("--kind", list_names(kScreenRecipes, "|"), "default: screen", options.kind);
  line.option("-d,--device", "D", "resolution, ruling, inks and angles of a printer",
              options.device);
  line.option(
      "--least-beat", "PART",
      "warn of beats between two screens below this part of the ruling; default: 0.25",
      [&](const std::string& v) { options.least_beat = number_option("--least-beat", v, 0, 1); });
  line.option("-o,--output", "OUT",
              "the dots as a .png chart, or the thresholds as .json or .csv; of one screen",
              options.output);
  line.option("--tones", "T,...", "of the chart, 0 black to 1 white; default: .05 to .95",
              options.tones);
  line.flag("--json", "print the facts as JSON", options.json);
  line.flag("-f,--force", "replace an existing file", options.force);
}

struct NamedScreen {
  std::string name;  // of its ink; empty: the only one
  Screen asked;
  ReachedScreen reached;
};

std::vector<std::string> ink_names(const Display& display, std::size_t count) {
  constexpr const char* kUsual[] = {"cyan", "magenta", "yellow", "black"};
  std::vector<std::string> names;
  if (display.press) {
    for (const Ink& ink : display.press->inks) names.push_back(ink.name);
    return names;
  }
  for (std::size_t i = 0; i < count; ++i) {
    names.push_back(count == 1 ? "" : count == 4 ? kUsual[i] : "screen " + std::to_string(i + 1));
  }
  return names;
}

std::vector<NamedScreen> screens_of(const Options& options) {
  const ScreenRecipe* recipe = find_by_name(kScreenRecipes, options.kind);
  if (recipe == nullptr) {
    throw Error(ErrorKind::kMisuse, "--kind", "unknown kind '" + options.kind + "'",
                name_hint(kScreenRecipes, options.kind));
  }
  const Display display = options.device.empty() ? Display{} : load_display(options.device);
  ScreenParameters told = screen_parameters(display, options.settings.dither_parameters.screen);
  if (!options.settings.spot_picture.empty()) {
    told.spot = read_spot_picture(options.settings.spot_picture);
  }
  const std::size_t count =
      display.press ? display.press->inks.size() : std::max<std::size_t>(told.angles_deg.size(), 1);
  const std::vector<std::string> names = ink_names(display, count);
  std::vector<NamedScreen> screens;
  for (std::size_t i = 0; i < count; ++i) {
    const Screen asked = screen_of(*recipe, told, static_cast<int>(i), static_cast<int>(count));
    screens.push_back({names[i], asked, reach(asked)});
  }
  return screens;
}

Json screen_json(const NamedScreen& screen) {
  const ReachedScreen& reached = screen.reached;
  const double dots = reached.cell_dots();
  const double tile = dots * reached.cells * reached.cells;
  return {{"ink", screen.name},
          {"dpi", screen.asked.dpi},
          {"spot", spot_name(screen.asked.spot)},
          {"asked", {{"lpi", screen.asked.lpi}, {"angle_deg", screen.asked.angle_deg}}},
          {"reached", {{"lpi", reached.lpi}, {"angle_deg", reached.angle_deg}}},
          {"cell_dots", dots},
          {"cell_side", std::sqrt(dots)},
          {"cell_levels", static_cast<int>(dots) + 1},
          {"smallest_dot", screen.asked.smallest_dot},
          {"tile", {{"a", reached.a}, {"b", reached.b}, {"cells", reached.cells * reached.cells}}},
          {"levels", static_cast<int>(std::min(tile, 65536.0)) + 1}};
}

std::string screen_text(const NamedScreen& screen) {
  const ReachedScreen& reached = screen.reached;
  const Json facts = screen_json(screen);
  std::string text = screen.name.empty() ? "" : screen.name + "\n";
  const auto row = [&text](std::string name, const std::string& value) {
    name.resize(10, ' ');
    text += name + value + "\n";
  };
  row("asked", rounded(screen.asked.lpi, 6) + " lpi at " + rounded(screen.asked.angle_deg, 6) +
                   " degrees, " + rounded(screen.asked.dpi, 6) + " dpi, spot " +
                   spot_name(screen.asked.spot));
  row("reached", rounded(reached.lpi, 6) + " lpi at " + rounded(reached.angle_deg, 6) + " degrees");
  row("cell", rounded(facts["cell_side"], 5) + " dots a side, " + facts["cell_levels"].dump() +
                  " levels of its own" +
                  (screen.asked.smallest_dot > 1
                       ? ", smallest dot " + std::to_string(screen.asked.smallest_dot)
                       : ""));
  row("tile", std::to_string(reached.cells * reached.cells) + " cells on the vectors (" +
                  std::to_string(reached.a) + ", " + std::to_string(reached.b) + ") and (" +
                  std::to_string(-reached.b) + ", " + std::to_string(reached.a) + "), " +
                  facts["levels"].dump() + " levels");
  return text;
}

std::string beat_text(const Beat& beat, const std::vector<NamedScreen>& screens) {
  std::string line = screens[beat.first].name + " + " + screens[beat.second].name;
  line.resize(std::max<std::size_t>(24, line.size() + 1), ' ');
  if (beat.lpi == 0) return line + "the same screen: no beat, but colours depend on register\n";
  return line + rounded(beat.lpi, 4) + " lpi, period " + rounded(beat.period_cells, 3) + " cells" +
         (beat.visible ? ": visible" : "") + "\n";
}

Json beat_json(const Beat& beat, const std::vector<NamedScreen>& screens) {
  constexpr double kInch = 25.4;  // mm
  return {{"screens", {screens[beat.first].name, screens[beat.second].name}},
          {"lpi", beat.lpi},
          {"period_cells", number_json(beat.period_cells)},
          {"period_mm", number_json(kInch / beat.lpi)},
          {"visible", beat.visible}};
}

void report(const Options& options, const std::vector<NamedScreen>& screens) {
  std::vector<ReachedScreen> reached;
  for (const NamedScreen& screen : screens) reached.push_back(screen.reached);
  const std::vector<Beat> all = beats(reached, options.least_beat);
  if (options.json) {
    Json json{{"screens", Json::array()}, {"beats", Json::array()}};
    for (const NamedScreen& screen : screens) json["screens"].push_back(screen_json(screen));
    for (const Beat& beat : all) json["beats"].push_back(beat_json(beat, screens));
    print(json_line(json));
  } else {
    std::string text;
    for (const NamedScreen& screen : screens) text += screen_text(screen);
    if (!all.empty()) text += "moire\n";
    for (const Beat& beat : all) text += "  " + beat_text(beat, screens);
    print(text);
  }
  const auto visible = std::ranges::count_if(all, [](const Beat& beat) { return beat.visible; });
  if (visible > 0) {
    note("warning: " + std::to_string(visible) + " of " + std::to_string(all.size()) +
         " pairs of screens make a visible moire; keep their angles 30 degrees apart");
  }
}

}  // namespace

void run_halftone_screen(Arguments arguments) {
  Options options;
  CommandLine line(*halftone_job("screen"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  const std::vector<NamedScreen> screens = screens_of(options);
  if (!options.output.empty()) {
    if (screens.size() != 1) {
      throw Error(ErrorKind::kMisuse, "--output",
                  "takes one screen, not " + std::to_string(screens.size()), "give one --angle");
    }
    if (options.output == "-" && options.json) {
      throw Error(ErrorKind::kMisuse, "--json", "standard output is taken by the screen",
                  "write it to a file");
    }
    write_screen(options.output, screens[0].asked, options.tones, options.force);
    if (options.output == "-") return;
  }
  report(options, screens);
}

}  // namespace tristim::tools
