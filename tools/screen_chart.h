#pragma once

#include <string>

#include "tristim/dither/screen.h"

namespace tristim::tools {

/// Writes a screen by the extension of `output`: .png, patches of its dots at `tones` (a list such
/// as "0.1,0.5", 0 black to 1 white; empty: from .05 to .95), dot for pixel; .json, its thresholds
/// with their tile; .csv, rows of thresholds that tile the page as they stand. Throws Error.
void write_screen(const std::string& output, const Screen& screen, const std::string& tones,
                  bool replace);

}  // namespace tristim::tools
