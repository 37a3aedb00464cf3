#include "tristim/palette/remap.h"

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
    : directory_(detail::kColorCells) {
  if (palette.empty() || palette.size() > 65536) {
    throw std::invalid_argument("palette: " + std::to_string(palette.size()) +
                                " colours, expected 1 to 65536");
  }
  const Findable entries = findable(palette, metric);
  const std::vector<Histogram::Entry> colors = histogram.entries();
  if (entries.position.empty() || colors.empty()) return;
  const detail::ColorCells cells(colors, metric);
  const detail::Nearest nearest = detail::nearest_entries(cells.colors, entries.places);
  for (std::size_t i = 0; i < cells.entry.size(); ++i) {
    const Color8 c = colors[cells.entry[i]].color;
    const std::uint16_t position =
        c.a == 0 ? entries.transparent : entries.position[nearest.index[i]];
    if (c.a != 255) {
      translucent_[detail::key_of(c)] = position;
      continue;
    }
    std::uint32_t& block = directory_[detail::cell_of(c.r, c.g, c.b)];
    if (block == 0) {
      blocks_.emplace_back();
      block = static_cast<std::uint32_t>(blocks_.size());
    }
    blocks_[block - 1][detail::place_in_cell(c.r, c.g, c.b)] = position;
  }
}

std::uint16_t PaletteMap::position(Color8 c) const noexcept {
  if (c.a != 255) {
    const auto found = translucent_.find(detail::key_of(c));
    return found != translucent_.end() ? found->second : std::uint16_t{0};
  }
  const std::uint32_t block = directory_[detail::cell_of(c.r, c.g, c.b)];
  return block == 0 ? std::uint16_t{0} : blocks_[block - 1][detail::place_in_cell(c.r, c.g, c.b)];
}

void PaletteMap::map(ImageView<const std::uint8_t> codes,
                     ImageView<std::uint16_t> positions) const {
  if ((codes.channels != 3 && codes.channels != 4) || positions.channels != 1 ||
      positions.width != codes.width || positions.height != codes.height) {
    throw std::invalid_argument("palette map: 3 or 4 channels to 1, of one size");
  }
  for (int y = 0; y < codes.height; ++y) {
    const std::uint8_t* pixel = codes.row(y).data();
    for (std::uint16_t& to : positions.row(y)) {
      to = position(
          {pixel[0], pixel[1], pixel[2], codes.channels == 4 ? pixel[3] : std::uint8_t{255}});
      pixel += codes.channels;
    }
  }
}

}  // namespace tristim
