#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>

#include "tristim/core/error.h"
#include "tristim/image/io/read.h"

// The rows of EXR, PNG, PNM and NumPy files, and of what OpenImageIO reads: the first bytes tell
// which. Pictures that are large by right take their time, so a few rows must do.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::int64_t kMostSamples = std::int64_t{1} << 22;
  constexpr int kBand = 13;
  const int file = memfd_create("input", 0);
  if (file < 0 || write(file, data, size) != static_cast<ssize_t>(size)) return 0;
  try {
    const auto rows =
        tristim::open_picture("/proc/self/fd/" + std::to_string(file), {.threads = 1});
    const tristim::PictureInfo& info = rows->info();
    if (std::int64_t{info.width} * info.channels * kBand <= kMostSamples) {
      tristim::Image band(info.width, kBand, info.channels);
      for (int y = 0; y < std::min(info.height, 64 * kBand); y += kBand) {
        rows->read(band.view().rows(0, std::min(kBand, info.height - y)));
      }
    }
  } catch (const tristim::Error& error) {
    if (error.kind() != tristim::ErrorKind::kContent) throw;
  }
  close(file);
  return 0;
}
