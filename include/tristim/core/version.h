#pragma once

#include <string_view>

// The one definition of the version: CMake and the package files read these lines.
#define TRISTIM_VERSION_MAJOR 0
#define TRISTIM_VERSION_MINOR 1
#define TRISTIM_VERSION_PATCH 0

#define TRISTIM_DETAIL_TEXT(value) #value
#define TRISTIM_DETAIL_VERSION(major, minor, patch) \
  TRISTIM_DETAIL_TEXT(major) "." TRISTIM_DETAIL_TEXT(minor) "." TRISTIM_DETAIL_TEXT(patch)

namespace tristim {

/// "major.minor.patch" of the headers that the program was compiled with.
inline constexpr std::string_view kVersion =
    TRISTIM_DETAIL_VERSION(TRISTIM_VERSION_MAJOR, TRISTIM_VERSION_MINOR, TRISTIM_VERSION_PATCH);

}  // namespace tristim
