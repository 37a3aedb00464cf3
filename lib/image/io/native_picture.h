#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lib/image/io/sample_decoder.h"

namespace tristim::detail {

/// Rows as another library hands them over.
class NativeRows {
 public:
  virtual ~NativeRows() = default;

  /// Rows [first, first + count), without gaps. Throws Error (kContent) where the file is damaged.
  virtual void read(int first, int count, std::span<std::byte> bytes) = 0;
};

/// What OpenImageIO says of a file, in its words where they are text.
struct NativePicture {
  int width = 0;
  int height = 0;
  SampleType type = SampleType::kUint8;
  std::vector<std::string> channels;
  int alpha = -1;         // index of that channel
  bool straight = false;  // colours are not multiplied by it
  int chunk_rows = 1;     // a row of tiles, or rows that are cheap together
  double pixel_aspect = 1;
  int orientation = 1;
  std::string compression;
  std::string colour_space;  // "sRGB", "Linear", "Gamma2.2", "Rec709", ..., or nothing
  std::string colour_model;  // of the file, where it is none of grey and RGB: "CMYK", ...
  bool has_icc_profile = false;
  std::unique_ptr<NativeRows> rows;
};

}  // namespace tristim::detail
