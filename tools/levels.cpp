#include <algorithm>
#include <cmath>
#include <set>

#include "tools/commands.h"
#include "tools/report.h"
#include "tristim/color/lab.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/device/levels.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim levels --n 15 --i0 0.02 --gamma 2.2 --vmax 255\n"
    "  tristim levels --n 255 --i0 0.01 --gamma 2.5 --json\n"
    "  tristim levels --n 15 --i0 0.02 --nearest 0.2\n"
    "  tristim levels --n 15 --c > table.h\n";

struct Options {
  LevelTable table;
  double gamma = 2.2;
  double k = 0;
  int vmax = 255;
  std::vector<double> nearest;
  bool json = false, c = false;
};

double largest_lstar_step(const std::vector<double>& levels) {
  double largest = 0;
  for (std::size_t j = 1; j < levels.size(); ++j) {
    largest =
        std::max(largest, lstar_from_luminance(levels[j]) - lstar_from_luminance(levels[j - 1]));
  }
  return largest;
}

Json facts(const Options& options, const std::vector<double>& levels,
           const std::vector<int>& codes) {
  const std::set<int> distinct(codes.begin(), codes.end());
  return Json{{"I0", options.table.i0},
              {"n", options.table.n},
              {"gamma", options.gamma},
              {"Vmax", options.vmax},
              {"spacing", options.table.spacing->name},
              {"dynamic_range", 1 / options.table.i0},
              {"ratio", levels[1] / levels[0]},
              {"distinct", distinct.size()},
              {"largest_lstar_step", largest_lstar_step(levels)},
              {"I", levels},
              {"V", codes}};
}

std::string table_text(const Json& facts) {
  std::string text = "dynamic range " + rounded(facts["dynamic_range"], 9) + ", ratio " +
                     rounded(facts["ratio"], 9) + ", distinct codes " + facts["distinct"].dump() +
                     " of " + std::to_string(facts["V"].size()) + ", largest step " +
                     rounded(facts["largest_lstar_step"], 4) +
                     " L*\n   j  I_j                     V_j\n";
  for (std::size_t j = 0; j < facts["V"].size(); ++j) {
    const std::string index = std::to_string(j);
    std::string intensity = shortest(facts["I"][j]);
    intensity.resize(std::max<std::size_t>(24, intensity.size() + 1), ' ');
    text.append(index.size() < 4 ? 4 - index.size() : 0, ' ');
    text.append(index).append("  ").append(intensity).append(facts["V"][j].dump()).append("\n");
  }
  return text;
}

std::string c_text(const Options& options, const std::vector<int>& codes) {
  const std::string type = options.vmax < 256 ? "uint8_t" : "uint16_t";
  std::string text = "#pragma once\n\n#include <stdint.h>\n\n/* Code of each intensity level: I0 " +
                     shortest(options.table.i0) + ", gamma " + shortest(options.gamma) + ", " +
                     std::string(options.table.spacing->name) +
                     " spacing. */\n#define LEVEL_COUNT " + std::to_string(codes.size()) +
                     "\nstatic const " + type + " level_codes[LEVEL_COUNT] = {";
  for (std::size_t j = 0; j < codes.size(); ++j) {
    text += (j % 16 == 0 ? "\n    " : " ") + std::to_string(codes[j]) + ",";
  }
  return text + "\n};\n";
}

void print_nearest(const Options& options) {
  Json list = Json::array();
  std::string text;
  for (const double intensity : options.nearest) {
    const auto j = nearest_level(intensity, options.table);
    list.push_back(j ? Json(*j) : Json(nullptr));
    text += (j ? std::to_string(*j) : "none") + "\n";
  }
  print(options.json ? json_line(list) : text);
}

void declare(CommandLine& line, Options& options) {
  constexpr double kOpen = 1e-12;
  line.option("--n", "N", "highest level: N + 1 levels; default: 255",
              [&](const std::string& v) { options.table.n = integer_option("--n", v, 1, 65535); });
  line.option("--i0", "I", "lowest intensity, between 0 and 1; default: 0.02",
              [&](const std::string& v) {
                options.table.i0 = number_option("--i0", v, kOpen, 1 - kOpen, "between 0 and 1");
              });
  line.option("--gamma", "G", "exponent of the device; default: 2.2", [&](const std::string& v) {
    options.gamma = options.table.gamma = number_option("--gamma", v, 0.01, 100);
  });
  line.option(
      "--k", "K", "factor of I = K V^gamma; default: Vmax^-gamma",
      [&](const std::string& v) { options.k = number_option("--k", v, 1e-300, 1e300, "above 0"); });
  line.option("--vmax", "V", "highest code; default: 255",
              [&](const std::string& v) { options.vmax = integer_option("--vmax", v, 1, 65535); });
  line.option("--spacing", list_names(level_spacings(), "|"), "of the levels; default: ratio",
              [&](const std::string& v) {
                options.table.spacing = find_by_name(level_spacings(), v);
                if (options.table.spacing == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--spacing", "unknown spacing '" + v + "'",
                              name_hint(level_spacings(), v));
                }
              });
  line.option(
      "--nearest", "I,...", "print the nearest level of each intensity", [&](const std::string& v) {
        for (const std::string_view part : split(v, ',')) {
          const auto intensity = parse_number(part);
          if (!intensity) {
            throw Error(ErrorKind::kMisuse, "--nearest", "'" + std::string(part) + "' is no number",
                        "give intensities separated by commas: 0.1,0.2");
          }
          options.nearest.push_back(*intensity);
        }
      });
  line.flag("--json", "print the table as JSON, with the keys I0 n gamma Vmax I V and more",
            options.json);
  line.flag("--c", "print the codes as a C header", options.c);
}

}  // namespace

void run_levels(Arguments arguments) {
  Options options;
  options.table.spacing = find_by_name(level_spacings(), "ratio");
  CommandLine line(*find_by_name(kCommands, "levels"), kExamples);
  declare(line, options);
  if (!line.parse(arguments)) return;
  if (options.c && (options.json || !options.nearest.empty())) {
    throw Error(ErrorKind::kMisuse, "--c",
                "does not go with " + std::string(options.json ? "--json" : "--nearest"),
                "give one of them");
  }
  if (!options.nearest.empty()) return print_nearest(options);
  const std::vector<double> levels = intensity_levels(options.table);
  const std::vector<int> codes = level_codes(levels, options.gamma, options.vmax, options.k);
  if (options.c) return print(c_text(options, codes));
  const Json table = facts(options, levels, codes);
  print(options.json ? json_line(table) : table_text(table));
}

}  // namespace tristim::tools
