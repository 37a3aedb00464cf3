#pragma once

#include <vector>

#include "tools/process_job.h"

namespace tristim::tools {

/// The steps before and behind the pipeline's own, for --explain.
StepReport read_step(const PictureInfo& file, const Job& job);
StepReport fit_step(const Settings& settings, const PictureInfo& file, const PictureInfo& fitted);
StepReport palette_step(const PaletteChoice& choice, int colors);
StepReport write_step(const Job& job, const FrameLayout& layout);

/// Adds what was counted to the steps that counted it.
void add_counts(std::vector<StepReport>& steps, const Job& job);

/// Prints what was asked for of a picture, and notes what its user would want to know.
void report(const ProcessOptions& options, const Processed& processed);

}  // namespace tristim::tools
