#include <cstddef>
#include <cstdint>

#include "tristim/core/error.h"
#include "tristim/palette/io/file.h"

// The reader of one palette format, whose name the build gives: any bytes are a palette or an Error
// of their content, and what was read can be written.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tristim;  // NOLINT(google-build-using-namespace): nothing else is here
  try {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    const Palette palette = parse_palette(bytes, "input", TRISTIM_FORMAT);
    for (const PaletteFormat& format : palette_formats()) {
      if (palette.colors.size() > static_cast<std::size_t>(format.most_colors)) continue;
      (void)parse_palette(palette_bytes(palette, format, "output"), "output", format.name);
    }
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kContent) throw;
  }
  return 0;
}
