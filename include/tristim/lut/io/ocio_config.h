#pragma once

#include <span>
#include <string>
#include <vector>

#include "tristim/device/display.h"

namespace tristim {

/// A display of a config.
struct OcioDisplay {
  std::string name;  // as the config calls it
  Display display;
};

/// A file of a config, beside it.
struct OcioConfigFile {
  std::string name;
  std::string bytes;
};

struct OcioConfig {
  std::string text;  // of the config itself, YAML [OCIO]
  std::vector<OcioConfigFile> files;
};

/// A config for OpenColorIO 2 that has every device as a display, with up to two views:
///
/// "Codes": what the frame buffer holds, divided by the highest code of its bits. Picture light in
/// linear sRGB goes to the device's primaries (Bradford), is clipped to [0, 1], which spans the
/// device's black to its white, and passes its response: within 1e-4 of `code_of_light` where a
/// channel has 8 bits or more, not rounded; the steps of fewer bits and of intensity levels are in
/// a table at every half float. Devices with a palette have no such view: their codes are no
/// numbers to compute with.
///
/// "Proof": what the device shows, as encoded sRGB; of a palette, what the eye makes of a dithered
/// picture.
///
/// The role scene_linear is linear sRGB. Throws std::invalid_argument where two displays have one
/// name or there are none.
OcioConfig ocio_config(std::span<const OcioDisplay> displays);

}  // namespace tristim
