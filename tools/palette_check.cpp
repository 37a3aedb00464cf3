#include <algorithm>

#include "tools/palette_actions.h"
#include "tools/palette_picture.h"
#include "tools/palette_source.h"
#include "tools/report.h"
#include "tristim/color/parse.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"
#include "tristim/palette/separation.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim palette check red green blue\n"
    "  tristim palette check --background white navy crimson '#228b22' --json\n"
    "  printf 'navy\\n#ffd700 # gold\\n' > brand.txt && tristim palette check brand.txt\n"
    "  tristim palette check vga16\n"
    "  tristim render spheres -o spheres.exr && tristim palette check spheres.exr\n";

// How near is too near: what a careful eye tells apart side by side.
constexpr double kJustNoticeable = 2.3;
constexpr std::size_t kMostPairs = 10;     // that text shows
constexpr std::size_t kMostColors = 2048;  // whose pairs are compared

struct Options {
  std::vector<std::string> words;
  std::string background;
  double min_difference = kJustNoticeable;
  bool json = false;
};

// What the eye says about the colours, apart from the guidelines.
struct Separation {
  std::vector<ColorPair> close;
  std::vector<Confusion> confused;
  PaletteCoverage coverage;
};

Separation separation_of(const Chart& chart, double min_difference) {
  if (chart.colors.size() > kMostColors) {
    throw Error(ErrorKind::kMisuse, "palette check",
                "compares the pairs of at most " + std::to_string(kMostColors) + " colours",
                "give fewer");
  }
  std::vector<Rgb> light;
  std::vector<Lab> labs;
  for (const ChartColor& color : chart.colors) {
    light.push_back(color.linear_srgb);
    labs.push_back(lab_of_srgb(color.linear_srgb));
  }
  return {close_pairs(labs, min_difference), confusions(light), palette_coverage(light)};
}

Chart chart_of(const Options& options, std::optional<ChartColor> background) {
  if (names_file(options.words) && is_picture(options.words.front())) {
    Chart chart = picture_chart(options.words.front());
    chart.background = std::move(background);
    return chart;
  }
  std::vector<ChartColor> colors;
  for (const PaletteColor& entry : load_palette(options.words, "palette check").palette.colors) {
    colors.push_back(chart_color(entry.color));
  }
  return palette_chart(std::move(colors), std::move(background));
}

Json colors_json(const Chart& chart) {
  Json colors = Json::array();
  for (const ChartColor& color : chart.colors) {
    Json one{{"color", color.name}};
    if (chart.has_places) one["pixels"] = color.count;
    if (chart.background) {
      one["contrast"] = contrast_ratio(color.linear_srgb, chart.background->linear_srgb);
    }
    colors.push_back(one);
  }
  return colors;
}

std::string pair_text(const Chart& chart, const ColorPair& pair) {
  return chart.colors[pair.first].name + " and " + chart.colors[pair.second].name;
}

Json pair_json(const Chart& chart, const ColorPair& pair) {
  return Json{{"first", pair.first},
              {"second", pair.second},
              {"colors", {chart.colors[pair.first].name, chart.colors[pair.second].name}},
              {"ciede2000", pair.difference}};
}

void add_separation(Json& json, const Chart& chart, const Separation& separation) {
  json["close_pairs"] = Json::array();
  for (const ColorPair& pair : separation.close) {
    json["close_pairs"].push_back(pair_json(chart, pair));
  }
  json["confusions"] = Json::array();
  for (const Confusion& confusion : separation.confused) {
    Json one{{"deficiency", confusion.deficiency->name}};
    one.update(pair_json(chart, confusion.pair));
    one["deficient_ciede2000"] = confusion.difference;
    json["confusions"].push_back(one);
  }
  const PaletteCoverage& coverage = separation.coverage;
  json["coverage"] = {{"mixed_share", coverage.mixed},
                      {"mean_ciede2000", coverage.mean},
                      {"max_ciede2000", coverage.farthest}};
}

std::string and_more(std::size_t count) {
  return count > kMostPairs ? "  and " + std::to_string(count - kMostPairs) + " more\n" : "";
}

