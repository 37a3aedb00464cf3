#pragma once

#include "tools/cli.h"

namespace tristim::tools {

/// `tristim shade tables`: the tables of a paper, computed anew beside what it prints.
void run_shade_tables(Arguments arguments);

/// `tristim shade figures`: a directory of figures.
void run_shade_figures(Arguments arguments);

}  // namespace tristim::tools
