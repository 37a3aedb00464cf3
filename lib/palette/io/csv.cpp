#include <algorithm>
#include <cmath>

#include "lib/palette/io/formats.h"
#include "lib/palette/io/text_rows.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

struct Column {
  std::string_view name;
  std::string_view short_name;
};
enum { kRed, kGreen, kBlue, kAlpha, kCode, kName, kHex, kColumns };
constexpr Column kColumnNames[kColumns] = {{"red", "r"},    {"green", "g"},   {"blue", "b"},
                                           {"alpha", "a"},  {"code", "code"}, {"name", "label"},
                                           {"hex", "color"}};

using Places = std::array<std::size_t, kColumns>;  // of a column in a row
constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

// The cells of a row; one in quotes may hold commas, and "" for a quote.
std::vector<std::string> cells_of(std::string_view text) {
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"' && quoted && i + 1 < text.size() && text[i + 1] == '"') {
      cells.back() += text[++i];
    } else if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  for (std::string& cell : cells) cell = one_line_name(cell);
  return cells;
}

// Where the columns are by a heading; nothing where the row is no heading.
std::optional<Places> places_of(const std::vector<std::string>& heading) {
  Places places;
  places.fill(kAbsent);
  bool known = false;
  for (std::size_t i = 0; i < heading.size(); ++i) {
    for (std::size_t c = 0; c < kColumns; ++c) {
      const Column& column = kColumnNames[c];
      const bool is =
          same_name(heading[i], column.name) || same_name(heading[i], column.short_name);
      if (is && places[c] == kAbsent) places[c] = i;
      known = known || is;
    }
  }
  return known ? std::optional(places) : std::nullopt;
}

class Reader {
 public:
  Reader(const Places& places, const std::string& file) : places_(places), file_(file) {}

  void read(const std::vector<std::string>& cells, int number) {
    PaletteColor color;
    if (places_[kRed] == kAbsent) {
      const std::string& word = cell(cells, kHex, number);
      const auto parsed = color_of_word(word);
      if (!parsed) fail_row(file_, number, "'" + word + "' is no colour", "write #rrggbb");
      color = *parsed;
      color.name.clear();
    } else {
      color.color = {channel(cells, kRed, number), channel(cells, kGreen, number),
                     channel(cells, kBlue, number)};
    }
    if (places_[kAlpha] != kAbsent) color.alpha = alpha(cells, number);
    if (places_[kCode] != kAbsent) color.code = code(cells, number);
    if (places_[kName] < cells.size()) color.name = cells[places_[kName]];
    palette.colors.push_back(std::move(color));
  }

  // Channels that are integers throughout are codes of 8 bits.
  void finish() {
    if (!integers_ || places_[kRed] == kAbsent) return;
    for (PaletteColor& entry : palette.colors) {
      entry.color = {entry.color.r / 255, entry.color.g / 255, entry.color.b / 255};
    }
  }

  Palette palette;

 private:
  const std::string& cell(const std::vector<std::string>& cells, std::size_t column, int number) {
    if (places_[column] < cells.size()) return cells[places_[column]];
    fail_row(file_, number, "has no cell of the column " + std::string(kColumnNames[column].name));
  }

  double channel(const std::vector<std::string>& cells, std::size_t column, int number) {
    const std::string& word = cell(cells, column, number);
    const auto value = parse_number(word);
    if (!value || !std::isfinite(*value) || std::fabs(*value) > 255) {
      fail_row(file_, number, "'" + word + "' is no channel",
               "write 0 to 255 throughout, or numbers from 0.0 to 1.0");
    }
    integers_ = integers_ && parse_integer(word);
    return *value;
  }

  double alpha(const std::vector<std::string>& cells, int number) {
    const std::string& word = cell(cells, kAlpha, number);
    const auto value = parse_number(word);
    if (!value || !(*value >= 0 && *value <= 1)) {
      fail_row(file_, number, "'" + word + "' is no alpha", "write a number from 0 to 1");
    }
    return *value;
  }

  std::optional<std::uint16_t> code(const std::vector<std::string>& cells, int number) {
    const std::string& word = cell(cells, kCode, number);
    if (word.empty()) return std::nullopt;
    const auto value = parse_integer(word);
    if (!value || *value < 0 || *value > 65535) {
      fail_row(file_, number, "'" + word + "' is no code", "write an integer from 0 to 65535");
    }
    return static_cast<std::uint16_t>(*value);
  }

  Places places_;
  const std::string& file_;
  bool integers_ = true;
};

std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"#") == std::string::npos) return name;
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

}  // namespace

// Without a heading the columns are red, green, blue and name, or colours as one word and name.
Palette read_csv(std::string_view bytes, const std::string& file) {
  std::optional<Reader> reader;
  for (const TextRow& row : text_rows(bytes)) {
    const bool comment = row.text.starts_with("//") || row.text.starts_with("# ");
    if (comment) continue;
    const std::vector<std::string> cells = cells_of(row.text);
    if (!reader) {
      const auto heading = places_of(cells);
      const bool numbers = cells.size() >= 3 && parse_number(cells[0]);
      Places places;
      places.fill(kAbsent);
      if (numbers) {
        for (std::size_t c : {kRed, kGreen, kBlue}) places[c] = c;
        places[kName] = 3;
      } else {
        places[kHex] = 0;
        places[kName] = 1;
      }
      reader.emplace(heading.value_or(places), file);
      const bool colors = !heading || (*heading)[kHex] != kAbsent ||
                          std::count(heading->begin(), heading->begin() + 3, kAbsent) == 0;
      if (!colors) {
        fail_row(file, row.number, "the heading has no column of colours",
                 "name red, green and blue, or hex");
      }
      if (heading) continue;
    }
    reader->read(cells, row.number);
  }
  if (!reader) return {};
  reader->finish();
  return std::move(reader->palette);
}

std::string write_csv(const Palette& palette) {
  const auto& colors = palette.colors;
  const bool alpha = has_alpha(palette);
  const bool codes = std::ranges::any_of(colors, [](const auto& c) { return c.code.has_value(); });
  const bool names = std::ranges::any_of(colors, [](const auto& c) { return !c.name.empty(); });
  const bool integers =
      std::ranges::all_of(colors, [](const auto& c) { return is_8_bits(c.color); });
  std::string text = "hex,red,green,blue";
  if (alpha) text += ",alpha";
  if (codes) text += ",code";
  if (names) text += ",name";
  text += "\n";
  for (const PaletteColor& entry : colors) {
    text += hex_text(entry.color);
    const EncodedRgb& c = entry.color;
    for (const double v : {c.r, c.g, c.b}) {
      text += "," + (integers ? std::to_string(unit_code(v, 255)) : shortest(v));
    }
    if (alpha) text += "," + shortest(entry.alpha);
    if (codes) text += "," + (entry.code ? std::to_string(*entry.code) : "");
    if (names) text += "," + quoted(one_line_name(entry.name));
    text += "\n";
  }
  return text;
}

}  // namespace tristim::detail
