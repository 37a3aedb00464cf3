#include "tristim/device/display_file.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "lib/color/toml_color.h"
#include "lib/core/toml.h"
#include "lib/device/embedded.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::read_appearance;
using detail::read_chromaticity;
using detail::read_white_point;
using detail::TomlTable;

// A member of `list` named by the string at `key`; `fallback` where the key is absent.
template <typename List, typename Item>
Item choice(const TomlTable& table, std::string_view key, const List& list, Item fallback) {
  const auto name = table.string(key);
  if (!name) return fallback;
  if (const auto* item = find_by_name(list, *name)) return *item;
  table.fail(key, "unknown " + std::string(key) + " '" + *name + "'", name_hint(list, *name));
}

double number_in(const TomlTable& table, std::string_view key, double fallback, double low,
                 double high, std::string_view range) {
  const double value = table.number(key).value_or(fallback);
  if (value >= low && value <= high) return value;
  table.fail(key, std::string(key) + " = " + shortest(value) + " is out of range",
             "give a number " + std::string(range));
}

constexpr double kTiny = 1e-12;  // open ends of ranges

FrameLayout read_frame(const TomlTable& root) {
  FrameLayout layout;
  const auto table = root.table("frame_buffer");
  if (!table) return layout;
  layout.packing = choice(*table, "packing", kPackings, kPackings[0]);
  layout.bit_order = choice(*table, "bit_order", kBitOrders, kBitOrders[0]).order;
  layout.byte_order = choice(*table, "byte_order", kByteOrders, kByteOrders[0]).order;
  layout.store = choice(*table, "store", kStores, kStores[0]).store;
  table->finish();
  return layout;
}

std::optional<PanelSize> read_panel(const TomlTable& root) {
  const auto table = root.table("panel");
  if (!table) return std::nullopt;
  std::optional<PanelSize> size;
  if (const auto numbers = table->numbers("size")) {
    const bool good = numbers->size() == 2 && table->all_integers("size") &&
                      std::all_of(numbers->begin(), numbers->end(),
                                  [](double v) { return v >= 1 && v <= 65535; });
    if (!good) table->fail("size", "size is no panel size", "give [width, height] in pixels");
    size = PanelSize{static_cast<int>((*numbers)[0]), static_cast<int>((*numbers)[1])};
  }
  table->finish();
  return size;
}

Primaries read_primaries(const TomlTable& root) {
  const auto table = root.table("primaries");
  if (!table) return {};
  Primaries primaries;
  if (const auto set = table->string("set")) {
    const NamedPrimaries* found = find_by_name(primaries_list(), *set);
    if (found == nullptr) {
      table->fail("set", "unknown primaries '" + *set + "'", name_hint(primaries_list(), *set));
    }
    primaries = found->primaries;
  } else {
    primaries.red = read_chromaticity(*table, "red");
    primaries.green = read_chromaticity(*table, "green");
    primaries.blue = read_chromaticity(*table, "blue");
  }
  const auto luminance = table->numbers("luminance");
  if (luminance && table->has("white")) {
    table->fail("luminance", "both luminance and white are given", "give one of them");
  }
  try {
    if (luminance) {
      if (luminance->size() != 3) table->fail("luminance", "luminance must be [Yr, Yg, Yb]");
      primaries.white =
          white_from_luminances(primaries, (*luminance)[0], (*luminance)[1], (*luminance)[2]);
    } else if (table->has("white")) {
      primaries.white = read_white_point(*table, "white");
    }
    (void)xyz_from_rgb(primaries);
  } catch (const std::invalid_argument& bad) {
    table->fail("", bad.what(), "check red, green, blue and white in [primaries]");
  }
  table->finish();
  return primaries;
}

