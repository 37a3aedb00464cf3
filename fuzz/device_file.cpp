#include <cstddef>
#include <cstdint>
#include <string_view>

#include "tristim/core/error.h"
#include "tristim/device/display_file.h"
#include "tristim/device/display_text.h"

// Device files: any bytes are a display or an Error of their content, and what is a display is
// written as a file that reads back.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tristim;  // NOLINT(google-build-using-namespace): nothing else is here
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const Display display = parse_display(text, "input");
    if (!display.press) (void)parse_display(display_text(display), "output");
  } catch (const Error& error) {
    if (error.kind() != ErrorKind::kContent) throw;
  }
  return 0;
}
