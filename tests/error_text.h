#pragma once

#include <stdexcept>
#include <string>

#include "tristim/core/error.h"

namespace tristim {

/// What `action` throws: "<kind> <text>" of an Error, as in "3 panel.toml:2:8: ...";
/// "invalid: <text>" of std::invalid_argument; "" where it throws neither.
template <typename Action>
std::string error_text(Action&& action) {
  try {
    action();
  } catch (const Error& error) {
    return std::to_string(static_cast<int>(error.kind())) + " " + error.what();
  } catch (const std::invalid_argument& error) {
    return std::string("invalid: ") + error.what();
  }
  return {};
}

}  // namespace tristim
