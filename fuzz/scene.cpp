#include <cstddef>
#include <cstdint>

#include "tristim/core/error.h"
#include "tristim/render/io/scene_file.h"

// The reader of scenes: any bytes are a scene or an Error of their content.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tristim;  // NOLINT(google-build-using-namespace): nothing else is here
  try {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    (void)count_scene(parse_scene(text, "input", "/nowhere").scene);
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::kMisuse) throw;
  }
  return 0;
}
