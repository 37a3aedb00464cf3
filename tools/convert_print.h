#pragma once

#include <span>
#include <string>

#include "tools/convert_rows.h"
#include "tristim/color/conversion.h"

namespace tristim::tools {

/// How the results of a conversion are printed.
struct PrintOptions {
  std::string from, to;  // as the user named them
  bool json = false;
  bool explain = false;  // the steps first, and each colour on its way
};

/// Prints the converted colours, one a line, or one JSON object.
void print_colors(std::span<const ColorRow> rows, const ColorConversion& conversion,
                  const PrintOptions& options);

/// Prints every model's view of each colour of `from`: "all" of --to.
void print_all_models(std::span<const ColorRow> rows, const ModelReference& from,
                      Adaptation adaptation, const PrintOptions& options);

}  // namespace tristim::tools
