#pragma once

#include <vector>

#include "tools/process_job.h"

namespace tristim::tools {

/// Processes each of `jobs` by itself, several at once where there are threads for it, and prints
/// what was asked for in their order.
///
/// The first failure of that order is thrown; what comes behind it is given up and leaves nothing,
/// unless it was complete already. Throws Error.
void process_sequence(const ProcessOptions& options, const Display& device, std::vector<Job> jobs);

}  // namespace tristim::tools
