#pragma once

#include "tristim/dither/growth.h"

namespace tristim::detail {

GrowthFinding judge_sequence(const PatternSequence& sequence);
GrowthFinding judge_outward(const PatternSequence& sequence);
GrowthFinding judge_together(const PatternSequence& sequence);
GrowthFinding judge_lines(const PatternSequence& sequence);

}  // namespace tristim::detail
