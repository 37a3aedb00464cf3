#pragma once

#include <cstdint>
#include <span>

#include "tristim/image/view.h"

namespace tristim {

inline constexpr int kFlatWeight = 16;  // of a pixel like its neighbours

/// How much an error of each pixel shows, to be counted with Histogram::add: kFlatWeight in flat
/// areas, down to 1 in texture, which hides errors [Orchard91 IV].
///
/// `codes` has three channels of codes below 256, `weights` one and the same size. `above` is the
/// row before the first one, empty at the picture's top; so bands give what the whole picture does.
void contrast_weights(ImageView<const std::uint16_t> codes, std::span<const std::uint16_t> above,
                      ImageView<std::uint16_t> weights) noexcept;

}  // namespace tristim
