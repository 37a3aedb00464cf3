#pragma once

#include <string>
#include <vector>

namespace tristim::tools {

/// The output name of each input: `pattern` with {stem} replaced by the input's name without folder
/// and extension, %d (%04d, ...) by its place, from 1, and %% by %. `option` is for messages.
///
/// Throws Error (kMisuse) where two inputs would have one output, or something else than a number
/// stands behind a '%'.
std::vector<std::string> output_names(const std::string& pattern,
                                      const std::vector<std::string>& inputs,
                                      const std::string& option);

/// Whether two names are of one file, as far as links and "." tell; never for /dev/null.
bool same_output(const std::string& a, const std::string& b);

/// Refuses an output that is one of the inputs, by whatever name. Throws Error (kMisuse).
void refuse_inputs_as_outputs(const std::vector<std::string>& inputs,
                              const std::vector<std::string>& outputs);

/// Refuses what cannot be written anyway, before any work is done: a directory, and an existing
/// file unless `replace`. Throws Error (kSystem).
void refuse_taken_outputs(const std::vector<std::string>& outputs, bool replace);

/// Refuses an input that is not there, before any work is done. Throws Error (kSystem).
void refuse_missing_inputs(const std::vector<std::string>& inputs);

/// Refuses the name of a drawing that ends in another extension than .svg. Throws Error (kMisuse).
void refuse_other_drawings(const std::string& output);

/// Refuses "-" where that is a terminal. Throws Error (kMisuse).
void refuse_terminal(const std::string& output);

}  // namespace tristim::tools
