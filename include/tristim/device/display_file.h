#pragma once

#include <span>
#include <string>
#include <string_view>

#include "tristim/device/display.h"

namespace tristim {

/// A device file that comes with the library.
struct BuiltInDisplay {
  std::string_view name;  // what --device takes: the stem of the file in luts/devices
  std::string_view text;  // the TOML
};

/// Every built-in device, in alphabetical order.
std::span<const BuiltInDisplay> built_in_displays() noexcept;

/// A display from the text of a device file; `file` is for messages.
///
/// Keys that the format does not have, values out of range and contradictions are Errors (kContent)
/// "<file>:<line>:<column>: <what is wrong>; <what to do>". `directory` is where a measured table's
/// CSV is looked for; empty forbids one.
Display parse_display(std::string_view text, const std::string& file,
                      const std::string& directory = {});

/// The built-in display of a name, or a file where `name_or_path` has a '/' or ends in ".toml" ("-"
/// is standard input). Throws Error: kMisuse for an unknown name, with the nearest; kSystem for a
/// missing file; else as parse_display.
Display load_display(const std::string& name_or_path);

}  // namespace tristim
