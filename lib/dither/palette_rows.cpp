#include "lib/dither/palette_rows.h"

#include <algorithm>

#include "lib/core/instruction_set.h"

namespace tristim::detail {

PaletteRowsPlan::PaletteRowsPlan(const MixPalette& palette, const EntryGrid& entry_grid,
                                 const ErrorRows& errors, bool closed_kernel, float jitter_share,
                                 std::uint32_t noise)
    : grid(&entry_grid),
      low(palette.lowest()),
      high(palette.highest()),
      jitter{},
      passed_on(palette.passed_on()),
      seed(noise),
      taps(errors.taps().begin(), errors.taps().end()),
      weight_before(errors.weight_before()),
      closed(closed_kernel),
      skew(1) {
  for (std::size_t c = 0; c < 3; ++c) {
    jitter[c] = palette.step()[c] * jitter_share;
    for (int i = 0; i < palette.size(); ++i) entry[c].push_back(palette.entry(i)[c]);
  }
  for (const ErrorRows::Tap& tap : taps) {
    if (tap.row == 1) skew = std::max(skew, 1 - tap.dx);
    if (closed) skew = std::max(skew, 1 + tap.dx);
  }
  // A row that is `skew` behind the one above is twice that behind the next.
  for (const ErrorRows::Tap& tap : taps) {
    while (tap.row * skew + tap.dx < 1) ++skew;
  }
  for (int dx = 1; closed && dx <= 3; ++dx) {
    if (weight_before[static_cast<std::size_t>(dx) - 1] != 0) skew = std::max(skew, 1 + dx);
  }
}

const PaletteRows* palette_rows() { return chosen_instruction_set(all_palette_rows()); }

}  // namespace tristim::detail
