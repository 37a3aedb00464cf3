#pragma once

#include <span>
#include <vector>

#include "tristim/color/rgb.h"

namespace tristim {

/// Where the colours of a palette stood in the palette before, so that indices stay from picture to
/// picture: for each place of the result the position in `next` of the colour that goes there.
///
/// Equal colours keep their place; then, nearest first in Oklab, each colour takes that of the one
/// it comes nearest to, ties by the smaller places; the rest fills what is free in order. The first
/// `fixed` colours of `next` stay where they are. Places beyond `next` are left out: of a shorter
/// palette no place is empty. Beyond 4096 colours on either side only equal ones are looked for.
std::vector<std::size_t> stable_order(std::span<const Rgb> previous, std::span<const Rgb> next,
                                      std::size_t fixed = 0);

}  // namespace tristim
