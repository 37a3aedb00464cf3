#pragma once

#include <span>
#include <string_view>

namespace tristim::detail {

/// A file that is part of the library.
struct EmbeddedFile {
  std::string_view name;  // the file's name without ".toml"
  std::string_view text;
};

/// The device files of luts/devices and the scenes of luts/scenes, in the order of their names.
/// CMake writes the definitions.
std::span<const EmbeddedFile> embedded_devices() noexcept;
std::span<const EmbeddedFile> embedded_scenes() noexcept;

}  // namespace tristim::detail
