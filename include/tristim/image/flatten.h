#pragma once

#include <cstdint>
#include <memory>

#include "tristim/color/rgb.h"
#include "tristim/image/picture.h"

namespace tristim {

/// Samples of a picture that were no finite numbers; each of R, G, B and alpha counts by itself.
struct OddValues {
  std::uint64_t nan = 0;
  std::uint64_t infinite = 0;
  friend constexpr bool operator==(const OddValues&, const OddValues&) = default;
};

/// The rows of `source` without odd values and without alpha: always R G B.
///
/// NaN becomes 0 and +-infinity +-65504 (the largest half); finite values stay, larger ones too.
/// `counts` (may be null; must outlive the result) is added to as rows are read. Then premultiplied
/// alpha goes over `background` in light, rgb + (1 - alpha) background [Porter84, over];
/// `background` is light in the picture's own primaries, and an alpha outside of [0, 1] counts as
/// the nearer end.
std::unique_ptr<RowSource> flatten(std::unique_ptr<RowSource> source, Rgb background,
                                   OddValues* counts);

}  // namespace tristim
