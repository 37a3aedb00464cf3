#pragma once

#include <cstdlib>
#include <span>

#include "tristim/core/find.h"

namespace tristim::detail {

/// Of the same code in several instruction sets, best first: the one whose name the environment's
/// TRISTIM_SIMD tells, else the first; nullptr for "scalar" and where there is none.
template <typename T>
const T* chosen_instruction_set(std::span<const T> all) {
  if (const char* wanted = std::getenv("TRISTIM_SIMD")) {
    if (same_name(wanted, "scalar")) return nullptr;
    if (const T* found = find_by_name(all, wanted)) return found;
  }
  return all.empty() ? nullptr : &all.front();
}

}  // namespace tristim::detail
