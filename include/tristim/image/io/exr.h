#pragma once

#include <memory>
#include <string>

#include "tristim/image/picture.h"

namespace tristim {

/// How samples of an EXR file are stored.
enum class ExrPixel { kHalf, kFloat };

struct ExrWriteOptions {
  ExrPixel pixel = ExrPixel::kHalf;
  bool replace = false;
  std::string software = "tristim";
};

/// A scanline EXR file (zip) of linear light: R G B, or R G B A where info has 4 channels, or Y
/// where it is grey; `chromaticities` and `pixelAspectRatio` are written. Values beyond a half's
/// range become infinities of the same sign. "-" is standard output (spooled, EXR cannot stream).
/// Throws Error (kSystem) as OutputFile does.
std::unique_ptr<RowSink> open_exr_sink(const std::string& path, const PictureInfo& info,
                                       const ExrWriteOptions& options = {});

}  // namespace tristim
