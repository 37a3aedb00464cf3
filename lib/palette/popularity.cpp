#include <algorithm>

#include "tristim/palette/quantize.h"

namespace tristim {

std::vector<Color8> popularity(const Histogram& histogram, int colors) {
  std::vector<Histogram::Entry> entries = histogram.entries();
  std::stable_sort(entries.begin(), entries.end(),
                   [](const auto& a, const auto& b) { return a.count > b.count; });
  std::vector<Color8> palette;
  for (const auto& entry : entries) {
    if (palette.size() == static_cast<std::size_t>(std::max(colors, 0))) break;
    palette.push_back(entry.color);
  }
  return palette;
}

}  // namespace tristim
