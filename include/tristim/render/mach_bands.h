#pragma once

#include "tristim/image/view.h"

namespace tristim {

/// The Mach bands of a picture as a map [Mach65, Shoaff 4.1]: what the eye adds where the intensity
/// changes its slope, the negative of the second difference,
///   (2 I - I_left - I_right) + (2 I - I_above - I_below),
/// above 0 where a bright line is seen, below where a dark one is. 0 wherever the intensity is
/// linear, so that of a Gouraud-shaded polygon only the edges are left; a step, as between flat
/// polygons, has a bright line on its bright side and a dark one on the other. At the picture's
/// borders the direction that leaves it counts nothing.
///
/// Both views are of one shape, channel by channel, and do not overlap.
void mach_bands(ImageView<const float> intensity, ImageView<float> bands) noexcept;

}  // namespace tristim
