#include <algorithm>

#include "tools/palette_actions.h"
#include "tools/palette_source.h"
#include "tools/report.h"
#include "tools/swatches.h"
#include "tristim/color/conversion.h"
#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"
#include "tristim/palette/separation.h"

namespace tristim::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view kExamples =
    "  tristim palette show vga16\n"
    "  tristim palette show tomato teal gold --json\n"
    "  tristim render spheres -o spheres.exr\n"
    "  tristim process spheres.exr --device vga16 -o vga.png && tristim palette show vga.png\n"
    "  NO_COLOR=1 tristim palette show epaper-7color\n";

constexpr std::size_t kMostCompared = 4096;  // colours whose nearest is looked for

// Names of colours in a list of names.
class Namer {
 public:
  explicit Namer(std::string_view model)
      : conversion_(parse_model("rgb", "palette show"), parse_model(model, "palette show"),
                    Adaptation::kBradford) {}

  // "" for what is outside of the names' colours.
  std::string name(const EncodedRgb& c) const {
    const Components components = conversion_({c.r, c.g, c.b, 0});
    return components[0] == components[0] ? conversion_.to().to_text(components) : "";
  }

 private:
  ColorConversion conversion_;
};

struct Row {
  std::size_t position = 0;
  const PaletteColor* color = nullptr;
  std::string css, iscc_nbs;
  std::optional<std::uint64_t> pixels;
  std::optional<ColorPair> nearest;
};

std::vector<Row> rows_of(const PaletteSource& source) {
  const auto& colors = source.palette.colors;
  std::vector<ColorPair> nearest;
  if (colors.size() <= kMostCompared) {
    std::vector<Lab> labs;
    for (const Rgb& light : palette_light(source.palette)) labs.push_back(lab_of_srgb(light));
    nearest = nearest_others(labs);
  }
  const Namer css("css");
  const Namer iscc_nbs("iscc-nbs");
  std::vector<Row> rows;
  for (std::size_t i = 0; i < colors.size(); ++i) {
    Row row{i, &colors[i], css.name(colors[i].color), iscc_nbs.name(colors[i].color), {}, {}};
    if (!source.pixels.empty()) row.pixels = source.pixels[i];
    if (!nearest.empty()) row.nearest = nearest[i];
    rows.push_back(std::move(row));
  }
  return rows;
}

Json row_json(const Row& row) {
  const PaletteColor& entry = *row.color;
  const EncodedRgb& c = entry.color;
  Json json{{"index", row.position}};
  if (entry.code) json["code"] = *entry.code;
  json["hex"] = hex_text(c);
  json["rgb"] = {c.r, c.g, c.b};
  if (entry.alpha < 1) json["alpha"] = entry.alpha;
  if (!entry.name.empty()) json["name"] = entry.name;
  json["css"] = row.css;
  json["iscc_nbs"] = row.iscc_nbs;
  if (row.pixels) json["pixels"] = *row.pixels;
  if (row.nearest) {
    json["nearest"] = {{"index", row.nearest->second}, {"ciede2000", row.nearest->difference}};
  }
  return json;
}

void print_json(const PaletteSource& source, const std::vector<Row>& rows) {
  Json colors = Json::array();
  for (const Row& row : rows) colors.push_back(row_json(row));
  print(
      json_line(Json{{"palette", source.name}, {"name", source.palette.name}, {"colors", colors}}));
}

// A column of a table: its heading and what each row has in it.
struct Column {
  std::string heading;
  std::vector<std::string> cells;
  bool right = false;  // numbers stand to the right
};

template <typename Text>
Column column(std::string heading, const std::vector<Row>& rows, bool right, Text&& text) {
  Column result{std::move(heading), {}, right};
  for (const Row& row : rows) result.cells.push_back(one_line(text(row)));
  return result;
}

