#include "tristim/palette/stable_order.h"

#include <algorithm>
#include <array>

#include "tristim/palette/metric.h"

namespace tristim {
namespace {

constexpr std::size_t kMostCompared = 4096;
constexpr std::size_t kFree = static_cast<std::size_t>(-1);

using Place = std::array<float, 3>;

struct Pair {
  float distance2;
  std::size_t place;  // in the palette before, and now
  std::size_t color;  // of the next palette
};

float distance2(const Place& a, const Place& b) {
  float sum = 0;
  for (std::size_t c = 0; c < 3; ++c) sum += (a[c] - b[c]) * (a[c] - b[c]);
  return sum;
}

std::vector<Place> places_of(std::span<const Rgb> colors) {
  std::vector<Place> places;
  for (const Rgb& c : colors) places.push_back(oklab_place(c));
  return places;
}

// All pairs of a place that the next palette has and a colour that is not fixed, nearest first.
std::vector<Pair> pairs_of(std::span<const Rgb> previous, std::span<const Rgb> next,
                           std::size_t fixed) {
  const bool only_equal = std::max(previous.size(), next.size()) > kMostCompared;
  const std::vector<Place> before = places_of(previous);
  const std::vector<Place> now = places_of(next);
  std::vector<Pair> pairs;
  for (std::size_t place = fixed; place < std::min(before.size(), now.size()); ++place) {
    for (std::size_t color = fixed; color < now.size(); ++color) {
      const float distance = distance2(before[place], now[color]);
      if (!only_equal || distance == 0) pairs.push_back({distance, place, color});
    }
  }
  std::ranges::stable_sort(pairs, {}, &Pair::distance2);
  return pairs;
}

}  // namespace

std::vector<std::size_t> stable_order(std::span<const Rgb> previous, std::span<const Rgb> next,
                                      std::size_t fixed) {
  std::vector<std::size_t> order(next.size(), kFree);
  std::vector<bool> taken(next.size());
  const auto take = [&](std::size_t place, std::size_t color) {
    if (order[place] != kFree || taken[color]) return;
    order[place] = color;
    taken[color] = true;
  };
  for (std::size_t i = 0; i < std::min(fixed, next.size()); ++i) take(i, i);
  for (const Pair& pair : pairs_of(previous, next, fixed)) take(pair.place, pair.color);
  std::size_t color = 0;
  for (std::size_t place = 0; place < order.size(); ++place) {
    if (order[place] != kFree) continue;
    while (taken[color]) ++color;
    take(place, color);
  }
  return order;
}

}  // namespace tristim
