#pragma once

#include <string>

namespace tristim::tools {

/// Makes `input` readable more than once: what comes through standard input ("-") is kept in an
/// unlinked temporary file that takes its place. Throws Error: kSystem where there is no room for
/// that, kMisuse where `input` is a pipe with a name.
void make_rereadable(const std::string& input);

}  // namespace tristim::tools
