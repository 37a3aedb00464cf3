#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tristim/image/picture.h"

namespace tristim {

/// How samples of an EXR file are stored.
enum class ExrPixel { kHalf, kFloat };

struct ExrWriteOptions {
  ExrPixel pixel = ExrPixel::kHalf;
  bool replace = false;
  std::string software = "tristim";
  std::vector<std::string> channels = {};  // the names of all samples of a pixel; none: as below
};

/// A scanline EXR file (zip) of linear light: R G B, or R G B A where info has 4 channels, or Y
/// where it is grey, or the channels that the options name; `chromaticities` and `pixelAspectRatio`
/// are written. Values beyond a half's range become infinities of the same sign. "-" is standard
/// output (spooled, EXR cannot stream). Throws Error (kSystem) as OutputFile does, and
/// std::invalid_argument for names of channels that are empty, not as many as info has, or there
/// twice.
std::unique_ptr<RowSink> open_exr_sink(const std::string& path, const PictureInfo& info,
                                       const ExrWriteOptions& options = {});

}  // namespace tristim
