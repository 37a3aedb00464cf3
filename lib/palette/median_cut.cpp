#include <algorithm>
#include <cstddef>
#include <deque>
#include <span>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

using Entry = Histogram::Entry;
using Box = std::span<Entry>;  // some of the entries, ascending, at least one

// Those that have a side in a box, and of equal ones the first is cut.
constexpr std::uint8_t Color8::*kChannels[] = {&Color8::r, &Color8::g, &Color8::b, &Color8::a};

// The channel in which the tight box is longest.
std::uint8_t Color8::*longest_side(Box box) {
  Color8 low = box.front().color;
  Color8 high = low;
  for (const auto& [color, count] : box) {
    for (const auto channel : kChannels) {
      low.*channel = std::min(low.*channel, color.*channel);
      high.*channel = std::max(high.*channel, color.*channel);
    }
  }
  const auto side = [&](auto channel) { return high.*channel - low.*channel; };
  return *std::max_element(std::begin(kChannels), std::end(kChannels),
                           [&](auto a, auto b) { return side(a) < side(b); });
}

// Of the box in the order of `side`, then of colour, the entries up to and with the median pixel's
// come to the front, both parts not empty and ascending. Returns how many they are. No sorting: the
// order within a value of `side` is there already.
std::size_t cut_at_median(Box box, std::uint8_t Color8::*side, std::vector<Entry>& scratch) {
  std::array<std::uint64_t, 256> pixels{};
  std::uint64_t total = 0;
  for (const auto& [color, count] : box) {
    pixels[color.*side] += count;
    total += count;
  }
  const std::uint64_t half = (total + 1) / 2;
  std::uint64_t below = 0;
  std::size_t median = 0;
  while (below + pixels[median] < half) below += pixels[median++];

  const auto last_color =
      static_cast<std::size_t>(std::max_element(box.begin(), box.end(),
                                                [side](const Entry& a, const Entry& b) {
                                                  return a.color.*side < b.color.*side;
                                                })
                                   ->color.*
                               side);
  std::size_t last_entries = 0;  // of the highest value: one of them stays behind
  for (const auto& [color, count] : box) last_entries += color.*side == last_color ? 1U : 0U;

  std::size_t front = 0;
  std::size_t equal = 0;  // entries of the median's value so far
  scratch.clear();
  for (const Entry& entry : box) {
    const std::size_t value = entry.color.*side;
    bool first = value < median;
    if (value == median) {
      const bool only_one_left = median == last_color && equal + 1 == last_entries;
      first = below < half && !only_one_left;
      below += entry.count;
      ++equal;
    }
    first ? void(box[front++] = entry) : scratch.push_back(entry);
  }
  std::copy(scratch.begin(), scratch.end(), box.begin() + static_cast<std::ptrdiff_t>(front));
  return front;
}

Color8 centroid(Box box) {
  std::array<std::uint64_t, 4> sum{};
  std::uint64_t n = 0;
  for (const auto& [color, count] : box) {
    for (std::size_t c = 0; c < 4; ++c) sum[c] += color.*kChannels[c] * count;
    n += count;
  }
  Color8 mean;
  for (std::size_t c = 0; c < 4; ++c) {
    mean.*kChannels[c] = static_cast<std::uint8_t>((2 * sum[c] + n) / (2 * n));
  }
  return mean;
}

int luma(Color8 c) { return 299 * c.r + 587 * c.g + 114 * c.b; }

}  // namespace

std::vector<Color8> choose_median_cut(const PaletteTask& task) {
  std::vector<Entry> entries(task.entries.begin(), task.entries.end());
  std::vector<Entry> scratch;
  const auto wanted = static_cast<std::size_t>(task.colors);
  std::deque<Box> open{Box(entries)};
  std::vector<Box> done;  // boxes of one colour
  while (!open.empty() && open.size() + done.size() < wanted) {
    const Box box = open.front();
    open.pop_front();
    if (box.size() == 1) {
      done.push_back(box);
      continue;
    }
    const std::size_t cut = cut_at_median(box, longest_side(box), scratch);
    open.push_back(box.first(cut));
    open.push_back(box.subspan(cut));
  }
  done.insert(done.end(), open.begin(), open.end());
  std::vector<Color8> palette;
  for (const Box box : done) palette.push_back(centroid(box));
  std::sort(palette.begin(), palette.end(),
            [](Color8 a, Color8 b) { return luma(a) != luma(b) ? luma(a) < luma(b) : a < b; });
  palette.erase(std::unique(palette.begin(), palette.end()), palette.end());
  return palette;
}

}  // namespace tristim
