#pragma once

#include <string_view>

namespace tristim {

/// The channels of a colour device, in the order of its codes. Device files, reports and drawings
/// name them so.
inline constexpr std::string_view kChannelNames[] = {"red", "green", "blue"};

}  // namespace tristim
