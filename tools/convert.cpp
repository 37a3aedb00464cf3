#include <unistd.h>

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

// A colour to convert, and whether it was given as "nan" or without end: then what comes out
// undefined is "nan" too, not "none".
struct Row {
  Components values{};
  bool odd = false;
};

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

// Turns numbers and colour names into components of the source model.
class RowReader {
 public:
  explicit RowReader(const ModelReference& from)
      : from_(from), named_(parse_model("rgb:srgb", "--from"), from, Adaptation::kBradford) {}

  /// The colours of `words`; `place` is for messages.
  std::vector<Row> read(const std::vector<std::string>& words, const std::string& place) const {
    std::vector<Row> rows;
    Row row;
    std::size_t count = 0;
    for (const std::string& word : words) {
      if (const auto number = component(word, row)) {
        row.values[count++] = *number;
      } else if (const auto color = parse_color(word); color && count == 0) {
        row.values = named_({color->r, color->g, color->b});
        count = kComponents;
      } else {
        throw Error(ErrorKind::kContent, place,
                    "'" + word + "' is " + (color ? "no number" : "no number and no colour"),
                    color ? give_all() : hint(word));
      }
      if (count < kComponents) continue;
      rows.push_back(row);
      row = {};
      count = 0;
    }
    if (count == 0) return rows;
    throw Error(ErrorKind::kContent, place,
                "the last colour has " + std::to_string(count) + " of its 3 numbers", give_all());
  }

 private:
  static constexpr std::size_t kComponents = 3;

  static std::optional<double> component(std::string_view text, Row& row) {
    if (same_name(text, "none")) return std::nan("");
    const auto number = parse_number(text);
    if (number && !std::isfinite(*number)) row.odd = true;
    return number;
  }

  std::string give_all() const {
    return "give " + std::string(from_.model->components) + " of " + std::string(from_.model->name);
  }

  std::string hint(const std::string& word) const {
    if (word.starts_with('#')) return "a colour is #rrggbb, a comment begins with '# '";
    const std::string nearest = color_hint(word);
    return nearest.starts_with("did you mean") ? nearest : give_all() + ", #rrggbb or a CSS name";
  }

  ModelReference from_;
  ColorConversion named_;  // sRGB to the source model, for names
};

std::string standard_input() {
  if (isatty(STDIN_FILENO) == 1) {
    throw Error(ErrorKind::kMisuse, "convert", "no colours are given",
                "give numbers or names, or pipe rows into standard input");
  }
  return read_text_file("-");
}

// Without what stands behind a '#' that is a word of its own: #ff8000 is a colour.
std::vector<std::string> without_comment(std::vector<std::string> words) {
  words.erase(std::find(words.begin(), words.end(), "#"), words.end());
  return words;
}

std::vector<Row> read_rows(const Options& options, const ModelReference& from) {
  const RowReader reader(from);
  if (!options.words.empty()) {
    std::vector<std::string> words;
    for (const std::string& argument : options.words) {
      for (std::string& word : words_of(argument)) words.push_back(std::move(word));
    }
    return reader.read(words, "arguments");
  }
  std::vector<Row> rows;
  const std::string text = standard_input();
  std::string_view rest = text;
  if (rest.starts_with("\xef\xbb\xbf")) rest.remove_prefix(3);  // the mark of UTF-8 files
  std::size_t number = 0;
  for (const std::string_view line : split(rest, '\n')) {
    const std::string place = "standard input, row " + std::to_string(++number);
    const std::vector<Row> colors = reader.read(without_comment(words_of(line)), place);
    if (colors.size() > 1) {
      throw Error(ErrorKind::kContent, place, std::to_string(colors.size()) + " colours in a row",
                  "give one");
    }
    rows.insert(rows.end(), colors.begin(), colors.end());
  }
  return rows;
}

std::string component_text(double value, bool odd) {
  return std::isnan(value) && !odd ? "none" : shortest(value);
}

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
  print(json ? json_line(all) : text);
}

void print_rows(const Options& options, const ColorConversion& conversion,
                const std::vector<Row>& rows) {
  Json list = Json::array();
  std::string text;
  for (const Row& row : rows) {
    const Components out = conversion(row.values);
    list.push_back({number_json(out[0]), number_json(out[1]), number_json(out[2])});
    text += component_text(out[0], row.odd) + " " + component_text(out[1], row.odd) + " " +
            component_text(out[2], row.odd) + "\n";
  }
  if (!options.json) return print(text);
  Json json{{"from", options.from}, {"to", options.to}, {"rows", list}};
  if (options.explain) json["steps"] = conversion.explain();
  print(json_line(json));
}

}  // namespace

void run_convert(Arguments arguments) {
  Options options;
  CommandLine line(*find_by_name(kCommands, "convert"), kExamples);
  line.positional("VALUES...",
                  "colours: numbers, #rrggbb, CSS names; without any: rows of standard input, "
                  "a colour each, with comments from # on",
                  options.words, 0, 1 << 20);
  line.option("--from", "MODEL", "default: rgb:srgb", options.from);
  line.option("--to", "MODEL", "such as lab, xyz@d50, linear:display-p3; see --list", options.to);
  line.option("--adapt", list_names(kAdaptations, "|"), "from white to white; default: bradford",
              [&](const std::string& v) {
                const AdaptationMethod* method = find_by_name(kAdaptations, v);
                if (method == nullptr) {
                  throw Error(ErrorKind::kMisuse, "--adapt", "unknown adaptation '" + v + "'",
                              name_hint(kAdaptations, v));
                }
                options.adaptation = method->method;
              });
  line.flag("--explain", "print the way between the models first", options.explain);
  line.flag("--json", "print the colours as JSON", options.json);
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
  const std::vector<Row> rows = read_rows(options, from);
  if (options.explain && !options.json) {
    for (const std::string& step : conversion.explain()) print(step + "\n");
  }
  print_rows(options, conversion, rows);
}

}  // namespace tristim::tools
