#include "tristim/lut/bake.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "lib/core/parallel.h"
#include "lib/lut/grid_points.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

void store(Rgb color, Rgb input, float* to) {
  if (!std::isfinite(color.r) || !std::isfinite(color.g) || !std::isfinite(color.b)) {
    throw std::invalid_argument("bake: no finite colour comes of " + shortest(input.r) + " " +
                                shortest(input.g) + " " + shortest(input.b));
  }
  to[0] = static_cast<float>(color.r);
  to[1] = static_cast<float>(color.g);
  to[2] = static_cast<float>(color.b);
}

// What the source makes of `inputs`, into a table.
void bake_row(const BakeSource& source, const std::vector<Rgb>& inputs, float* to) {
  std::vector<Rgb> colors = inputs;
  source.apply(colors);
  for (std::size_t i = 0; i < colors.size(); ++i) store(colors[i], inputs[i], to + 3 * i);
}

double part(int i, int size) { return static_cast<double>(i) / (size - 1); }

}  // namespace

Lut1D bake_curves(const BakeSource& source, const LutRange& range, int size, int threads) {
  constexpr int kRow = 1024;  // entries that are baked together
  Lut1D lut{range, size, std::vector<float>(curve_samples(size))};
  const detail::GridPoints points({range, {}});
  detail::parallel_for_rows((size + kRow - 1) / kRow, threads, [&](int row) {
    std::vector<Rgb> inputs;
    for (int i = row * kRow; i < std::min(size, (row + 1) * kRow); ++i) {
      const double at = part(i, size);
      inputs.push_back(points.input({at, at, at}));
    }
    bake_row(source, inputs, lut.rgb.data() + std::ptrdiff_t{3} * row * kRow);
  });
  return lut;
}

Lut bake_cube(const BakeSource& source, const BakeGrid& grid, int size, int threads) {
  Lut3D cube{grid.shaper ? LutRange{} : grid.range, size, std::vector<float>(cube_samples(size))};
  const detail::GridPoints points(grid);
  detail::parallel_for_rows(size * size, threads, [&](int row) {
    std::vector<Rgb> inputs;
    for (int r = 0; r < size; ++r) {
      inputs.push_back(
          points.input({part(r, size), part(row % size, size), part(row / size, size)}));
    }
    bake_row(source, inputs, cube.rgb.data() + std::ptrdiff_t{3} * row * size);
  });
  Lut lut;
  if (grid.shaper) lut.steps.push_back(*grid.shaper);
  lut.steps.emplace_back(std::move(cube));
  return lut;
}

}  // namespace tristim