std::string separation_text(const Chart& chart, const Separation& separation,
                            double min_difference) {
  const auto& [close, confused, coverage] = separation;
  std::string text = "\ntoo close (CIEDE2000 below " + shortest(min_difference) +
                     "): " + (close.empty() ? "none" : std::to_string(close.size()) + " pairs") +
                     "\n";
  for (std::size_t i = 0; i < std::min(close.size(), kMostPairs); ++i) {
    text += "  " + pair_text(chart, close[i]) + ": " + rounded(close[i].difference, 3) + "\n";
  }
  text += and_more(close.size());
  text += "confused with a colour deficiency: " +
          (confused.empty() ? "none" : std::to_string(confused.size()) + " pairs") + "\n";
  for (std::size_t i = 0; i < std::min(confused.size(), kMostPairs); ++i) {
    const Confusion& one = confused[i];
    text += "  " + std::string(one.deficiency->name) + ": " + pair_text(chart, one.pair) + ": " +
            rounded(one.pair.difference, 3) + " become " + rounded(one.difference, 3) + "\n";
  }
  text += and_more(confused.size());
  return text + "gamut: mixed in light the colours make " + rounded(100 * coverage.mixed, 3) +
         " % of sRGB; without dither a colour of it is " + rounded(coverage.mean, 3) +
         " from the nearest one on average, " + rounded(coverage.farthest, 3) +
         " at most (CIEDE2000)\n";
}

void print_json(const Chart& chart, const Separation& separation) {
  Json rules = Json::array();
  for (const Guideline& guideline : guidelines()) {
    const Finding finding = judge(guideline, chart);
    Json measures = Json::object();
    for (const auto& [name, value] : finding.measures) measures[name] = number_json(value);
    rules.push_back({{"guideline", guideline.number},
                     {"text", guideline.text},
                     {"verdict", verdict_name(finding.verdict)},
                     {"finding", finding.text},
                     {"measure", guideline.measure},
                     {"measures", measures}});
  }
  Json json{{"colors", colors_json(chart)}, {"guidelines", rules}};
  add_separation(json, chart, separation);
  print(json_line(json));
}

void print_text(const Chart& chart, const Separation& separation, double min_difference) {
  std::string text = std::to_string(chart.colors.size()) + " colors [Shoaff 2.2.11]\n";
  if (chart.background) {
    text += "contrast to the background " + chart.background->name + ":";
    for (const ChartColor& color : chart.colors) {
      text += " " + color.name + " " +
              rounded(contrast_ratio(color.linear_srgb, chart.background->linear_srgb), 3);
    }
    text += "\n";
  }
  for (const Guideline& guideline : guidelines()) {
    const Finding finding = judge(guideline, chart);
    text += "\n" + std::to_string(guideline.number) + ". " + std::string(guideline.text) + "\n   " +
            std::string(verdict_name(finding.verdict)) + ": " + finding.text + "\n";
    if (!finding.measures.empty()) text += "   measure: " + std::string(guideline.measure) + "\n";
  }
  print(text + separation_text(chart, separation, min_difference));
}

std::optional<ChartColor> background_of(const Options& options) {
  if (options.background.empty()) return std::nullopt;
  if (const auto color = parse_color(options.background)) return chart_color(*color);
  throw Error(ErrorKind::kMisuse, "--background", "'" + options.background + "' is no colour",
              color_hint(options.background));
}

}  // namespace

void run_palette_check(Arguments arguments) {
  Options options;
  CommandLine line(palette_action("check"), kExamples);
  line.positional("P|COLORS...",
                  "colours (#rrggbb, CSS names), or one palette: a file, a device, or a picture",
                  options.words, 0, 1 << 16);
  line.option("--background", "COLOR", "what the colours are shown on", options.background);
  line.option("--min-difference", "D",
              "CIEDE2000 below which two colours are too close; default: 2.3",
              [&](const std::string& v) {
                options.min_difference = number_option("--min-difference", v, 0, 100);
              });
  line.flag("--json", "print the findings as JSON", options.json);
  if (!line.parse(arguments)) return;
  if (options.words.empty()) {
    throw Error(ErrorKind::kMisuse, "palette check", "no colours are given",
                "give colours, or a file of colours, or a picture");
  }
  const Chart chart = chart_of(options, background_of(options));
  const Separation separation = separation_of(chart, options.min_difference);
  options.json ? print_json(chart, separation)
               : print_text(chart, separation, options.min_difference);
}

}  // namespace tristim::tools
