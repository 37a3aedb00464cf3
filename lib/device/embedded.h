#pragma once

#include <span>
#include <string_view>

namespace tristim::detail {

/// A file of luts/devices that is part of the library.
struct EmbeddedFile {
  std::string_view name;  // the file's name without ".toml"
  std::string_view text;
};

/// The built-in device files, in the order of their names. CMake writes the definition.
std::span<const EmbeddedFile> embedded_devices() noexcept;

}  // namespace tristim::detail