bool strictly_ascending(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

TableResponse checked_table(const TomlTable& table, std::string_view key,
                            const std::vector<std::vector<double>>& rows, double code_max) {
  TableResponse response;
  for (const auto& row : rows) {
    if (row.size() != 2) table.fail(key, "a row is no pair", "give [code, luminance] pairs");
    response.code.push_back(row[0]);
    response.luminance.push_back(row[1]);
  }
  if (rows.size() < 2) table.fail(key, "a measured table needs at least 2 rows");
  if (!strictly_ascending(response.code) || !strictly_ascending(response.luminance)) {
    table.fail(key, "the measured table is not ascending",
               "sort the rows by code; luminance must rise from row to row");
  }
  if (response.code.front() < 0 || response.code.back() > code_max ||
      response.luminance.front() < 0) {
    table.fail(key, "the measured table leaves the codes 0.." + shortest(code_max) +
                        " or has negative luminance");
  }
  return response;
}

std::vector<std::vector<double>> csv_rows(const TomlTable& table, const std::string& path) {
  std::vector<std::vector<double>> rows;
  const std::string text = read_text_file(path, std::size_t{1} << 20);
  for (std::string_view line : split(text, '\n')) {
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.empty() || line.starts_with('#')) continue;
    const std::vector<std::string_view> cells = split(line, ',');
    std::vector<double> row;
    for (std::string_view cell : cells) {
      while (cell.starts_with(' ')) cell.remove_prefix(1);
      while (cell.ends_with(' ')) cell.remove_suffix(1);
      const auto value = parse_number(cell);
      if (value && std::isfinite(*value)) row.push_back(*value);
    }
    const bool header = rows.empty() && row.empty();
    if (header) continue;
    if (row.size() != 2 || cells.size() != 2) {
      table.fail("file", path + ": '" + std::string(line) + "' is no pair of code and luminance");
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

Response read_table_response(const TomlTable& table, double code_max,
                             const std::string& directory) {
  const auto pairs = table.rows("table");
  const auto file = table.string("file");
  if (pairs) return checked_table(table, "table", *pairs, code_max);
  if (!file) {
    table.fail("kind", "a measured response has no figures",
               "give table = [[code, luminance], ...] or file = \"measured.csv\"");
  }
  if (directory.empty()) table.fail("file", "no file can be named here", "give the table itself");
  const std::string path = file->starts_with('/') ? *file : directory + "/" + *file;
  return checked_table(table, "file", csv_rows(table, path), code_max);
}

struct ResponseKind {
  std::string_view name;
};
constexpr ResponseKind kResponseKinds[] = {{"srgb"}, {"linear"}, {"gamma"}, {"bt1886"}, {"table"}};

Response read_response(const TomlTable& root, double code_max, const std::string& directory) {
  const auto table = root.table("response");
  if (!table) return SrgbResponse{};
  const std::string_view kind = choice(*table, "kind", kResponseKinds, kResponseKinds[0]).name;
  Response response = SrgbResponse{};
  if (kind == "linear") response = LinearResponse{};
  if (kind == "gamma") {
    GammaResponse gamma;
    gamma.gamma = number_in(*table, "gamma", 2.2, 0.01, 100, "from 0.01 to 100");
    gamma.i0 = number_in(*table, "i0", 0, 0, 1 - kTiny, "from 0 up to, not including, 1");
    gamma.k = number_in(*table, "k", 0, table->has("k") ? 1e-300 : 0, 1e300, "above 0");
    response = gamma;
  }
  if (kind == "bt1886") {
    response = Bt1886Response{
        number_in(*table, "black", 0, 0, 1 - kTiny, "from 0 up to, not including, 1")};
  }
  if (kind == "table") response = read_table_response(*table, code_max, directory);
  table->finish();
  return response;
}

std::optional<LevelTable> read_levels(const TomlTable& root, const FrameLayout& frame) {
  const auto table = root.table("levels");
  if (!table) return std::nullopt;
  LevelTable levels;
  const int bits = frame.packing.bits[0];
  const int code_max = (1 << bits) - 1;
  levels.i0 = number_in(*table, "i0", levels.i0, kTiny, 1 - kTiny, "between 0 and 1");
  levels.gamma = number_in(*table, "gamma", levels.gamma, 0.01, 100, "from 0.01 to 100");
  (void)table->integer("n");  // a fraction is no number of levels
  levels.n = static_cast<int>(
      number_in(*table, "n", code_max, 1, code_max,
                "from 1 to " + std::to_string(code_max) + ", the packing's highest code"));
  levels.spacing = find_by_name(level_spacings(), "ratio");
  if (const auto name = table->string("spacing")) {
    levels.spacing = find_by_name(level_spacings(), *name);
    if (levels.spacing == nullptr) {
      table->fail("spacing", "unknown spacing '" + *name + "'", name_hint(level_spacings(), *name));
    }
  }
  table->finish();
  return levels;
}

std::optional<Dots> read_dots(const TomlTable& root) {
  const auto table = root.table("dots");
  if (!table) return std::nullopt;
  Dots dots;
  dots.dpi = number_in(*table, "dpi", 0, 0, 1e6, "from 0 to 1000000");
  dots.isolated = table->boolean("isolated").value_or(true);
  dots.gain = number_in(*table, "gain", 0, 0, 0.25, "from 0 to 0.25: coverage gained at 50 %");
  table->finish();
  return dots;
}

std::uint16_t read_code(const TomlTable& table, std::size_t position, int code_max) {
  const auto code = table.integer("code").value_or(static_cast<std::int64_t>(position));
  if (code < 0 || code > code_max) {
    table.fail("code", "code " + std::to_string(code) + " does not fit the packing",
               "give a code from 0 to " + std::to_string(code_max));
  }
  return static_cast<std::uint16_t>(code);
}

void check_palette(const TomlTable& root, const std::vector<CodeColor>& palette) {
  std::set<int> codes;
  double darkest = palette.front().appearance.y;
  double lightest = darkest;
  for (const CodeColor& entry : palette) {
    if (!codes.insert(entry.code).second) {
      root.fail("palette", "code " + std::to_string(entry.code) + " is in the palette twice");
    }
    darkest = std::min(darkest, entry.appearance.y);
    lightest = std::max(lightest, entry.appearance.y);
  }
  if (!(lightest > darkest) || !(lightest > 0)) {
    root.fail("palette", "the palette has no lightest and darkest entry",
              "give at least two entries of different luminance");
  }
}

void read_palette(const TomlTable& root, Display& display) {
  std::optional<Chromaticity> viewing_white;
  if (const auto viewing = root.table("viewing")) {
    if (viewing->has("white")) viewing_white = read_white_point(*viewing, "white");
    display.adaptation = choice(*viewing, "adapt", kAdaptations, kAdaptations[0]).method;
    viewing->finish();
  }
  display.viewing_white = viewing_white.value_or(kD65);
  const int code_max = (1 << display.frame.packing.bits[0]) - 1;
  for (const TomlTable& entry : root.tables("palette")) {
    CodeColor color;
    color.code = read_code(entry, display.palette.size(), code_max);
    color.appearance = read_appearance(entry, viewing_white, display.adaptation);
    color.name = entry.string("name").value_or("");
    entry.finish();
    display.palette.push_back(std::move(color));
  }
  if (display.palette.empty()) return;
  if (display.frame.packing.samples != 1) {
    root.fail("palette", "packing " + std::string(display.frame.packing.name) + " has no palette",
              "give an index, gray or mono packing");
  }
  if (display.levels) root.fail("levels", "a display with a palette has no [levels]", "remove one");
  check_palette(root, display.palette);
}

void check_levels(const TomlTable& root, const Display& display) {
  const Packing& packing = display.frame.packing;
  if (!display.levels) {
    if (display.frame.store == Store::kIndex) {
      root.fail("frame_buffer", "store = \"index\" needs intensity levels", "add [levels]");
    }
    return;
  }
  if (packing.indexed) {
    root.fail("levels", "an indexed packing has no [levels]", "give a gray or RGB packing");
  }
  if (packing.samples == 3 &&
      (packing.bits[1] != packing.bits[0] || packing.bits[2] != packing.bits[0])) {
    root.fail("levels", "[levels] needs the same bits in each channel",
              "give another packing than " + std::string(packing.name));
  }
}

}  // namespace

std::span<const BuiltInDisplay> built_in_displays() noexcept {
  static const std::vector<BuiltInDisplay> displays = [] {
    std::vector<BuiltInDisplay> all;
    for (const detail::EmbeddedFile& file : detail::embedded_devices()) {
      all.push_back({file.name, file.text});
    }
    return all;
  }();
  return displays;
}

Display parse_display(std::string_view text, const std::string& file,
                      const std::string& directory) {
  const TomlTable root = TomlTable::parse(text, file);
  Display display;
  display.name = root.string("name").value_or("");
  if (display.name.empty()) root.fail("name", "the device has no name", "add name = \"...\"");
  display.source = root.string("source").value_or("");
  display.kind = choice(root, "kind", kDisplayKinds, kDisplayKinds[0]).kind;
  display.frame = read_frame(root);
  display.panel = read_panel(root);
  display.primaries = read_primaries(root);
  const double code_max = (1 << display.frame.packing.bits[0]) - 1;
  display.response = read_response(root, code_max, directory);
  display.levels = read_levels(root, display.frame);
  display.dots = read_dots(root);
  read_palette(root, display);
  check_levels(root, display);
  root.finish();
  return display;
}

Display load_display(const std::string& name_or_path) {
  if (const auto* built_in = find_by_name(built_in_displays(), name_or_path)) {
    return parse_display(built_in->text, std::string(built_in->name) + ".toml");
  }
  const bool is_path = name_or_path == "-" || name_or_path.find('/') != std::string::npos ||
                       name_or_path.ends_with(".toml");
  if (!is_path) {
    throw Error(ErrorKind::kMisuse, name_or_path, "unknown device",
                name_hint(built_in_displays(), name_or_path) +
                    " (a file of your own: ./panel.toml; the list: tristim device list)");
  }
  const std::size_t slash = name_or_path.rfind('/');
  const std::string directory = slash == std::string::npos ? "."
                                : slash == 0               ? "/."
                                                           : name_or_path.substr(0, slash);
  return parse_display(read_text_file(name_or_path), name_or_path, directory);
}

}  // namespace tristim
