#include <algorithm>
#include <set>

#include "lib/color/toml_color.h"
#include "lib/device/read_display.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

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

}  // namespace

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

}  // namespace tristim::detail
