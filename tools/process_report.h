#pragma once

#include <nlohmann/json.hpp>
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

/// What --json prints of a picture. `steps` may be empty.
nlohmann::ordered_json job_json(const ProcessOptions& options, const Job& job,
                                const Display& display, const PictureInfo& picture,
                                const std::vector<StepReport>& steps);

/// Tells on standard error what a user would want to know of a picture.
void say_notes(const Job& job);

}  // namespace tristim::tools
