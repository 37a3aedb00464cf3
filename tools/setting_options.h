#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/cli.h"
#include "tristim/pipeline/settings.h"

namespace tristim::tools {

/// Settings of the command line are kept until a pipeline file has been read: they override it.
struct GivenSetting {
  const Setting* setting;
  std::string value;
};

/// Declares the settings of `names`, of all where there are none, as options that add to `given`,
/// which outlives the line.
void declare_settings(CommandLine& line, std::vector<GivenSetting>& given,
                      std::span<const std::string_view> names = {});

/// Throws Error (kMisuse) for values that a setting does not take.
void apply_settings(Settings& settings, const std::vector<GivenSetting>& given);

}  // namespace tristim::tools
