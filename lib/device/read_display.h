#pragma once

#include <optional>
#include <string>
#include <vector>

#include "lib/core/toml_values.h"
#include "tristim/device/display.h"

namespace tristim::detail {

// The sections of a device file, each read by one function; see parse_display.

bool strictly_ascending(const std::vector<double>& values);

/// The response of all channels and those of single ones, of a display whose frame is known; tables
/// beside the file are looked for in `directory`.
void read_response(const TomlTable& root, Display& display, const std::string& directory);

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
