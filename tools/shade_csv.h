#pragma once

#include <map>
#include <string>

#include "tools/shade_model.h"

namespace tristim::tools {

/// Columns that are given once for all rows, as options.
using FixedColumns = std::map<std::string, std::string>;

/// Evaluates `model` for every row of a CSV file ("-": standard input) as it is read. The header
/// names the columns in any order; in_X counts as X, what the model does not take is left alone,
/// an `id` is carried over. Without `input` every column has to be fixed: one row.
///
/// Throws Error: kSystem where a file cannot be read or written, kContent for a missing column and
/// for a row with the wrong number of values or one that the model does not take, with its number.
void shade_csv(const ShadeModel& model, const FixedColumns& fixed, const std::string& input,
               const std::string& output, bool replace);

}  // namespace tristim::tools
