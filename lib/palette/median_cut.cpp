#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>

#include "lib/palette/color_cell.h"
#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

using detail::color_of;
using detail::key_of;

// Those that have a side in a box, and of equal ones the first is cut.
constexpr std::size_t kChannels = 4;

// Some of the colours, at least one, in any order.
struct Box {
  std::size_t first = 0, end = 0;
  std::size_t size() const noexcept { return end - first; }
};

// Colours with their pixels, in planes: what is asked of all colours of a box is read in one go.
class Boxes {
 public:
  explicit Boxes(std::span<const Histogram::Entry> entries)
      : keys_(entries.size()),
        pixels_(entries.size()),
        sorted_keys_(entries.size()),
        sorted_pixels_(entries.size()) {
    for (std::size_t i = 0; i < entries.size(); ++i) {
      keys_[i] = key_of(entries[i].color);
      pixels_[i] = entries[i].count;
    }
  }

  Box all() const noexcept { return {0, keys_.size()}; }

  // Parts a box of two colours or more along its longest side: the colours up to and with the
  // median pixel's in the order of that side, then of colour, come to the front. Returns where the
  // second part begins; both are not empty.
  std::size_t cut(Box box) {
    const int shift = longest_side(box);
    const auto value = [&](std::size_t i) { return keys_[i] >> shift & 255; };
    std::array<std::uint64_t, 256> pixels{};
    std::array<std::size_t, 256> colors{};
    for (std::size_t i = box.first; i < box.end; ++i) {
      pixels[value(i)] += pixels_[i];
      ++colors[value(i)];
    }
    std::uint64_t total = 0;
    for (const std::uint64_t n : pixels) total += n;
    const std::uint64_t half = (total + 1) / 2;
    std::uint64_t below = 0;
    std::uint32_t median = 0;
    while (below + pixels[median] < half) below += pixels[median++];
    const Box plane = bring_together(box, shift, median, colors);
    // One of the highest value stays behind.
    const std::size_t last = plane.end == box.end ? plane.end - 1 : plane.end;
    std::size_t second = plane.first;
    sort_by_color(plane);
    while (second < last && below < half) below += pixels_[second++];
    return second;
  }

  Color8 centroid(Box box) const {
    std::array<std::uint64_t, kChannels> sum{};
    std::uint64_t n = 0;
    for (std::size_t i = box.first; i < box.end; ++i) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        sum[c] += (keys_[i] >> (24 - 8 * c) & 255) * pixels_[i];
      }
      n += pixels_[i];
    }
    std::uint32_t key = 0;
    for (const std::uint64_t s : sum)
      key = key << 8 | static_cast<std::uint32_t>((2 * s + n) / (2 * n));
    return color_of(key);
  }

 private:
  // The channel in which the tight box is longest, as a shift of keys.
  int longest_side(Box box) const {
    std::array<std::uint32_t, kChannels> low;
    std::array<std::uint32_t, kChannels> high{};
    low.fill(255);
    for (std::size_t i = box.first; i < box.end; ++i) {
      for (std::size_t c = 0; c < kChannels; ++c) {
        const std::uint32_t code = keys_[i] >> (24 - 8 * c) & 255;
        low[c] = std::min(low[c], code);
        high[c] = std::max(high[c], code);
      }
    }
    std::size_t longest = 0;
    for (std::size_t c = 1; c < kChannels; ++c) {
      if (high[c] - low[c] > high[longest] - low[longest]) longest = c;
    }
    return static_cast<int>(24 - 8 * longest);
  }

  // Puts the box's colours below the median value before those that have it, and those before the
  // rest; where those that have it are.
  Box bring_together(Box box, int shift, std::uint32_t median,
                     const std::array<std::size_t, 256>& colors) {
    std::array<std::size_t, 3> next{box.first, box.first, 0};  // below, with and above the median
    for (std::uint32_t v = 0; v < median; ++v) next[1] += colors[v];
    next[2] = next[1] + colors[median];
    const Box plane{next[1], next[2]};
    for (std::size_t i = box.first; i < box.end; ++i) {
      const std::uint32_t v = keys_[i] >> shift & 255;
      const std::size_t to = next[(v >= median ? 1U : 0U) + (v > median ? 1U : 0U)]++;
      sorted_keys_[to] = keys_[i];
      sorted_pixels_[to] = pixels_[i];
    }
    const auto take = [box](const auto& from, auto& into) {
      const auto begin = from.begin() + static_cast<std::ptrdiff_t>(box.first);
      std::copy(begin, begin + static_cast<std::ptrdiff_t>(box.size()),
                into.begin() + static_cast<std::ptrdiff_t>(box.first));
    };
    take(sorted_keys_, keys_);
    take(sorted_pixels_, pixels_);
    return plane;
  }

  void sort_by_color(Box box) {
    std::vector<std::pair<std::uint32_t, std::uint64_t>> colors;
    for (std::size_t i = box.first; i < box.end; ++i) colors.emplace_back(keys_[i], pixels_[i]);
    std::sort(colors.begin(), colors.end());
    for (std::size_t i = 0; i < colors.size(); ++i) {
      keys_[box.first + i] = colors[i].first;
      pixels_[box.first + i] = colors[i].second;
    }
  }

  std::vector<std::uint32_t> keys_;
  std::vector<std::uint64_t> pixels_;
  std::vector<std::uint32_t> sorted_keys_;  // scratch
  std::vector<std::uint64_t> sorted_pixels_;
};

int luma(Color8 c) { return 299 * c.r + 587 * c.g + 114 * c.b; }

}  // namespace

std::vector<Color8> choose_median_cut(const PaletteTask& task) {
  Boxes boxes(task.entries);
  const auto wanted = static_cast<std::size_t>(task.colors);
  std::deque<Box> open{boxes.all()};
  std::vector<Box> done;  // boxes of one colour
  while (!open.empty() && open.size() + done.size() < wanted) {
    const Box box = open.front();
    open.pop_front();
    if (box.size() == 1) {
      done.push_back(box);
      continue;
    }
    const std::size_t second = boxes.cut(box);
    open.push_back({box.first, second});
    open.push_back({second, box.end});
  }
  done.insert(done.end(), open.begin(), open.end());
  std::vector<Color8> palette;
  for (const Box box : done) palette.push_back(boxes.centroid(box));
  std::sort(palette.begin(), palette.end(),
            [](Color8 a, Color8 b) { return luma(a) != luma(b) ? luma(a) < luma(b) : a < b; });
  palette.erase(std::unique(palette.begin(), palette.end()), palette.end());
  return palette;
}

}  // namespace tristim
