#pragma once

#include <vector>

#include "tristim/palette/histogram.h"

namespace tristim {

/// Moves the colours of a palette that was chosen for the pixels of `histogram`, so that dither
/// mixes the pixels from them with less error: apart, to the rims of what the picture holds.
///
/// Each colour is mixed as error diffusion would, entry by entry, and the entries go to where the
/// mixtures come nearest to the colours in light (least squares), a few times over; palettes and
/// the mixtures of dither chosen together are from [Puzicha00]. Palettes of more than 256 colours,
/// those that hold every colour of the histogram, and the first `keep` entries stay as they are.
std::vector<Color8> refine_for_mixing(const Histogram& histogram, std::vector<Color8> palette,
                                      std::size_t keep = 0);

}  // namespace tristim
