#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/dither/level_guess.h"

namespace tristim::detail {

/// The code of every float, in one look-up and one addition. A float's leading bits choose an
/// entry: the count of thresholds below its stretch of floats, above as many low bits as the
/// stretch has, and in these what is missing from the stretch's threshold to the next stretch. So
/// adding the float's own low bits carries into the count from the threshold on.
struct StepTable {
  int shift = 0;           // low bits of a float
  std::int32_t first = 0;  // bits of the first float of the first stretch, below every threshold
  std::int32_t last = 0;   // bits of the last float of the last one
  std::vector<std::uint32_t> entry;
  std::vector<std::int32_t> codes;  // by count
  bool codes_count = false;         // codes[i] is codes[0] + i
  std::optional<LevelGuess> guess;  // of the count, where the thresholds lie on a curve

  /// NaN counts as below all thresholds.
  std::uint16_t operator()(float value) const noexcept;
};

/// `code[i + 1]` is taken from `threshold[i]` on; they ascend. Nothing where a threshold is not a
/// positive finite float, or where the stretches that hold one threshold at most would be more than
/// `most_entries`: by default, too many to stay in a cache.
std::optional<StepTable> step_table(std::span<const float> threshold,
                                    std::span<const std::uint16_t> code,
                                    std::size_t most_entries = std::size_t{1} << 16);

/// Rows in one instruction set; all of them give the same codes.
struct StepKernel {
  std::string_view name;
  void (*row)(const StepTable& table, const float* in, std::size_t count,
              std::uint16_t* out) = nullptr;
};

/// The definition.
const StepKernel& scalar_step_kernel() noexcept;

/// By Highway, for every instruction set that this processor has, best first.
std::span<const StepKernel> simd_step_kernels();

/// The one that the environment's TRISTIM_SIMD names, else the best.
const StepKernel& step_kernel();

}  // namespace tristim::detail
