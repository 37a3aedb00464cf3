#include <algorithm>
#include <cmath>

#include "tools/commands.h"
#include "tools/report.h"
#include "tristim/color/models.h"
#include "tristim/color/parse.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim convert --from rgb:srgb --to lab 1 0.5 0\n"
    "  tristim convert --to oklab '#ff8000' rebeccapurple\n"
    "  tristim convert --from xyz --to rgb:ntsc1953 0.3 0.4 -0.1 --explain\n"
    "  printf '0.2 0.3 0.4\\n1 1 1\\n' | tristim convert --from linear:display-p3 --to xyz@d50\n"
    "  tristim convert --list\n";

struct Options {
  std::string from = "rgb:srgb", to;
  Adaptation adaptation = Adaptation::kBradford;
  std::vector<std::string> words;
  bool explain = false, json = false, list = false;
};

std::optional<double> component(std::string_view text) {
  if (same_name(text, "none")) return std::nan("");
  return parse_number(text);
}

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == '\r'; }

std::vector<std::string> words_of(std::string_view line) {
  std::vector<std::string> words;
  std::string word;
  for (const char c : line) {
    if (!is_separator(c)) {
      word += c;
    } else if (!word.empty()) {
      words.push_back(std::move(word));
      word.clear();
    }
  }
  if (!word.empty()) words.push_back(std::move(word));
  return words;
}

// Turns rows of numbers and colour names into components of the source model.
class RowReader {
 public:
  RowReader(const ModelReference& from, std::string place)
      : from_(from),
        named_(parse_model("rgb:srgb", "--from"), from, Adaptation::kBradford),
        place_(std::move(place)) {}

  void read(const std::vector<std::string>& words, std::vector<Components>& rows) {
    for (const std::string& word : words) add(word, rows);
  }

  // At the end of a row: whole colours only.
  void end_row(const std::string& row) {
    if (count_ == 0) return;
    throw Error(ErrorKind::kContent, place_ + row,
                std::to_string(count_) + " numbers are left over",
                "model " + std::string(from_.model->name) +
                    " has 3: " + std::string(from_.model->components));
  }

  void set_row(std::string row) { row_ = std::move(row); }

 private:
  void add(const std::string& word, std::vector<Components>& rows) {
    if (const auto number = component(word)) {
      pending_[count_++] = *number;
      if (count_ == 3) {
        rows.push_back(pending_);
        count_ = 0;
      }
      return;
    }
    const auto color = parse_color(word);
    if (!color || count_ != 0) {
      throw Error(ErrorKind::kContent, place_ + row_, "'" + word + "' is no number",
                  count_ != 0 ? "a colour has 3 numbers" : color_hint(word));
    }
    rows.push_back(named_({color->r, color->g, color->b}));
  }

  ModelReference from_;
  ColorConversion named_;  // sRGB to the source model, for names
  std::string place_, row_;
  Components pending_{};
  std::size_t count_ = 0;
};

std::vector<Components> read_rows(const Options& options, const ModelReference& from) {
  std::vector<Components> rows;
  if (!options.words.empty()) {
    RowReader reader(from, "arguments");
    for (const std::string& word : options.words) reader.read(words_of(word), rows);
    reader.end_row("");
    return rows;
  }
  RowReader reader(from, "standard input");
  const std::string text = read_text_file("-");
  std::size_t number = 0;
  for (std::string_view line : split(text, '\n')) {
    ++number;
    // '#' begins a comment, but #ff8000 is a colour: a comment's '#' is followed by a blank or
    // comes after numbers.
    const std::size_t comment = line.find("# ");
    const std::vector<std::string> words = words_of(line.substr(0, comment));
    const std::string row = ", row " + std::to_string(number);
    reader.set_row(row);
    reader.read(words, rows);
    reader.end_row(row);
  }
  return rows;
}

std::string component_text(double value) { return std::isnan(value) ? "none" : shortest(value); }

void list_models(bool json) {
  Json all = Json::array();
  std::string text;
  for (const ColorModel& model : color_models()) {
    all.push_back({{"model", model.name},
                   {"components", model.components},
                   {"ranges", model.ranges},
                   {"formula", model.formula},
                   {"source", model.source}});
    std::string name(model.name);
    name += model.has_primaries ? ":SET" : model.fixed_white ? "" : "[@WHITE]";
    name.resize(16, ' ');
    std::string components(model.components);
    components.resize(10, ' ');
    text += name + components + std::string(model.ranges) + "  " + std::string(model.source) + "\n";
  }
  text += "SET: " + list_names(primaries_list()) + "\nWHITE: " + list_names(kWhitePoints) + "\n";
  print(json ? all.dump(2) + "\n" : text);
}

void print_rows(const Options& options, const ColorConversion& conversion,
                const std::vector<Components>& rows) {
  Json list = Json::array();
  std::string text;
  for (const Components& row : rows) {
    const Components out = conversion(row);
    list.push_back({number_json(out[0]), number_json(out[1]), number_json(out[2])});
    text +=
        component_text(out[0]) + " " + component_text(out[1]) + " " + component_text(out[2]) + "\n";
  }
  if (!options.json) return print(text);
  print(Json{{"from", options.from}, {"to", options.to}, {"rows", list}}.dump() + "\n");
}

}  // namespace

void run_convert(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "convert"), kExamples);
  line.positional("VALUES", "colours: numbers, #rrggbb, CSS names; else rows of standard input",
                  options.words, 0, 1 << 20);
  line.option("--from", "MODEL", "default rgb:srgb", options.from);
  line.option("--to", "MODEL", "such as lab, xyz@d50, linear:display-p3", options.to);
  line.option("--adapt", list_names(kAdaptations), "from white to white; default bradford",
              [&](const std::string& v) {
                const AdaptationMethod* method = find_by_name(kAdaptations, v);
                if (method == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--adapt", "unknown adaptation '" + v + "'",
                              name_hint(kAdaptations, v));
                }
                options.adaptation = method->method;
              });
  line.flag("--explain", "print the way between the models first", options.explain);
  line.flag("--json", "print the rows as JSON", options.json);
  line.flag("--list", "print the models with their ranges and sources", options.list);
  if (!line.parse(arguments)) return;
  if (options.list) return list_models(options.json);
  if (options.to.empty()) {
    throw Error(ErrorKind::kMisuse, "--to", "is missing",
                "give one of " + list_names(color_models()));
  }
  const ModelReference from = parse_model(options.from, "--from");
  const ModelReference to = parse_model(options.to, "--to");
  const ColorConversion conversion(from, to, options.adaptation);
  const std::vector<Components> rows = read_rows(options, from);
  if (options.explain && !options.json) {
    for (const std::string& step : conversion.explain()) print(step + "\n");
  }
  print_rows(options, conversion, rows);
}

}  // namespace tristim::tools
