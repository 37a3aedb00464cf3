#pragma once

#include <optional>
#include <string>

#include "tools/cli.h"
#include "tristim/device/display.h"

namespace tristim::tools {

/// The options of a device file besides its response; what is not given stays as the display has
/// it.
struct DeviceOptions {
  std::optional<std::string> name, source;
  std::optional<DisplayKind> kind;
  std::optional<Packing> packing;
  std::optional<BitOrder> bit_order;
  std::optional<ByteOrder> byte_order;
  std::optional<PanelSize> size;
  std::optional<Primaries> set;
  std::optional<Chromaticity> red, green, blue, white;
};

/// Declares them, in sections of the help page.
void declare_device_options(CommandLine& line, DeviceOptions& options);

/// Puts what was given into a display. Throws std::invalid_argument where the
/// primaries are none.
void apply_device_options(const DeviceOptions& options, Display& display);

/// The packing, and the published set of primaries, of a name. Throw Error (kMisuse).
Packing packing_option(const std::string& name);
Primaries primaries_option(const std::string& name);

/// Writes a device file, after reading it back once. `output` is not empty. Throws Error: kMisuse
/// where the display is none that a file may hold.
void write_device_file(const Display& display, const std::string& remarks,
                       const std::string& output, bool force);

}  // namespace tristim::tools
