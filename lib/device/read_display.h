#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lib/core/toml.h"
#include "tristim/core/find.h"
#include "tristim/device/display.h"

namespace tristim::detail {

// The sections of a device file, each read by one function; see parse_display.

// A member of `list` named by the string at `key`; `fallback` where the key is absent.
template <typename List, typename Item>
Item choice(const TomlTable& table, std::string_view key, const List& list, Item fallback) {
  const auto name = table.string(key);
  if (!name) return fallback;
  if (const auto* item = find_by_name(list, *name)) return *item;
  table.fail(key, "unknown " + std::string(key) + " '" + *name + "'", name_hint(list, *name));
}

/// The number at `key`, or `fallback`; refuses what is not in [low, high], which `range` puts into
/// words.
double number_in(const TomlTable& table, std::string_view key, double fallback, double low,
                 double high, std::string_view range);

inline constexpr double kTiny = 1e-12;  // open ends of ranges

bool strictly_ascending(const std::vector<double>& values);

Response read_response(const TomlTable& root, double code_max, const std::string& directory);

/// [dots], and the press that it describes where it lists inks.
std::optional<Dots> read_dots(const TomlTable& root, std::optional<Press>& press);

/// Inks by name, angles and separation of the table [dots]; their light is yet to come.
std::optional<Press> read_press(const TomlTable& dots);

/// The viewing white and the palette of a display whose frame is known.
void read_palette(const TomlTable& root, Display& display);

/// What the inks of `display.press` look like, from [[ink]] tables; then its palette, all
/// overprints, and a packing for its codes where the file gives none.
void read_inks(const TomlTable& root, Display& display);

}  // namespace tristim::detail
