#include <algorithm>

#include "tristim/palette/quantize.h"

namespace tristim {

std::vector<Color8> choose_popularity(const PaletteTask& task) {
  std::vector<Histogram::Entry> entries(task.entries.begin(), task.entries.end());
  const auto before = [](const Histogram::Entry& a, const Histogram::Entry& b) {
    return a.count != b.count ? a.count > b.count : a.color < b.color;
  };
  const auto end = entries.begin() + std::min<std::ptrdiff_t>(task.colors, std::ssize(entries));
  std::nth_element(entries.begin(), end, entries.end(), before);
  std::sort(entries.begin(), end, before);
  std::vector<Color8> palette;
  for (auto entry = entries.begin(); entry != end; ++entry) palette.push_back(entry->color);
  return palette;
}

}  // namespace tristim
