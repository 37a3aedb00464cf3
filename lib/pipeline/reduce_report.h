#pragma once

#include <span>
#include <vector>

#include "tristim/pipeline/reduce.h"

namespace tristim::detail {

/// What becomes of black and white.
StepReport black_point_report(BlackPoint black_point);

/// The inks of a press.
StepReport press_report(const Display& display);

/// A palette of `size` colours.
StepReport palette_report(const Metric& metric, int size);

/// The levels of channels, by their scales.
StepReport response_report(const Display& display, std::span<const LevelScale> scales);

StepReport dither_report(const ReduceOptions& options);

}  // namespace tristim::detail
