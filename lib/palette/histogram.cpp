#include "tristim/palette/histogram.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lib/palette/color_cell.h"

namespace tristim {
namespace {

constexpr std::size_t kSlab = 512;            // blocks
constexpr std::uint64_t kCarry = 1ULL << 32;  // what a count loses when it overflows

using detail::cell_of;
using detail::color_of;
using detail::key_of;
using detail::place_in_cell;

// Sorted, with one entry for each colour.
std::vector<Histogram::Entry> gathered(std::vector<Histogram::Entry> entries) {
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.color < b.color; });
  std::size_t kept = 0;
  for (const Histogram::Entry& entry : entries) {
    if (kept > 0 && entries[kept - 1].color == entry.color) {
      entries[kept - 1].count += entry.count;
    } else {
      entries[kept++] = entry;
    }
  }
  entries.resize(kept);
  return entries;
}

void check_channels(int channels) {
  if (channels == 3 || channels == 4) return;
  throw std::invalid_argument("histogram: " + std::to_string(channels) +
                              " channels, expected 3 or 4");
}

}  // namespace

std::uint32_t Histogram::new_block(std::uint32_t cell) {
  if (directory_.empty()) directory_.resize(detail::kColorCells);
  if (blocks_.empty() || blocks_.back().size() == kSlab) blocks_.emplace_back().reserve(kSlab);
  blocks_.back().emplace_back();
  directory_[cell] =
      static_cast<std::uint32_t>((blocks_.size() - 1) * kSlab + blocks_.back().size());
  return directory_[cell];
}

inline Histogram::Block& Histogram::block(std::uint32_t cell) {
  std::uint32_t number = directory_.empty() ? 0 : directory_[cell];
  if (number == 0) number = new_block(cell);
  return blocks_[(number - 1) / kSlab][(number - 1) % kSlab];
}

void Histogram::add(Color8 color, std::uint64_t count) {
  if (count == 0) return;
  if (color.a != 255) {
    translucent_[key_of(color)] += count;
    return;
  }
  std::uint32_t& low =
      block(cell_of(color.r, color.g, color.b))[place_in_cell(color.r, color.g, color.b)];
  const std::uint64_t sum = low + count % kCarry;
  low = static_cast<std::uint32_t>(sum);
  const std::uint64_t carried = count / kCarry + sum / kCarry;
  if (carried > 0) carry_[key_of(color)] += carried * kCarry;
}

template <typename T, typename Weights>
void Histogram::add_rows(ImageView<const T> codes, Weights&& weight) {
  check_channels(codes.channels);
  for (int y = 0; y < codes.height; ++y) {
    const T* pixel = codes.row(y).data();
    for (int x = 0; x < codes.width; ++x, pixel += codes.channels) {
      const std::uint32_t w = weight(x, y);
      const std::uint32_t r = pixel[0] & 255U;
      const std::uint32_t g = pixel[1] & 255U;
      const std::uint32_t b = pixel[2] & 255U;
      if (codes.channels == 4 && pixel[3] != 255) {
        add(color_of(r << 24 | g << 16 | b << 8 | pixel[3]), w);
        continue;
      }
      // Looked up for every pixel: whether the cell is the last one's is a toss-up in noise.
      std::uint32_t& count = block(cell_of(r, g, b))[place_in_cell(r, g, b)];
      count += w;
      if (count < w) carry_[r << 24 | g << 16 | b << 8 | 255] += kCarry;
    }
  }
}

void Histogram::add(ImageView<const std::uint16_t> codes) {
  add_rows(codes, [](int, int) { return 1U; });
}

void Histogram::add(ImageView<const std::uint8_t> codes) {
  add_rows(codes, [](int, int) { return 1U; });
}

void Histogram::add(ImageView<const std::uint16_t> codes, ImageView<const std::uint16_t> weights) {
  if (weights.width != codes.width || weights.height != codes.height || weights.channels != 1) {
    throw std::invalid_argument("histogram: weights differ in size from the codes");
  }
  add_rows(codes, [weights](int x, int y) { return std::uint32_t{*weights.pixel(x, y)}; });
}

void Histogram::merge(const Histogram& other) {
  for (const Entry& entry : other.entries()) add(entry.color, entry.count);
}

std::vector<std::pair<std::uint32_t, const Histogram::Block*>> Histogram::row_of_blocks(
    std::uint32_t r, std::uint32_t g) const {
  std::vector<std::pair<std::uint32_t, const Block*>> used;
  for (std::uint32_t b = 0; b < 256; b += 4) {
    const std::uint32_t number = directory_[cell_of(r, g, b)];
    if (number != 0) used.emplace_back(b, &blocks_[(number - 1) / kSlab][(number - 1) % kSlab]);
  }
  return used;
}

std::vector<Histogram::Entry> Histogram::entries() const {
  std::vector<Entry> all;
  std::size_t most = translucent_.size();
  for (const auto& slab : blocks_) {
    for (const Block& block : slab) {
      most += static_cast<std::size_t>(
          std::count_if(block.begin(), block.end(), [](std::uint32_t n) { return n != 0; }));
    }
  }
  all.reserve(most);
  // Of a row of cells, which is looked for once in 4 rows of colours, most are empty.
  std::vector<std::pair<std::uint32_t, const Block*>> used;  // 4 blues from here on
  for (std::uint32_t row = 0; row < 1U << 16 && !directory_.empty(); ++row) {
    const std::uint32_t r = row >> 8;
    const std::uint32_t g = row & 255;
    if (g % 4 == 0) used = row_of_blocks(r, g);
    for (const auto& [b0, block] : used) {
      for (std::uint32_t b = b0; b < b0 + 4; ++b) {
        const std::uint32_t n = (*block)[place_in_cell(r, g, b)];
        if (n != 0) all.push_back({color_of(r << 24 | g << 16 | b << 8 | 255), n});
      }
    }
  }
  if (carry_.empty() && translucent_.empty()) return all;
  for (const auto* rest : {&carry_, &translucent_}) {
    for (const auto& [key, n] : *rest) all.push_back({color_of(key), n});
  }
  return gathered(std::move(all));
}

Histogram with_alpha(const Histogram& histogram, AlphaMode mode) {
  const auto over_black = [](std::uint8_t code, std::uint8_t alpha) {
    return static_cast<std::uint8_t>((code * alpha * 2 + 255) / 510);
  };
  Histogram result;
  for (const auto& [c, count] : histogram.entries()) {
    if (mode == AlphaMode::kOver) {
      result.add(Color8{over_black(c.r, c.a), over_black(c.g, c.a), over_black(c.b, c.a)}, count);
    } else if (mode == AlphaMode::kThreshold) {
      if (c.a >= 128) result.add(Color8{c.r, c.g, c.b}, count);
    } else {
      result.add(c.a == 0 ? Color8{0, 0, 0, 0} : c, count);
    }
  }
  return result;
}

}  // namespace tristim
