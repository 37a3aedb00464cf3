#include <algorithm>
#include <cstddef>
#include <deque>
#include <span>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

using Entry = Histogram::Entry;
using Box = std::span<Entry>;  // some of the entries, at least one

constexpr std::uint8_t Color8::*kChannels[] = {&Color8::r, &Color8::g, &Color8::b};

std::uint64_t pixels(Box box) {
  std::uint64_t sum = 0;
  for (const Entry& entry : box) sum += entry.count;
  return sum;
}

// The channel in which the tight box is longest; of equal ones red before green before blue.
std::uint8_t Color8::*longest_side(Box box) {
  std::uint8_t Color8::*longest = kChannels[0];
  int length = -1;
  for (const auto channel : kChannels) {
    const auto [low, high] = std::minmax_element(
        box.begin(), box.end(),
        [channel](const Entry& a, const Entry& b) { return a.color.*channel < b.color.*channel; });
    const int side = high->color.*channel - low->color.*channel;
    if (side > length) {
      length = side;
      longest = channel;
    }
  }
  return longest;
}

// How many entries of the sorted box come before the cut: up to and with the median pixel's, both
// parts not empty.
std::size_t median_cut_point(Box box) {
  const std::uint64_t half = (pixels(box) + 1) / 2;
  std::uint64_t seen = 0;
  std::size_t cut = 0;
  while (seen < half) seen += box[cut++].count;
  return std::min(cut, box.size() - 1);
}

Color8 centroid(Box box) {
  std::uint64_t r = 0;
  std::uint64_t g = 0;
  std::uint64_t b = 0;
  for (const Entry& entry : box) {
    r += entry.color.r * entry.count;
    g += entry.color.g * entry.count;
    b += entry.color.b * entry.count;
  }
  const std::uint64_t n = pixels(box);
  const auto mean = [n](std::uint64_t sum) {
    return static_cast<std::uint8_t>((2 * sum + n) / (2 * n));
  };
  return {mean(r), mean(g), mean(b)};
}

int luma(Color8 c) { return 299 * c.r + 587 * c.g + 114 * c.b; }

}  // namespace

std::vector<Color8> median_cut(const Histogram& histogram, int colors) {
  std::vector<Entry> entries = histogram.entries();
  const auto wanted = static_cast<std::size_t>(std::max(colors, 0));
  if (entries.empty() || wanted == 0) return {};
  std::deque<Box> open{Box(entries)};
  std::vector<Box> done;  // boxes of one colour
  while (!open.empty() && open.size() + done.size() < wanted) {
    const Box box = open.front();
    open.pop_front();
    if (box.size() == 1) {
      done.push_back(box);
      continue;
    }
    const auto side = longest_side(box);
    std::sort(box.begin(), box.end(), [side](const Entry& a, const Entry& b) {
      return a.color.*side != b.color.*side ? a.color.*side < b.color.*side : a.color < b.color;
    });
    const std::size_t cut = median_cut_point(box);
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
