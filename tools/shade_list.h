#pragma once

#include "tools/cli.h"
#include "tools/shade_model.h"

namespace tristim::tools {

/// Prints every model with its inputs, outputs, formula and source.
void list_shade_models(bool json);

/// What stands at the end of the help about one model.
std::string model_text(const ShadeModel& model);

}  // namespace tristim::tools
