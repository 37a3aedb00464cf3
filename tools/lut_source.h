#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tools/setting_options.h"
#include "tristim/lut/bake.h"
#include "tristim/pipeline/stage.h"

namespace tristim::tools {

/// From what to what a table leads, as the command line says.
struct LutWay {
  std::string from;         // a model; "": linear light of sRGB's primaries
  std::string from_device;  // codes of a device instead
  std::string to;           // a model, or
  std::string device;       // codes of a device, or
  std::string ocio;         // a config, with
  std::string from_space, to_space, display, view;
  std::string look = "rgb:srgb";  // what the config's results are
};

/// Declares the options of a way.
void declare_lut_way(CommandLine& line, LutWay& way);

/// The settings that a table can hold: those that take each colour by itself.
void declare_lut_settings(CommandLine& line, std::vector<GivenSetting>& given);

/// A source to bake, and its steps in words.
struct LutSource {
  std::unique_ptr<BakeSource> source;
  std::vector<StepReport> steps;
};

/// Throws Error: kMisuse for ways that are none, for settings that no table of it can hold and for
/// devices with palettes.
LutSource make_lut_source(const LutWay& way, const std::vector<GivenSetting>& given);

}  // namespace tristim::tools
