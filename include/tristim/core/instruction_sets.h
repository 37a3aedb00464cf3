#pragma once

#include <string>
#include <vector>

namespace tristim {

/// What rows of pixels can be worked on with. All of them give the same bytes.
struct InstructionSet {
  std::string name;
};

/// Those that this processor has, best first, and "scalar", the definition, last: what the
/// environment variable TRISTIM_SIMD may name. Names ignore case, '_' and '-'.
const std::vector<InstructionSet>& instruction_sets();

/// The one that TRISTIM_SIMD names, else the best.
const InstructionSet& chosen_instruction_set();

/// Throws Error (kMisuse) where TRISTIM_SIMD names none of them; the library itself takes the best
/// one then.
void check_instruction_set();

/// Has those kernels of the process heed the chosen one, too, that have no definition beside them
/// and take the best by themselves; with "scalar" what every such processor has. Of other
/// libraries in the process those that use Highway are limited as well, so this is for programs.
void limit_to_instruction_set();

}  // namespace tristim
