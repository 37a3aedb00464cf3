#pragma once

#include "lib/palette/clusters.h"

namespace tristim::detail {

/// Takes means that others could stand in for to where errors are largest, where each parts the
/// places of a mean with it, some at a time, and moves all by `rounds`: up to `tries` times, as
/// long as that lessens the error. Not the fixed ones.
void reseat_means(const GroupedPlaces& places, int tries, const MeanRounds& rounds, Places& means);

}  // namespace tristim::detail
