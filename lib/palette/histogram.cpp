#include "tristim/palette/histogram.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "lib/palette/color_cell.h"

namespace tristim {
namespace {

constexpr std::uint32_t kSlab = 1024;      // blocks
constexpr std::uint64_t kMostLow = 65535;  // of a count, in its block

using detail::cell_of;
using detail::color_number;
using detail::color_of;
using detail::key_of;
using detail::place_in_cell;

constexpr auto kOnce = [](int) { return std::uint16_t{1}; };

void check_channels(int channels) {
  if (channels == 3 || channels == 4) return;
  throw std::invalid_argument("histogram: " + std::to_string(channels) +
                              " channels, expected 3 or 4");
}

}  // namespace

std::uint32_t Histogram::new_block(std::uint32_t cell) {
  if (directory_.empty()) directory_.resize(detail::kColorCells);
  if (blocks_ % kSlab == 0) slabs_.emplace_back(kSlab);
  return directory_[cell] = ++blocks_;
}

inline Histogram::Block& Histogram::block(std::uint32_t cell) {
  std::uint32_t number = directory_.empty() ? 0 : directory_[cell];
  if (number == 0) number = new_block(cell);
  return slabs_[(number - 1) / kSlab][(number - 1) % kSlab];
}

inline const Histogram::Block* Histogram::block_of(std::uint32_t cell) const {
  const std::uint32_t number = directory_[cell];
  return number == 0 ? nullptr : &slabs_[(number - 1) / kSlab][(number - 1) % kSlab];
}

void Histogram::carry(std::uint32_t number, std::uint16_t& low, std::uint64_t sum) {
  low = 1;
  carried_[number] += sum - 1;
}

inline void Histogram::count(std::uint32_t number, std::uint64_t pixels) {
  std::uint16_t& low = block(cell_of(number))[place_in_cell(number)];
  const std::uint64_t sum = low + pixels;
  if (sum > kMostLow) return carry(number, low, sum);
  low = static_cast<std::uint16_t>(sum);
}

void Histogram::add(Color8 color, std::uint64_t count) {
  if (count == 0) return;
  if (color.a != 255) {
    translucent_[key_of(color)] += count;
  } else {
    this->count(color_number(color), count);
  }
}

// Numbers first, in vectors; then the counting, whose steps wait for memory and not for each other.
template <int kChannels, typename T, typename Weights>
void Histogram::add_row(const T* pixels, int width, Weights&& weight) {
  constexpr int kRun = 256;
  std::array<std::uint32_t, kRun> numbers;
  for (int first = 0; first < width; first += kRun) {
    const int run = std::min(kRun, width - first);
    const T* const from = pixels + std::ptrdiff_t{first} * kChannels;
    for (int i = 0; i < run; ++i) {
      const T* const p = from + i * kChannels;
      numbers[static_cast<std::size_t>(i)] = color_number(p[0], p[1], p[2]);
    }
    for (int i = 0; i < run; ++i) {
      const std::uint16_t w = weight(first + i);
      const T* const p = from + i * kChannels;
      if (kChannels == 4 && p[3] != 255) {
        add({static_cast<std::uint8_t>(p[0]), static_cast<std::uint8_t>(p[1]),
             static_cast<std::uint8_t>(p[2]), static_cast<std::uint8_t>(p[3])},
            w);
      } else if (w > 0) {
        count(numbers[static_cast<std::size_t>(i)], w);
      }
    }
  }
}

template <typename T, typename Weights>
void Histogram::add_rows(ImageView<const T> codes, Weights&& weights) {
  check_channels(codes.channels);
  for (int y = 0; y < codes.height; ++y) {
    const T* const row = codes.row(y).data();
    if (codes.channels == 3) {
      add_row<3>(row, codes.width, weights(y));
    } else {
      add_row<4>(row, codes.width, weights(y));
    }
  }
}

void Histogram::add(ImageView<const std::uint16_t> codes) {
  add_rows(codes, [](int) { return kOnce; });
}

void Histogram::add(ImageView<const std::uint8_t> codes) {
  add_rows(codes, [](int) { return kOnce; });
}

void Histogram::add(ImageView<const std::uint16_t> codes, ImageView<const std::uint16_t> weights) {
  if (weights.width != codes.width || weights.height != codes.height || weights.channels != 1) {
    throw std::invalid_argument("histogram: weights differ in size from the codes");
  }
  add_rows(codes, [weights](int y) {
    return [row = weights.row(y)](int x) { return row[static_cast<std::size_t>(x)]; };
  });
}

void Histogram::merge(const Histogram& other) {
  if (&other == this) return merge(Histogram(other));
  for (std::uint32_t cell = 0; cell < other.directory_.size(); ++cell) {
    const Block* const from = other.block_of(cell);
    if (from == nullptr) continue;
    for (std::uint32_t i = 0; i < detail::kCellColors; ++i) {
      if ((*from)[i] != 0) count(cell * detail::kCellColors + i, (*from)[i]);
    }
  }
  for (const auto& [number, pixels] : other.carried_) count(number, pixels);
  for (const auto& [key, pixels] : other.translucent_) translucent_[key] += pixels;
}

std::size_t Histogram::opaque_colors() const noexcept {
  std::size_t colors = 0;
  for (const auto& slab : slabs_) {
    for (const Block& block : slab) {
      std::uint32_t used = 0;
      for (const std::uint16_t pixels : block) used += pixels != 0 ? 1U : 0U;
      colors += used;
    }
  }
  return colors;
}

// To `entries` in an order what blocks do not hold.
template <typename Before>
void Histogram::add_carried(std::vector<Entry>& entries, Before&& before) const {
  for (const auto& [number, pixels] : carried_) {
    const Entry carried{detail::numbered_color(number), pixels};
    std::lower_bound(entries.begin(), entries.end(), carried, before)->count += pixels;
  }
  if (translucent_.empty()) return;
  const auto opaque = std::ssize(entries);
  for (const auto& [key, pixels] : translucent_) entries.push_back({color_of(key), pixels});
  std::sort(entries.begin() + opaque, entries.end(), before);
  std::inplace_merge(entries.begin(), entries.begin() + opaque, entries.end(), before);
}

std::vector<Histogram::Entry> Histogram::entries() const {
  // Of a row of cells, which is looked for once in 4 rows of colours, most are empty.
  struct Used {
    std::uint8_t blue;  // the first of 4
    const Block* block;
  };
  std::vector<Used> used;
  std::vector<Entry> all(opaque_colors() + 1);  // one more than is kept is written
  std::size_t size = 0;
  for (std::uint32_t row = 0; row < 1U << 16 && blocks_ > 0; ++row) {
    const std::uint32_t r = row >> 8;
    const std::uint32_t g = row & 255;
    if (g % 4 == 0) {
      used.clear();
      for (std::uint32_t b = 0; b < 256; b += 4) {
        const Block* const block = block_of(cell_of(color_number(r, g, b)));
        if (block != nullptr) used.push_back({static_cast<std::uint8_t>(b), block});
      }
    }
    const std::uint32_t place = place_in_cell(color_number(r, g, 0));
    for (const auto& [blue, block] : used) {
      for (std::uint32_t b = 0; b < 4; ++b) {
        const std::uint16_t pixels = (*block)[place + b];
        all[size] = {color_of(r << 24 | g << 16 | (blue + b) << 8 | 255), pixels};
        size += pixels != 0 ? 1 : 0;  // else the next one takes its place
      }
    }
  }
  all.resize(size);
  add_carried(all, [](const Entry& a, const Entry& b) { return a.color < b.color; });
  return all;
}

std::vector<Histogram::Entry> Histogram::neighbours() const {
  std::vector<Entry> all(opaque_colors() + 1);
  std::size_t size = 0;
  for (std::uint32_t cell = 0; cell < directory_.size(); ++cell) {
    const Block* const block = block_of(cell);
    if (block == nullptr) continue;
    for (std::uint32_t i = 0; i < detail::kCellColors; ++i) {
      all[size] = {detail::numbered_color(cell * detail::kCellColors + i), (*block)[i]};
      size += (*block)[i] != 0 ? 1 : 0;
    }
  }
  all.resize(size);
  add_carried(all, [](const Entry& a, const Entry& b) {
    const std::uint32_t first = color_number(a.color);
    const std::uint32_t second = color_number(b.color);
    return first != second ? first < second : a.color.a < b.color.a;
  });
  return all;
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
