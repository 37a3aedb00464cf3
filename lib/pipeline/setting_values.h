#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "tristim/pipeline/settings.h"

namespace tristim::detail {

/// What a setting says of a value: nothing where it was taken.
using Result = std::optional<Refusal>;

inline Refusal not_a(std::string_view what, std::string_view value, std::string_view remedy) {
  return {"'" + std::string(value) + "' is no " + std::string(what), std::string(remedy)};
}

/// Calls assign(bool) with the value of a switch.
template <typename Assign>
Result set_switch(std::string_view value, Assign&& assign) {
  if (value != "true" && value != "false") return not_a("switch", value, "give true or false");
  assign(value == "true");
  return {};
}

}  // namespace tristim::detail
