#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tristim/dither/growth.h"
#include "tristim/dither/threshold_matrix.h"
#include "tristim/image/view.h"

namespace tristim {

/// The user's own matrix: rows of whole numbers between commas, semicolons, blanks or tabs, with
/// comments behind '#' or "//". They are ranks from 0, or from 1, each once; more than 65536 cells
/// repeat them equally often.
///
/// Throws Error (kContent) that tells row and column where there is no cell, no number, a hole, a
/// repetition, or a row of another length. `name` is for messages and becomes the matrix's.
ThresholdMatrix parse_matrix(std::string_view text, const std::string& name);

/// The user's own patterns: rows of 0 and 1, a pattern for each level, with empty lines between
/// them. Nothing where the text has other numbers, or one pattern alone: then it is a matrix.
/// Throws Error (kContent) for patterns of different sizes.
std::optional<PatternSequence> parse_patterns(std::string_view text, const std::string& name);

/// A grey picture as a matrix: its darkest pixels get the first ranks. Equal greys are told apart
/// by a dispersed order, so that every rank occurs equally often. Takes the first channel; NaN is
/// 0. Throws std::invalid_argument for a picture without pixels.
ThresholdMatrix matrix_from_picture(ImageView<const float> picture, const std::string& name);

/// A matrix as CSV, with its name in a comment, which reads back as the same matrix; and as a C
/// header with an array.
std::string matrix_csv(const ThresholdMatrix& matrix);
std::string matrix_c_header(const ThresholdMatrix& matrix);

}  // namespace tristim
