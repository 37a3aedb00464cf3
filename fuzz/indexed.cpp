#include <sys/mman.h>
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "tristim/core/error.h"
#include "tristim/image/io/indexed.h"

// Palettes and positions of PNG, GIF, BMP and TIFF: the first bytes tell which.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const int file = memfd_create("input", 0);
  if (file < 0 || write(file, data, size) != static_cast<ssize_t>(size)) return 0;
  try {
    (void)tristim::read_indexed_picture("/proc/self/fd/" + std::to_string(file));
  } catch (const tristim::Error& error) {
    if (error.kind() != tristim::ErrorKind::kContent) throw;
  }
  close(file);
  return 0;
}
