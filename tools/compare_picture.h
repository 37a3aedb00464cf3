#pragma once

#include <string>
#include <vector>

#include "tools/cli.h"
#include "tools/judged_pair.h"
#include "tristim/measure/figures.h"

namespace tristim::tools {

/// What `tristim compare REF OUT` was asked for.
struct PictureComparison {
  PairOptions pair;
  FigureOptions figures;
  std::string plot;              // "": none
  std::string max_error, gates;  // "": none
  bool json = false, force = false;
  std::vector<std::string> given;  // the options that are for pictures alone
};

/// Declares the options that are for pictures alone.
void declare_picture_options(CommandLine& line, PictureComparison& comparison);

/// Whether the arguments are two pictures rather than colours: both are files, or one is called
/// like one ("out.png").
bool are_pictures(const std::vector<std::string>& words);

/// Prints how good the result is, and draws it where that was asked for. Throws Error; kGate where
/// a figure misses its bound, after all has been printed.
void compare_pictures(const PictureComparison& comparison);

}  // namespace tristim::tools
