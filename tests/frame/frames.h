#pragma once

#include <algorithm>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "tristim/core/error.h"
#include "tristim/core/find.h"
#include "tristim/frame/code.h"
#include "tristim/frame/io/write.h"

namespace tristim {

/// A frame in memory, for tests of writers.
struct TestFrame {
  FrameInfo info;
  std::vector<std::uint16_t> codes;  // row by row

  ImageView<const std::uint16_t> view() const {
    const int samples = info.layout.packing.samples;
    return {codes.data(), info.width, info.height, samples, std::ptrdiff_t{info.width} * samples};
  }
};

inline FrameInfo frame_info(std::string_view packing, int width, int height) {
  FrameInfo info;
  info.width = width;
  info.height = height;
  info.layout.packing = *find_by_name(kPackings, packing);
  return info;
}

/// `colours` entries, the darkest last, whose codes are not their positions.
inline std::vector<PaletteEntry> test_palette(int colours, int bits) {
  std::vector<PaletteEntry> palette;
  const unsigned mask = (1u << bits) - 1;
  for (int i = 0; i < colours; ++i) {
    PaletteEntry entry;
    const int bright = 255 - i * 255 / colours;
    entry.srgb = {static_cast<std::uint8_t>(bright), static_cast<std::uint8_t>(bright / 2),
                  static_cast<std::uint8_t>(255 - i)};
    entry.code = static_cast<std::uint16_t>(~static_cast<unsigned>(i) & mask);
    entry.name = "colour */ \\ ?\?/ " + std::to_string(i);
    palette.push_back(entry);
  }
  return palette;
}

/// Codes of all values that the frame may hold, in no order; the same for the same frame.
inline TestFrame random_frame(const FrameInfo& info) {
  TestFrame frame{info, {}};
  std::mt19937 generator(static_cast<unsigned>(info.width * 31 + info.height));
  const Packing& packing = info.layout.packing;
  for (int pixel = 0; pixel < info.width * info.height; ++pixel) {
    for (std::size_t k = 0; k < static_cast<std::size_t>(packing.samples); ++k) {
      const auto count =
          info.palette.empty() ? 1u << packing.bits[k] : static_cast<unsigned>(info.palette.size());
      frame.codes.push_back(static_cast<std::uint16_t>(generator() % count));
    }
  }
  return frame;
}

/// Writes `rows_at_once` rows at a time.
inline void write_frame(const TestFrame& frame, const std::string& path,
                        const FrameWriteOptions& options = {}, int rows_at_once = 3) {
  const auto sink = open_code_sink(path, frame.info, options);
  for (int y = 0; y < frame.info.height; y += rows_at_once) {
    sink->write(frame.view().rows(y, std::min(rows_at_once, frame.info.height - y)));
  }
  sink->finish();
}

/// The text of the Error that opening a writer throws, and its kind before it.
inline std::string open_error(const FrameInfo& info, const std::string& path,
                              const FrameWriteOptions& options = {}) {
  try {
    open_code_sink(path, info, options);
  } catch (const Error& error) {
    return std::to_string(static_cast<int>(error.kind())) + " " + error.what();
  }
  return "no error";
}

}  // namespace tristim
