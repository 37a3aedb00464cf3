#include "tristim/device/display_file.h"

#include <algorithm>

#include "lib/color/toml_color.h"
#include "lib/core/embedded.h"
#include "lib/core/toml.h"
#include "lib/device/read_display.h"
#include "lib/device/spacing.h"
#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/find.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::choice;
using detail::kTiny;
using detail::number_in;
using detail::read_chromaticity;
using detail::read_white_point;
using detail::TomlTable;

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

std::optional<LevelTable> read_levels(const TomlTable& root, const Display& display) {
  const auto table = root.table("levels");
  if (!table) return std::nullopt;
  LevelTable levels;
  const int bits = display.frame.packing.bits[0];
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
  levels.peak_cd_m2 = number_in(*table, "peak", levels.peak_cd_m2, kTiny, 1e6, "above 0, in cd/m2");
  levels.from_zero = table->boolean("from_zero").value_or(false);
  if (const auto* measured = std::get_if<TableResponse>(&display.response)) {
    levels.measured = *measured;
  }
  try {
    (void)detail::LevelPositions(levels);
  } catch (const std::invalid_argument& bad) {
    table->fail("spacing", bad.what());
  }
  table->finish();
  return levels;
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
  detail::read_response(root, display, directory);
  display.levels = read_levels(root, display);
  display.dots = detail::read_dots(root, display.press);
  detail::read_palette(root, display);
  detail::read_inks(root, display);
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
