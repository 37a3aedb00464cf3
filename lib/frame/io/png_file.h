#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "tristim/core/file.h"
#include "tristim/frame/code.h"

namespace tristim::detail {

enum class PngColour { kGrey, kRgb, kPalette };

/// How a frame becomes PNG samples.
struct PngShape {
  PngColour colour = PngColour::kGrey;
  int depth = 8;    // bits of a sample: 1, 2, 4, 8 or 16
  int samples = 1;  // of a pixel
};

/// Whether codes have fewer bits than the PNG's samples.
bool is_widened(const FrameInfo& frame, const PngShape& shape);

/// libpng, for everything but the pixels: it knows which chunks are valid and in which order.
class PngFile {
 public:
  /// Throws Error as OutputFile::write does, here and below.
  PngFile(OutputFile& file, const FrameInfo& frame, const PngShape& shape);
  ~PngFile();
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  /// `name`: four letters.
  void write_chunk(const char* name, std::span<const std::uint8_t> bytes);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace tristim::detail
