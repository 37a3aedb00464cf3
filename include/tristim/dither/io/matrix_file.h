#pragma once

#include <string>

#include "tristim/dither/threshold_matrix.h"

namespace tristim {

/// Reads the user's own matrix: a text as parse_matrix has it, or a picture whose first channel is
/// the threshold. What a file is, its first bytes say. "-" is standard input, which is text.
///
/// Throws Error: kSystem where the file is missing or unreadable; kContent where it is no matrix,
/// or a picture of more than 4096 pixels a side.
ThresholdMatrix read_matrix(const std::string& path);

/// Whether a file begins as a picture does, and not as a text.
bool begins_as_picture(const std::string& path);

}  // namespace tristim
