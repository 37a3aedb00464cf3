#pragma once

#include "tools/cli.h"

namespace tristim::tools {

void run_process(Arguments arguments);
void run_convert(Arguments arguments);
void run_spectrum(Arguments arguments);
void run_gamut(Arguments arguments);
void run_compare(Arguments arguments);
void run_palette(Arguments arguments);
void run_halftone(Arguments arguments);
void run_levels(Arguments arguments);
void run_lut(Arguments arguments);
void run_device(Arguments arguments);
void run_info(Arguments arguments);
void run_shade(Arguments arguments);
void run_render(Arguments arguments);

/// Every command. Main and the help read this list.
inline constexpr Command kCommands[] = {
    {"process", "IN... -o OUT --device D [options]", "rendered pictures to the codes of a display",
     run_process},
    {"convert", "[--from MODEL] --to MODEL [VALUES...] [options]",
     "colours from one model to another", run_convert},
    {"spectrum", "NAME... [options]", "spectral tables and illuminants, as text or drawn",
     run_spectrum},
    {"gamut", "SET... [options]", "areas, coverage and diagrams of gamuts", run_gamut},
    {"compare", "REF OUT | COLOR COLOR... [options]",
     "how good a picture is beside another one, how different colours are", run_compare},
    {"palette", "build|show|convert|check ... [options]",
     "choose, show, convert and check palettes", run_palette},
    {"levels", "[options]", "intensity levels and gamma tables of a display", run_levels},
    {"halftone", "JOB ... [options]",
     "threshold matrices, patterns, cells and screens, made and judged", run_halftone},
    {"lut", "JOB ... [options]", "look-up tables: baked, applied, inverted, composed, described",
     run_lut},
    {"device", "list|show|check|new|fit ... [options]",
     "list, show, check, make and fit device files", run_device},
    {"info", "FILE... [options]", "what a picture file is", run_info},
    {"shade", "MODEL [IN [OUT]] [options]", "illumination models, evaluated row by row", run_shade},
    {"render", "SCENE -o OUT.exr [options]", "make a picture to process", run_render},
};

}  // namespace tristim::tools
