#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "lib/image/io/exr_file.h"

namespace tristim::detail {

enum class ExrColourModel {
  kNone,    ///< no colour channels
  kRgb,     ///< R G B; of those that are missing the light is 0, as OpenEXR has it
  kGrey,    ///< one channel
  kXyz,     ///< X Y Z
  kChroma,  ///< luminance Y, and RY and BY at a quarter of the size
};

/// Which channels of a file are the picture.
struct ExrSelection {
  int part = 0;
  ExrColourModel model = ExrColourModel::kNone;
  std::string layer;  // prefix of the names, without the dot
  std::array<int, 4> channel{-1, -1, -1,
                             -1};  // R G B A, or X Y Z A, or (grey) one and A: index or -1
};

/// The channels of `layer` (or of no layer) in the first part that has them; a name of one channel
/// is grey. Deep parts have none.
ExrSelection select_channels(std::span<const ExrPart> parts, std::string_view layer);

/// "name:type" of every channel; with the part's name before it where there are several.
std::vector<std::string> channel_list(std::span<const ExrPart> parts);

}  // namespace tristim::detail
