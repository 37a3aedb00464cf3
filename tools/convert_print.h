#pragma once

#include <nlohmann/json.hpp>
#include <span>
#include <string>

#include "tools/convert_gamut.h"
#include "tools/convert_rows.h"
#include "tristim/color/conversion.h"

namespace tristim::tools {

/// How the results of a conversion are printed.
struct PrintOptions {
  std::string from, to;  // as the user named them
  bool json = false;
  bool explain = false;  // the steps first, and each colour on its way

  // Of colours that were made of something else, such as spectra: how, in words, and facts of it
  // for JSON under its name.
  std::string origin = {};
  nlohmann::ordered_json origin_facts = {};
};

/// Prints the converted colours, one a line, or one JSON object. With `gamut` those outside are
/// brought inside, and a note says how many were.
void print_colors(std::span<const ColorRow> rows, const ColorConversion& conversion,
                  const GamutMapping* gamut, const PrintOptions& options);

/// Prints every model's view of each colour of `from`: "all" of --to.
void print_all_models(std::span<const ColorRow> rows, const ModelReference& from,
                      Adaptation adaptation, const PrintOptions& options);

}  // namespace tristim::tools