// Places of a terminal that a text of UTF-8 takes.
std::size_t width_of(const std::string& text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

std::string padded(const std::string& text, std::size_t width, bool right) {
  const std::string blanks(width - width_of(text), ' ');
  return right ? blanks + text : text + blanks;
}

std::vector<Column> columns_of(const std::vector<Row>& rows) {
  const auto any = [&](auto&& is) { return std::ranges::any_of(rows, is); };
  std::vector<Column> columns;
  columns.push_back(
      column("index", rows, true, [](const Row& r) { return std::to_string(r.position); }));
  if (any([](const Row& r) { return r.color->code.has_value(); })) {
    columns.push_back(column("code", rows, true, [](const Row& r) {
      return r.color->code ? std::to_string(*r.color->code) : "";
    }));
  }
  columns.push_back(
      column("hex", rows, false, [](const Row& r) { return hex_text(r.color->color); }));
  if (any([](const Row& r) { return r.color->alpha < 1; })) {
    columns.push_back(
        column("alpha", rows, true, [](const Row& r) { return rounded(r.color->alpha, 3); }));
  }
  if (any([](const Row& r) { return !r.color->name.empty(); })) {
    columns.push_back(column("name", rows, false, [](const Row& r) { return r.color->name; }));
  }
  columns.push_back(column("CSS", rows, false, [](const Row& r) { return r.css; }));
  columns.push_back(column("ISCC-NBS", rows, false, [](const Row& r) { return r.iscc_nbs; }));
  if (any([](const Row& r) { return r.pixels.has_value(); })) {
    columns.push_back(
        column("pixels", rows, true, [](const Row& r) { return std::to_string(*r.pixels); }));
  }
  if (any([](const Row& r) { return r.nearest.has_value(); })) {
    columns.push_back(column("nearest", rows, true, [](const Row& r) {
      return rounded(r.nearest->difference, 3) + " to " + std::to_string(r.nearest->second);
    }));
  }
  return columns;
}

void print_text(const PaletteSource& source, const std::vector<Row>& rows, TerminalColors colors) {
  std::vector<Column> columns = columns_of(rows);
  std::vector<std::size_t> widths;
  for (const Column& one : columns) {
    std::size_t width = one.heading.size();
    for (const std::string& cell : one.cells) width = std::max(width, width_of(cell));
    widths.push_back(width);
  }
  const std::string title = source.palette.name.empty() ? source.name : source.palette.name;
  std::string text = one_line(title) + ": " + std::to_string(rows.size()) +
                     (rows.size() == 1 ? " colour\n" : " colours\n");
  const bool patches = colors != TerminalColors::kNone;
  for (std::size_t y = 0; y <= rows.size(); ++y) {
    std::string line =
        patches ? "  " + (y == 0 ? std::string(4, ' ') : swatch(rows[y - 1].color->color, colors))
                : "";
    for (std::size_t x = 0; x < columns.size(); ++x) {
      const Column& one = columns[x];
      line += "  " + padded(y == 0 ? one.heading : one.cells[y - 1], widths[x], one.right);
    }
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  }
  print(text);
}

}  // namespace

void run_palette_show(Arguments arguments) {
  std::vector<std::string> words;
  std::string when = "auto";
  bool json = false;
  CommandLine line(palette_action("show"), kExamples);
  line.positional("P|COLORS...",
                  "a palette: a file, a device, or a picture (- is standard input); or colours",
                  words, 1, 1 << 16);
  line.option("--color", list_names(kColorWhens, "|"),
              "swatches: by what the terminal can, NO_COLOR and COLORTERM, or whatever those say; "
              "default: auto",
              when);
  line.flag("--json", "print the facts as JSON", json);
  if (!line.parse(arguments)) return;
  const auto* known = find_by_name(kColorWhens, when);
  if (known == nullptr) {
    throw Error(ErrorKind::kMisuse, "--color", "unknown choice '" + when + "'",
                name_hint(kColorWhens, when));
  }
  const PaletteSource source = load_palette(words, "palette show");
  const std::vector<Row> rows = rows_of(source);
  json ? print_json(source, rows) : print_text(source, rows, terminal_colors(known->name));
}

}  // namespace tristim::tools
