#pragma once

#include <vector>

#include "tristim/pipeline/settings.h"

namespace tristim::detail {

/// The settings of halftone screens, for settings_list().
std::vector<Setting> screen_settings();

}  // namespace tristim::detail
