#include "lib/dither/ordered_kernels.h"

#include <algorithm>
#include <bit>

#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

struct Mixing {
  std::size_t lower;
  float steps;  // from the lower level to the light, in ranks
};

// NaN counts as the lowest level.
float held_inside(const OrderedLevels& levels, float light) noexcept {
  const float held = light > levels.lowest ? light : levels.lowest;
  return held < levels.highest ? held : levels.highest;
}

Mixing from_level(const OrderedLevels& levels, std::size_t lower, float held) noexcept {
  const OrderedLevels::Level& level = levels.levels[lower];
  return {lower, (held - level.light) * level.ranks_per_light};
}

std::size_t level_in_bins(const OrderedLevels& levels, float held) noexcept {
  const std::int32_t bin =
      std::max((std::bit_cast<std::int32_t>(held) >> levels.shift) - levels.first_bin, 0);
  const OrderedLevels::Bin& found = levels.bins[static_cast<std::size_t>(bin)];
  return found.lower + (held >= found.knot ? 1U : 0U);
}

std::size_t level_by_comparison(const OrderedLevels& levels, float held) noexcept {
  std::size_t lower = 0;
  while (lower + 1 < levels.levels.size() && held >= levels.levels[lower + 1].light) ++lower;
  return lower;
}

Mixing mixing(const OrderedLevels& levels, float light) noexcept {
  float held = 0;
  switch (levels.way) {
    case LevelsWay::kTwo:
      return {0, (light - levels.lowest) * levels.ranks_per_light};
    case LevelsWay::kEven: {
      const float along = (light - levels.lowest) * levels.levels_per_light;
      held = along > 0 ? along : 0;
      held = held < levels.last ? held : levels.last;
      const auto lower = static_cast<std::int32_t>(held);
      return {static_cast<std::size_t>(lower), (held - static_cast<float>(lower)) * levels.ranks};
    }
    case LevelsWay::kFew:
      held = held_inside(levels, light);
      return from_level(levels, level_by_comparison(levels, held), held);
    case LevelsWay::kBins:
      held = held_inside(levels, light);
      return from_level(levels, level_in_bins(levels, held), held);
    case LevelsWay::kSearch:
      break;
  }
  held = held_inside(levels, light);
  const int lower = levels.search.count_not_above(held) - 1;
  return from_level(levels, static_cast<std::size_t>(lower), held);
}

std::uint16_t ordered_code(const OrderedRow& row, std::size_t column, float light,
                           const float* strength) noexcept {
  const OrderedLevels& levels = *row.levels;
  const Mixing mix = mixing(levels, light);
  // floor(steps + 1/2) > rank without the call that floor is on old processors
  float least = row.least[column];
  const float middle = levels.ranks * 0.5F;
  if (strength != nullptr) least = middle + (least - middle) * *strength;
  return static_cast<std::uint16_t>(levels.codes[mix.lower + (mix.steps >= least ? 1U : 0U)]);
}

void scalar_row(const OrderedRow& row, const float* in, const float* strength, std::size_t count,
                std::uint16_t* out) {
  std::size_t column = row.column;
  for (std::size_t x = 0; x < count; ++x) {
    out[x] = ordered_code(row, column, in[x], strength == nullptr ? nullptr : strength + x);
    if (++column == row.period) column = 0;
  }
}

}  // namespace

const OrderedKernels& scalar_ordered_kernels() noexcept {
  static constexpr OrderedKernels kScalar{"scalar", scalar_row};
  return kScalar;
}

const OrderedKernels& ordered_kernels() {
  const OrderedKernels* simd = chosen_instruction_set(simd_ordered_kernels());
  return simd == nullptr ? scalar_ordered_kernels() : *simd;
}

}  // namespace tristim::detail
