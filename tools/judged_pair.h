#pragma once

#include <string>

#include "tristim/measure/pictures.h"

namespace tristim::tools {

/// What to compare, and how its codes become light.
struct PairOptions {
  std::string reference, result;  // files; - is standard input
  /// The name of a curve or g and an exponent; "": as the file says, where it holds codes.
  std::string reference_transfer, result_transfer;
  int border = 0;  // pixels at each edge that do not count
};

/// Two pictures as light of sRGB's primaries.
struct JudgedPair {
  Image reference, result;
  std::size_t colors = 0;  // different ones in the result; of floats those at 16 bits
  int border = 0;

  PicturePair pictures() const noexcept;
};

/// Where the result is grey and the reference is not, that becomes its luminance. Alpha is over
/// black. Throws Error: as open_picture does; kMisuse for unknown transfers; kContent where the
/// sizes differ, the border leaves nothing, or a sample is not finite.
JudgedPair read_pair(const PairOptions& options);

}  // namespace tristim::tools
