#include "lib/dither/level_table.h"

namespace tristim::detail {

LevelTable::LevelTable(std::span<const float> lights, std::span<const float> thresholds,
                       std::span<const std::uint16_t> codes)
    : light(lights.begin(), lights.end()),
      threshold(thresholds.begin(), thresholds.end()),
      code(codes.begin(), codes.end()) {
  if (few()) return;
  constexpr std::size_t kMostEntries = std::size_t{1} << 20;  // levels of 16 bits
  nearest = step_table(thresholds, codes, kMostEntries);
  below =
      step_table(lights.subspan(1, lights.size() - 2), codes.first(codes.size() - 1), kMostEntries);
}

}  // namespace tristim::detail
