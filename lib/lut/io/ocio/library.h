#pragma once

#include <OpenColorIO/OpenColorIO.h>

#include <string>

namespace tristim::detail {

namespace ocio = OCIO_NAMESPACE;

/// Silences the library, which prints and logs to stderr by default.
void set_up_library();

/// The library's own words on one line, at most a few hundred characters.
std::string reason(const std::exception& exception);

}  // namespace tristim::detail
