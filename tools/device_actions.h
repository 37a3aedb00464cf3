#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tools/cli.h"
#include "tristim/device/display.h"

namespace tristim::tools {

void run_device_new(Arguments arguments);
void run_device_fit(Arguments arguments);

/// What `tristim device` does with files of its own making; list, show and check are its own.
inline constexpr Command kDeviceMakers[] = {
    {"device new", "[-o OUT.toml] [options]", "write a device file", run_device_new},
    {"device fit", "MEASURED.csv [-o OUT.toml] [options]",
     "fit a response to measured luminances, and write the device file", run_device_fit},
};

/// The sets of primaries that pictures are made for, whose coverage is told.
inline constexpr std::string_view kPictureSets[] = {"srgb", "display-p3", "bt2020"};

/// Everything that there is to know about a display, derived figures too.
nlohmann::ordered_json display_json(const std::string& id, const Display& display);

/// How many levels its codes have, in words.
std::string level_text(const Display& display);

/// Such facts for people.
std::string facts_text(const nlohmann::ordered_json& facts);

/// Drawings (SVG) of a display: the light of its codes beside its gamut, or the first alone.
std::string device_plot(const Display& display);
std::string response_plot(const Display& display);

/// Its gamut in the chromaticity diagram, beside those that pictures are made for.
std::string gamut_plot(const Display& display);

/// Draws a display to a file that ends in .svg, or into a folder as response.svg and gamut.svg.
/// Throws Error.
void write_device_plot(const Display& display, const std::string& output, bool force);

}  // namespace tristim::tools
