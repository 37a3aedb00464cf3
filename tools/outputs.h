#pragma once

#include <string>
#include <vector>

namespace tristim::tools {

/// The output name of each input: `pattern` with {stem} replaced by the input's name without folder
/// and extension, and %d
/// (%04d, ...) by its place, from 1, and %% by %. `option` is for messages.
///
/// Throws Error (kMisuse) where two inputs would have one output, or a pattern has more than one
/// number or something else behind a '%'.
std::vector<std::string> output_names(const std::string& pattern,
                                      const std::vector<std::string>& inputs,
                                      const std::string& option);

/// Refuses an output that is one of the inputs, by whatever name. Throws Error (kMisuse).
void refuse_inputs_as_outputs(const std::vector<std::string>& inputs,
                              const std::vector<std::string>& outputs);

}  // namespace tristim::tools
