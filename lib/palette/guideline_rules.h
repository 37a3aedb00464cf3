#pragma once

#include "tristim/palette/guidelines.h"

namespace tristim::detail {

// What lib/palette/guidelines.cpp lists: the judgement of each guideline that can be judged.

Finding judge_method(const Chart& chart);
Finding judge_extremes(const Chart& chart);
Finding judge_pure_blue(const Chart& chart);
Finding judge_blue_only(const Chart& chart);
Finding judge_steps(const Chart& chart);
Finding judge_edges(const Chart& chart);
Finding judge_rim(const Chart& chart);
Finding judge_opponents(const Chart& chart);
Finding judge_deficiency(const Chart& chart);
Finding judge_many_hues(const Chart& chart);
Finding judge_complement_background(const Chart& chart);
Finding judge_neutral_background(const Chart& chart);

}  // namespace tristim::detail
