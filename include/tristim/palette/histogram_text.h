#pragma once

#include <string>
#include <string_view>

#include "tristim/palette/histogram.h"

namespace tristim {

/// A histogram as text, to be merged elsewhere: the line "tristim histogram 1", then for each
/// colour, in ascending order, "rrggbb count" or "rrggbbaa count", two hexadecimal digits a
/// channel.
std::string histogram_text(const Histogram& histogram);

/// Adds the colours of such a text to `histogram`, which keeps those that it has. Lines may end in
/// CR LF, a colour may come more than once, in any order. Throws Error (kContent)
/// "<name>:<line>: ..." for anything else, and where a count is not in 1..2^46 or the sum of all
/// exceeds that; `histogram` is then as it was.
void merge_histogram_text(std::string_view text, std::string_view name, Histogram& histogram);

}  // namespace tristim
