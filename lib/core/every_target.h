#pragma once

#include <hwy/highway.h>

#include <cstddef>
#include <vector>

namespace tristim::detail {

/// What a function gives in each instruction set that this processor has and the file was compiled
/// for, the best first. `table` is its HWY_DISPATCH_TABLE. Emulations are left out: scalar
/// definitions are better. T has a name, which becomes the one that TRISTIM_SIMD knows.
///
/// Static, since HWY_TARGETS is another in files that switch targets off.
template <typename T, std::size_t kSize>
static std::vector<T> of_every_target(T (*const (&table)[kSize])()) {
  std::vector<T> all;
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    if (target == HWY_SCALAR || target == HWY_EMU128) continue;
    hwy::ChosenTarget chosen;  // of our own: the process-wide choice stays as it is
    chosen.Update(target);
    all.push_back(table[kSize == 1 ? 0 : chosen.GetIndex()]());
    if (all.back().name == "AVX3") all.back().name = "avx512";
  }
  return all;
}

}  // namespace tristim::detail
