#include <algorithm>

#include "tristim/palette/quantize.h"

namespace tristim {
namespace {

std::uint8_t level(int i, int last) {
  return static_cast<std::uint8_t>(last == 0 ? 0 : (i * 255 * 2 + last) / (2 * last));
}

std::vector<Color8> levels_of_bits(std::array<int, 3> bits) {
  const auto [red, green, blue] = bits;
  std::vector<Color8> palette;
  for (int i = 0; i < 1 << (red + green + blue); ++i) {
    const int r = i >> (green + blue);
    const int g = i >> blue & ((1 << green) - 1);
    const int b = i & ((1 << blue) - 1);
    palette.push_back(
        {level(r, (1 << red) - 1), level(g, (1 << green) - 1), level(b, (1 << blue) - 1)});
  }
  return palette;
}

// Bits that `colors` colours can tell, green before red before blue.
std::array<int, 3> bits_within(int colors) {
  std::array<int, 3> bits{};
  constexpr std::size_t kTurns[] = {1, 0, 2};
  for (int i = 0; i < 16 && 2 << i <= colors; ++i) ++bits[kTurns[i % 3]];
  return bits;
}

}  // namespace

std::vector<Color8> choose_fixed(const PaletteTask& task) {
  const bool given = task.bits != std::array<int, 3>{};
  return levels_of_bits(given ? task.bits : bits_within(task.colors));
}

std::vector<Color8> choose_fixed_332(const PaletteTask& /*task*/) {
  return levels_of_bits({3, 3, 2});
}

std::vector<Color8> choose_uniform(const PaletteTask& task) {
  int side = 1;
  while ((side + 1) * (side + 1) * (side + 1) <= task.colors) ++side;
  std::vector<Color8> palette;
  if (side > 1) {
    for (int i = 0; i < side * side * side; ++i) {
      palette.push_back({level(i / (side * side), side - 1), level(i / side % side, side - 1),
                         level(i % side, side - 1)});
    }
  }
  // Greys in equal steps, but for those of the cube.
  const int greys = task.colors - static_cast<int>(palette.size());
  const std::size_t cube = palette.size();
  for (int i = 0; i < greys; ++i) {
    const std::uint8_t v = side > 1 ? level(i + 1, greys + 1) : level(i, greys - 1);
    const Color8 grey{v, v, v};
    if (std::find(palette.begin(), palette.begin() + static_cast<std::ptrdiff_t>(cube), grey) ==
        palette.begin() + static_cast<std::ptrdiff_t>(cube)) {
      palette.push_back(grey);
    }
  }
  return palette;
}

}  // namespace tristim
