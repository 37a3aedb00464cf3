#include "lib/dither/entry_equals.h"

#include <algorithm>
#include <utility>

namespace tristim::detail {

EntryEquals::EntryEquals(const MixPalette& palette)
    : palette_(&palette), start_(std::size_t{kSide} * kSide * kSide + 1, 0) {
  std::vector<std::pair<std::size_t, std::int32_t>> placed;
  for (int i = 0; i < palette.size(); ++i) {
    for (int corner = 0; corner < 8; ++corner) {
      MixPalette::Color near = palette.entry(i);
      for (std::size_t c = 0; c < 3; ++c) {
        near[c] += (corner >> c & 1) != 0 ? MixPalette::kEqual : -MixPalette::kEqual;
      }
      placed.emplace_back(cell(near), i);
    }
  }
  std::sort(placed.begin(), placed.end());
  placed.erase(std::unique(placed.begin(), placed.end()), placed.end());
  for (const auto& [at, entry] : placed) {
    ++start_[at + 1];
    entry_.push_back(entry);
  }
  for (std::size_t i = 1; i < start_.size(); ++i) start_[i] += start_[i - 1];
}

int EntryEquals::search(std::size_t cell, const MixPalette::Color& color) const noexcept {
  for (std::int32_t i = start_[cell]; i < start_[cell + 1]; ++i) {
    const std::int32_t entry = entry_[static_cast<std::size_t>(i)];
    if (palette_->equals(entry, color)) return entry;
  }
  return -1;
}

}  // namespace tristim::detail
