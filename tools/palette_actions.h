#pragma once

#include "tools/cli.h"

namespace tristim::tools {

void run_palette_build(Arguments arguments);
void run_palette_show(Arguments arguments);
void run_palette_convert(Arguments arguments);
void run_palette_check(Arguments arguments);

/// What `tristim palette` does. The command and its help read this list.
inline constexpr Command kPaletteActions[] = {
    {"build", "IN... [-n N] [-o OUT] [options]", "one palette for a picture or a sequence",
     run_palette_build},
    {"show", "P|COLORS... [options]", "swatches, codes, names and distances of a palette",
     run_palette_show},
    {"convert", "P OUT [options]", "a palette file in another format", run_palette_convert},
    {"check", "P|COLORS... [options]", "what the guidelines and the eye say about a palette",
     run_palette_check},
};

/// An action as its own help calls it: "palette show".
Command palette_action(std::string_view name);

}  // namespace tristim::tools
