#pragma once

#include <string>
#include <string_view>

namespace tristim::detail {

/// A colour name as it is looked up: lower case, words separated by one space, grey as gray.
std::string normal_name(std::string_view text);

}  // namespace tristim::detail
