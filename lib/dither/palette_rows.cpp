#include "lib/dither/palette_rows.h"

#include "lib/core/instruction_set.h"

namespace tristim::detail {

PaletteRowsPlan::PaletteRowsPlan(const MixPalette& palette, const EntryGrid& entry_grid,
                                 const ErrorRows& errors, bool closed, float jitter_share,
                                 std::uint32_t noise)
    : grid(&entry_grid),
      low(palette.lowest()),
      high(palette.highest()),
      jitter{},
      passed_on(palette.passed_on()),
      seed(noise),
      rows(errors, closed) {
  for (std::size_t c = 0; c < 3; ++c) {
    jitter[c] = palette.step()[c] * jitter_share;
    for (int i = 0; i < palette.size(); ++i) entry[c].push_back(palette.entry(i)[c]);
  }
}

const PaletteRows* palette_rows() { return chosen_instruction_set(all_palette_rows()); }

}  // namespace tristim::detail
