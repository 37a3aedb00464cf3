#include "tools/convert_rows.h"

#include <cmath>
#include <optional>

#include "tristim/color/conversion.h"
#include "tristim/color/parse.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::tools {
namespace {

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

std::string joined(const std::vector<std::string>& words) {
  std::string all;
  for (const std::string& word : words) all += (all.empty() ? "" : " ") + word;
  return all;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_separator(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_separator(text.back())) text.remove_suffix(1);
  return text;
}

// The line up to its comment. A '#' in front may begin a colour: #ff8000.
std::string_view without_comment(std::string_view line) {
  const std::string_view text = trimmed(line);
  const std::string_view first = text.substr(0, text.find_first_of(" \t,\r"));
  const bool color = first.starts_with('#') && parse_color(first);
  return trimmed(text.substr(0, text.find('#', color ? 1 : 0)));
}

// Whether conversions can end in a model.
bool leads_to(const ColorModel& model) {
  const ColorModel* base = base_of(model);
  return base == nullptr || (model.from_base != nullptr && leads_to(*base));
}

// Turns words into colours of the source model.
class ColorReader {
 public:
  explicit ColorReader(const ModelReference& model)
      : model_(model), count_(component_count(*model.model)) {
    if (leads_to(*model.model)) {
      named_.emplace(parse_model("rgb:srgb", "colour"), model, Adaptation::kBradford);
    }
  }

  /// A whole text that is a colour by itself.
  std::optional<ColorRow> whole(std::string_view text) const {
    if (model_.model->from_text != nullptr) {
      if (const auto values = model_.model->from_text(text)) return ColorRow{*values};
    }
    const auto color = parse_number(text) ? std::nullopt : parse_color(text);
    if (!color || !named_ || words_of(text).size() > 1) return std::nullopt;
    return ColorRow{(*named_)({color->r, color->g, color->b})};
  }

  /// A component; nothing where the word is none.
  static std::optional<double> component(const std::string& word, ColorRow& row) {
    if (same_name(word, "none")) return std::nan("");
    const auto number = parse_number(word);
    if (number && !std::isfinite(*number)) row.odd = true;
    return number;
  }

  std::string expected() const {
    return "give " + std::string(model_.model->components) + " of " +
           std::string(model_.model->name);
  }

  /// Whether colours of the model are words, not numbers.
  bool is_of_words() const { return model_.model->to_text != nullptr; }

  /// Whether the text begins with a word where the model reads words: 11R 5/4.
  bool is_broken_text(std::string_view text) const {
    ColorRow ignored;
    const std::vector<std::string> words = words_of(text);
    return model_.model->text_hint != nullptr && !words.empty() && !component(words[0], ignored) &&
           !parse_color(words[0]);
  }

  [[noreturn]] void refuse_text(const std::string& place, const std::string& text) const {
    const auto hint = model_.model->text_hint;
    throw Error(ErrorKind::kContent, place,
                "'" + text + "' is no colour of " + std::string(model_.model->name),
                hint != nullptr ? hint(text) : expected());
  }

  [[noreturn]] void refuse_word(const std::string& place, const std::string& word,
                                bool begins_color) const {
    if (model_.model->text_hint != nullptr && begins_color) refuse_text(place, word);
    if (!begins_color || parse_color(word)) {
      throw Error(ErrorKind::kContent, place, "'" + word + "' is no number", expected());
    }
    const std::string nearest = color_hint(word);
    const bool near = nearest.starts_with("did you mean");
    throw Error(ErrorKind::kContent, place, "'" + word + "' is no number and no colour",
                near ? nearest : expected() + ", #rrggbb or a CSS name");
  }

  [[noreturn]] void refuse_count(const std::string& place, std::size_t count) const {
    throw Error(ErrorKind::kContent, place,
                std::to_string(count) + (count == 1 ? " number" : " numbers") + " where " +
                    std::to_string(count_) + " are expected",
                expected());
  }

  std::size_t count() const { return count_; }

 private:
  ModelReference model_;
  std::size_t count_;
  std::optional<ColorConversion> named_;  // sRGB to the source model, for names, if it can be
};

}  // namespace

std::vector<ColorRow> read_color_arguments(const std::vector<std::string>& arguments,
                                           const ModelReference& model) {
  const ColorReader reader(model);
  std::vector<ColorRow> rows;
  ColorRow row;
  std::size_t count = 0;
  if (const auto all = reader.whole(joined(arguments))) return {*all};  // 5R 4/14, without quotes
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string place = "value " + std::to_string(i + 1);
    const auto argument = count == 0 ? reader.whole(arguments[i]) : std::nullopt;
    if (argument) {
      rows.push_back(*argument);
      continue;
    }
    if (reader.is_of_words() || (count == 0 && reader.is_broken_text(arguments[i]))) {
      reader.refuse_text(place, arguments[i]);
    }
    for (const std::string& word : words_of(arguments[i])) {
      const auto color = count == 0 ? reader.whole(word) : std::nullopt;
      const auto number = color ? std::nullopt : ColorReader::component(word, row);
      if (!color && !number) reader.refuse_word(place, word, count == 0);
      if (number) row.values[count++] = *number;
      if (number && count < reader.count()) continue;
      rows.push_back(color ? *color : row);
      row = {};
      count = 0;
    }
  }
  if (count > 0) reader.refuse_count("the last colour", count);
  return rows;
}

std::vector<ColorRow> read_color_rows(std::string_view text, const std::string& name,
                                      const ModelReference& model) {
  const ColorReader reader(model);
  text = without_utf8_mark(text);
  std::vector<ColorRow> rows;
  std::size_t line_number = 0;
  for (const std::string_view line : split(text, '\n')) {
    const std::string place = name + ", row " + std::to_string(++line_number);
    const std::string_view content = without_comment(line);
    if (content.empty()) continue;
    if (const auto whole = reader.whole(content)) {
      rows.push_back(*whole);
      rows.back().place = place;
      continue;
    }
    if (reader.is_of_words() || reader.is_broken_text(content)) {
      reader.refuse_text(place, std::string(content));
    }
    const std::vector<std::string> words = words_of(content);
    ColorRow row{.place = place};
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto number = ColorReader::component(words[i], row);
      const std::string column = place + ", column " + std::to_string(i + 1);
      if (!number) reader.refuse_word(column, words[i], i == 0);
      if (i < reader.count()) row.values[i] = *number;
    }
    if (words.size() != reader.count()) reader.refuse_count(place, words.size());
    rows.push_back(row);
  }
  return rows;
}

bool is_color_text(const std::string& text, const ModelReference& model) {
  if (ColorReader(model).whole(text)) return true;
  ColorRow row;
  for (const std::string& word : words_of(text)) {
    if (!ColorReader::component(word, row)) return false;
  }
  return true;
}

}  // namespace tristim::tools
