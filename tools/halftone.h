#pragma once

#include <string>

#include "tools/cli.h"
#include "tristim/dither/threshold_matrix.h"

namespace tristim::tools {

// Each in its file tools/halftone_<name>.cpp.
void run_halftone_matrix(Arguments arguments);
void run_halftone_patterns(Arguments arguments);
void run_halftone_judge(Arguments arguments);
void run_halftone_levels(Arguments arguments);
void run_halftone_cells(Arguments arguments);
void run_halftone_screen(Arguments arguments);
void run_halftone_gallery(Arguments arguments);

/// What `tristim halftone` does. The command and its help read this list.
inline constexpr Command kHalftoneJobs[] = {
    {"halftone matrix", "NAME|FILE [-o OUT] [options]",
     "a threshold matrix as text, CSV, JSON, C or a picture", run_halftone_matrix},
    {"halftone patterns", "NAME|FILE -o OUT [options]",
     "the patterns of a matrix, level by level, as PNG or SVG", run_halftone_patterns},
    {"halftone judge", "NAME|FILE [options]",
     "a matrix or a list of patterns by the guidelines for halftones", run_halftone_judge},
    {"halftone levels", "--n N --bits M|R,G,B [options]",
     "how many levels and colours cells of a device make, and which", run_halftone_levels},
    {"halftone cells", "IN -o OUT [options]",
     "a picture with a cell of device pixels for each pixel", run_halftone_cells},
    {"halftone screen", "[options]",
     "what dots make of a ruling and an angle: cells, levels, moire", run_halftone_screen},
    {"halftone gallery", "IN -o OUT [options]",
     "a picture and a ramp by every dither on one sheet, with its figures", run_halftone_gallery},
};

/// The job of kHalftoneJobs called `name`, without "halftone "; nullptr where there is none.
const Command* halftone_job(std::string_view name) noexcept;

/// What a matrix is asked for with, beside its name.
struct MatrixOptions {
  int size = 0;
  std::string seed, channel, frame;
};

/// Declares --mask-size, --seed, --channel and --frame.
void declare_matrix_options(CommandLine& line, MatrixOptions& options);

/// A matrix by its name, or the user's own from a file. Throws Error for what is neither.
ThresholdMatrix halftone_matrix(const std::string& name, const MatrixOptions& options);

}  // namespace tristim::tools
