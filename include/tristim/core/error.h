#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace tristim {

/// What failed; the value is the command's exit code.
enum class ErrorKind {
  kSystem = 1,   ///< missing or unreadable file, directory, exists already, cannot write
  kMisuse = 2,   ///< wrong options, unknown names
  kContent = 3,  ///< the content of an input is bad: picture, device file, row
  kGate = 4,     ///< a quality gate was missed
};

/// A failure of the outside world: file, codec, configuration, command line.
class Error : public std::runtime_error {
 public:
  /// The text is "<thing>: <wrong>", and "; <remedy>" where there is one. It is one printable line:
  /// control characters of a file name become '?'.
  Error(ErrorKind kind, std::string_view thing, std::string_view wrong,
        std::string_view remedy = {});

  ErrorKind kind() const noexcept { return kind_; }

 private:
  ErrorKind kind_;
};

/// The system's own words for `error_number` (an errno), for the middle of an Error's text.
std::string system_message(int error_number);

}  // namespace tristim
