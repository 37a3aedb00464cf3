#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tristim/pipeline/stage.h"

namespace tristim::tools {

/// Steps for people: a heading, formula and source, and the numbers below, aligned.
std::string steps_text(const std::vector<StepReport>& steps);

/// Steps for machines.
nlohmann::ordered_json steps_json(const std::vector<StepReport>& steps);

/// JSON on one line, with its end. File names need not be UTF-8, JSON must: other bytes become
/// U+FFFD.
std::string json_line(const nlohmann::ordered_json& json);

/// A number as JSON has it here: NaN is null, infinity "inf".
nlohmann::ordered_json number_json(double value);

}  // namespace tristim::tools
