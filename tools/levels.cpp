#include "tristim/device/levels.h"

#include <algorithm>
#include <cmath>

#include "tools/commands.h"
#include "tools/levels_job.h"
#include "tools/levels_options.h"
#include "tools/outputs.h"
#include "tools/report.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim levels --n 15 --i0 0.02 --gamma 2.2 --vmax 255\n"
    "  tristim levels --n 255 --i0 0.01 --gamma 2.5 --json\n"
    "  tristim levels --n 15 --i0 0.02 --nearest 0.2\n"
    "  tristim levels --n 63 --gamma 2.1,2.2,2.4 --store index --c > color_table.h\n"
    "  printf '0,0.4\\n64,6\\n128,22\\n192,55\\n255,102\\n' > panel.csv && tristim levels --n 15 "
    "--measured panel.csv --plot levels.svg\n"
    "  tristim levels --dimming --n 255 --vmax 4095 --dead-reckoned --c --progmem > dimming.h\n"
    "  tristim levels --dimming --n 63 --vmax 255 --temporal 2 --json\n"
    "  tristim levels --spacing bt1886 --lw 100 --lb 0.05 --gamma 2.2 --vmax 1023\n"
    "  tristim levels --device crt-p22 --plot crt.svg\n";

struct Options {
  LevelsOptions levels;
  CTableOptions c_table;
  std::vector<double> nearest;
  std::string plot;
  bool json = false, c = false, force = false;
};

void print_nearest(const Options& options, const LevelTable& table) {
  Json list = Json::array();
  std::string text;
  for (const double intensity : options.nearest) {
    const auto j = nearest_level(intensity, table);
    list.push_back(j ? Json(*j) : Json(nullptr));
    text += (j ? std::to_string(*j) : "none") + "\n";
  }
  print(options.json ? json_line(list) : text);
}

void add_nearest(std::vector<double>& nearest, const std::string& list) {
  for (const std::string_view part : split(list, ',')) {
    const auto intensity = parse_number(part);
    if (!intensity) {
      throw Error(ErrorKind::kMisuse, "--nearest", "'" + std::string(part) + "' is no number",
                  "give intensities separated by commas: 0.1,0.2");
    }
    nearest.push_back(*intensity);
  }
}

// The name of a table in C.
std::string identifier(const std::string& name) {
  const auto letter = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool good =
      !name.empty() && letter(name[0]) &&
      std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); });
  if (good) return name;
  throw Error(ErrorKind::kMisuse, "--name", "'" + name + "' is no name in C",
              "give letters, digits and '_'");
}

void declare(CommandLine& line, Options& options) {
  declare_levels(line, options.levels);
  line.section("Output");
  line.option("--nearest", "I,...", "print the nearest level of each intensity",
              [&](const std::string& v) { add_nearest(options.nearest, v); });
  line.flag("--json", "print the table as JSON, with the keys I0 n gamma Vmax I V and more",
            options.json);
  line.flag("--c", "print the codes as a C header", options.c);
  line.flag("--progmem", "with --c: in the program memory of AVR processors",
            options.c_table.progmem);
  line.option("--name", "NAME", "with --c: of the table; default: level_codes, color_table",
              [&](const std::string& v) { options.c_table.name = identifier(v); });
  line.option("--plot", "OUT.svg", "draw light and L* of the levels and codes", options.plot);
  line.flag("--force", "replace an existing drawing", options.force);
}

void check_together(const Options& options) {
  const auto refuse = [](const std::string& option, const std::string& wrong,
                         const std::string& remedy) {
    throw Error(ErrorKind::kMisuse, option, wrong, remedy);
  };
  if (options.c && (options.json || !options.nearest.empty())) {
    refuse("--c", "does not go with " + std::string(options.json ? "--json" : "--nearest"),
           "give one of them");
  }
  if (!options.c && options.c_table.progmem) refuse("--progmem", "needs --c", "add --c");
  if (!options.c && !options.c_table.name.empty()) refuse("--name", "needs --c", "add --c");
}

void write_plot(const Options& options, const LevelsJob& job,
                const std::vector<ChannelLevels>& channels) {
  OutputFile file(options.plot, options.force);
  file.write(levels_plot(job, channels));
  file.commit();
}

}  // namespace

void run_levels(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "levels"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  check_together(options);
  if (!options.plot.empty()) {
    refuse_other_drawings(options.plot);
    refuse_taken_outputs({options.plot}, options.force);
  }
  const LevelsJob job = levels_job(options.levels);
  if (!options.nearest.empty()) return print_nearest(options, job.table);
  const std::vector<ChannelLevels> channels = channel_levels(job);
  if (!options.plot.empty()) write_plot(options, job, channels);
  if (options.plot == "-") return;  // the drawing alone
  if (options.c) return print(levels_c(job, channels, options.c_table));
  print(options.json ? json_line(levels_json(job, channels)) : levels_text(job, channels));
}

}  // namespace tristim::tools
