#include <cctype>
#include <filesystem>
#include <fstream>

#include "tools/commands.h"
#include "tools/palette_picture.h"
#include "tools/report.h"
#include "tristim/color/parse.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim palette check red green blue\n"
    "  tristim palette check --background white navy crimson '#228b22' --json\n"
    "  printf 'navy\\n#ffd700 # gold\\n' > brand.txt && tristim palette check brand.txt\n"
    "  tristim render spheres -o spheres.exr && tristim palette check spheres.exr\n";

struct Options {
  std::vector<std::string> words;
  std::string background;
  bool json = false;
};

ChartColor parse_chart_color(std::string_view text, const std::string& place) {
  const auto color = parse_color(text);
  if (color) return chart_color(*color);
  throw Error(ErrorKind::kContent, place, "'" + std::string(text) + "' is no colour",
              color_hint(text));
}

// The words of a line in front of a comment, which begins with '#' and a blank.
std::vector<ChartColor> colors_of_line(std::string_view line, const std::string& place) {
  std::vector<ChartColor> colors;
  for (std::string_view word : split(line, ' ')) {
    while (!word.empty() && (word.back() == '\r' || word.back() == ',' || word.back() == '\t')) {
      word.remove_suffix(1);
    }
    if (word == "#") break;
    if (!word.empty()) colors.push_back(parse_chart_color(word, place));
  }
  return colors;
}

std::vector<ChartColor> colors_of_text(std::string_view text, const std::string& path) {
  std::vector<ChartColor> colors;
  int number = 0;
  for (const std::string_view line : split(text, '\n')) {
    const std::string place = path + ", row " + std::to_string(++number);
    for (ChartColor& color : colors_of_line(line, place)) colors.push_back(std::move(color));
  }
  return colors;
}

// Pictures begin with bytes that no list of colours has.
bool is_text(std::string_view bytes) {
  constexpr std::string_view kBlanks = "\t\n\r";
  for (const char c : bytes.substr(0, 256)) {
    if (static_cast<unsigned char>(c) < ' ' && kBlanks.find(c) == std::string_view::npos) {
      return false;
    }
    if (static_cast<unsigned char>(c) >= 127) return false;
  }
  return !(bytes.size() > 1 && bytes[0] == 'P' && bytes[1] >= '1' && bytes[1] <= '7');
}

// The first bytes of a file, enough to tell text from a picture; none where it cannot be read.
std::string head_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string head(256, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  return head;
}

// A word alone that is no colour is a file where there is one, or where it looks like one.
bool names_file(const Options& options) {
  if (options.words.size() != 1 || parse_color(options.words.front())) return false;
  std::error_code ignored;
  const std::filesystem::path path = options.words.front();
  const std::string extension = path.extension().string();
  return std::filesystem::exists(path, ignored) || path.has_parent_path() ||
         (extension.size() > 1 && std::isalpha(static_cast<unsigned char>(extension[1])) != 0);
}

Chart chart_of(const Options& options, std::optional<ChartColor> background) {
  const std::string& first = options.words.front();
  if (!names_file(options)) {
    std::vector<ChartColor> colors;
    for (const std::string& word : options.words) {
      colors.push_back(parse_chart_color(word, "palette check"));
    }
    return palette_chart(std::move(colors), std::move(background));
  }
  if (is_text(without_utf8_mark(head_of(first)))) {
    const std::string text = read_text_file(first);
    return palette_chart(colors_of_text(without_utf8_mark(text), first), std::move(background));
  }
  Chart chart = picture_chart(first);
  chart.background = std::move(background);
  return chart;
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

void print_json(const Chart& chart) {
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
  print(json_line(Json{{"colors", colors_json(chart)}, {"guidelines", rules}}));
}

void print_text(const Chart& chart) {
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
  print(text);
}

}  // namespace

void run_palette(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "palette"), kExamples);
  line.positional("check FILE|COLORS...",
                  "colours (#rrggbb, CSS names), or one file: a text of colours, with comments "
                  "behind '# ', or a picture",
                  options.words, 0, 1 << 16);
  line.option("--background", "COLOR", "what the colours are shown on", options.background);
  line.flag("--json", "print the findings as JSON", options.json);
  if (!line.parse(arguments)) return;
  if (options.words.empty() || !same_name(options.words.front(), "check")) {
    throw Error(ErrorKind::kMisuse, "palette", "an action is missing", "write palette check ...");
  }
  options.words.erase(options.words.begin());
  if (options.words.empty()) {
    throw Error(ErrorKind::kMisuse, "palette check", "no colours are given",
                "give colours, or a file of colours, or a picture");
  }
  std::optional<ChartColor> background;
  if (!options.background.empty()) {
    const auto color = parse_color(options.background);
    if (!color) {
      throw Error(ErrorKind::kMisuse, "--background", "'" + options.background + "' is no colour",
                  color_hint(options.background));
    }
    background = chart_color(*color);
  }
  const Chart chart = chart_of(options, std::move(background));
  if (chart.colors.empty()) {
    throw Error(ErrorKind::kContent, options.words.front(), "holds no colours");
  }
  options.json ? print_json(chart) : print_text(chart);
}

}  // namespace tristim::tools
