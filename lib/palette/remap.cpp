#include "tristim/palette/remap.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lib/palette/clusters.h"
#include "lib/palette/color_cell.h"

namespace tristim {
namespace {

// What colours of the picture may find; with the transparent entries left out.
struct Findable {
  detail::Places places;
  std::vector<std::uint16_t> position;
  std::uint16_t transparent = 0;
};

Findable findable(std::span<const Color8> palette, const Metric& metric) {
  Findable found;
  const detail::Placer placer(metric);
  bool has_transparent = false;
  for (std::size_t i = 0; i < palette.size(); ++i) {
    const auto position = static_cast<std::uint16_t>(i);
    if (palette[i].a == 0) {
      if (!has_transparent) found.transparent = position;
      has_transparent = true;
      continue;
    }
    found.places.push_back(placer(palette[i]), 0);
    found.position.push_back(position);
  }
  return found;
}

}  // namespace

PaletteMap::PaletteMap(const Histogram& histogram, std::span<const Color8> palette,
                       const Metric& metric)
    : PaletteMap(palette, metric, detail::ColorCells(histogram.neighbours(), metric)) {}

PaletteMap::PaletteMap(std::span<const Color8> palette, const Metric& metric,
                       const detail::ColorCells& cells)
    : directory_(detail::kColorCells), blocks_(1) {
  if (palette.empty() || palette.size() > 65536) {
    throw std::invalid_argument("palette: " + std::to_string(palette.size()) +
                                " colours, expected 1 to 65536");
  }
  const Findable entries = findable(palette, metric);
  if (entries.position.empty() || cells.entries.empty()) return;
  const detail::Nearest nearest = detail::nearest_entries(cells.colors, entries.places);
  blocks_.resize(1 + cells.colors.levels.back().size());
  std::uint32_t block = 0;
  for (const detail::PlaceGroup& group : cells.colors.levels.back()) {
    ++block;
    for (std::uint32_t i = group.first; i < group.end; ++i) {
      const Color8 c = cells.entries[i].color;
      const std::uint16_t position =
          c.a == 0 ? entries.transparent : entries.position[nearest.index[i]];
      if (c.a != 255) {
        translucent_[detail::key_of(c)] = position;
        continue;
      }
      const std::uint32_t number = detail::color_number(c);
      directory_[detail::cell_of(number)] = block;
      blocks_[block][detail::place_in_cell(number)] = position;
    }
  }
}

std::uint16_t PaletteMap::position(Color8 c) const noexcept {
  if (c.a != 255) {
    const auto found = translucent_.find(detail::key_of(c));
    return found != translucent_.end() ? found->second : std::uint16_t{0};
  }
  const std::uint32_t number = detail::color_number(c);
  return blocks_[directory_[detail::cell_of(number)]][detail::place_in_cell(number)];
}

// Numbers first, in vectors; then the look-ups, which wait for memory and not for each other.
template <int kChannels>
void PaletteMap::map_row(const std::uint8_t* codes,
                         std::span<std::uint16_t> positions) const noexcept {
  constexpr std::size_t kRun = 256;
  std::array<std::uint32_t, kRun> numbers;
  while (!positions.empty()) {
    const auto run = positions.first(std::min(kRun, positions.size()));
    for (std::size_t i = 0; i < run.size(); ++i) {
      const std::uint8_t* const p = codes + i * kChannels;
      numbers[i] = detail::color_number(p[0], p[1], p[2]);
    }
    for (std::size_t i = 0; i < run.size(); ++i) {
      const std::uint32_t cell = detail::cell_of(numbers[i]);
      run[i] = blocks_[directory_[cell]][detail::place_in_cell(numbers[i])];
      const std::uint8_t* const p = codes + i * kChannels;
      if (kChannels == 4 && p[3] != 255) run[i] = position({p[0], p[1], p[2], p[3]});
    }
    codes += run.size() * kChannels;
    positions = positions.subspan(run.size());
  }
}

void PaletteMap::map(ImageView<const std::uint8_t> codes,
                     ImageView<std::uint16_t> positions) const {
  if ((codes.channels != 3 && codes.channels != 4) || positions.channels != 1 ||
      positions.width != codes.width || positions.height != codes.height) {
    throw std::invalid_argument("palette map: 3 or 4 channels to 1, of one size");
  }
  for (int y = 0; y < codes.height; ++y) {
    const std::uint8_t* const row = codes.row(y).data();
    codes.channels == 3 ? map_row<3>(row, positions.row(y)) : map_row<4>(row, positions.row(y));
  }
}

}  // namespace tristim
