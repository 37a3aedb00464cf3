#pragma once

#include <string>

#include "tristim/device/display.h"

namespace tristim {

/// A device file of a display: TOML with a comment to each figure, that parse_display reads back as
/// the same display. `remarks` (lines of text, may be empty) stand as comments at its head.
///
/// Throws std::invalid_argument for a press: its inks have spectra and figures that a Display no
/// longer holds.
std::string display_text(const Display& display, const std::string& remarks = {});

}  // namespace tristim
