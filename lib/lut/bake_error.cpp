#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lib/core/parallel.h"
#include "lib/lut/grid_points.h"
#include "tristim/color/difference.h"
#include "tristim/lut/bake.h"

namespace tristim {
namespace {

constexpr std::size_t kPart = 1024;    // colours that are compared together
constexpr std::size_t kProbes = 3000;  // colours that tell the size of a cube
constexpr std::size_t kGreys = 4096;

// Differences that are not numbers are infinite.
double difference(const BakeSource& source, Rgb exact, Rgb approximate) {
  const double found = ciede2000(source.appearance(exact), source.appearance(approximate));
  return std::isnan(found) ? std::numeric_limits<double>::infinity() : found;
}

// Adds up what `compare(inputs)`, which gives a difference for each, finds in parts of `inputs`.
template <typename Compare>
BakeError in_parts(const std::vector<Rgb>& inputs, int threads, Compare&& compare) {
  std::vector<BakeError> parts((inputs.size() + kPart - 1) / kPart);
  detail::parallel_for_rows(static_cast<int>(parts.size()), threads, [&](int row) {
    const std::size_t first = static_cast<std::size_t>(row) * kPart;
    const std::span<const Rgb> mine(inputs.data() + first, std::min(kPart, inputs.size() - first));
    const std::vector<double> found = compare(mine);
    BakeError& error = parts[static_cast<std::size_t>(row)];
    for (std::size_t i = 0; i < found.size(); ++i) {
      error.mean += found[i];
      if (i > 0 && found[i] <= error.largest) continue;
      error.largest = found[i];
      error.worst = mine[i];
    }
  });
  BakeError all;
  for (const BakeError& error : parts) {
    all.mean += error.mean;
    if (all.colors > 0 && error.largest <= all.largest) continue;
    all.largest = error.largest;
    all.worst = error.worst;
    all.colors = 1;
  }
  all.colors = inputs.size();
  all.mean /= static_cast<double>(std::max<std::size_t>(inputs.size(), 1));
  return all;
}

// The cell of a cube of `size` points about an input, as a cube of its own, and the place in it.
struct LoneCell {
  Lut3D cube{{}, 2, std::vector<float>(24)};
  Rgb place;
};

double cell_of(double at, int size, double& fraction) {
  const double position = at * (size - 1);
  const double cell = std::min(std::floor(position), size - 2.0);
  fraction = position - cell;
  return cell;
}

LoneCell lone_cell(const BakeSource& source, const detail::GridPoints& points, int size,
                   Rgb input) {
  LoneCell lone;
  const Rgb at = points.place(input);
  const Rgb cell{cell_of(at.r, size, lone.place.r), cell_of(at.g, size, lone.place.g),
                 cell_of(at.b, size, lone.place.b)};
  std::vector<Rgb> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(
        points.input({(cell.r + (i & 1)) / (size - 1), (cell.g + (i >> 1 & 1)) / (size - 1),
                      (cell.b + (i >> 2)) / (size - 1)}));
  }
  source.apply(corners);
  for (std::size_t i = 0; i < 8; ++i) {
    lone.cube.rgb[3 * i] = static_cast<float>(corners[i].r);
    lone.cube.rgb[3 * i + 1] = static_cast<float>(corners[i].g);
    lone.cube.rgb[3 * i + 2] = static_cast<float>(corners[i].b);
  }
  return lone;
}

}  // namespace

BakeError bake_error(const BakeSource& source, const Lut& lut, const std::vector<Rgb>& inputs,
                     const LutInterpolation& interpolation, int threads) {
  return in_parts(inputs, threads, [&](std::span<const Rgb> some) {
    std::vector<Rgb> exact(some.begin(), some.end());
    source.apply(exact);
    std::vector<double> found;
    for (std::size_t i = 0; i < some.size(); ++i) {
      found.push_back(difference(source, exact[i], evaluate(lut, some[i], interpolation)));
    }
    return found;
  });
}

BakeError bake_error(const BakeSource& source, const Lut& lut, const BakeGrid& grid,
                     const LutInterpolation& interpolation, int threads) {
  const detail::GridPoints points(grid);
  return bake_error(source, lut, detail::many_inputs(points, grid.range), interpolation, threads);
}

BakeError grey_error(const BakeSource& source, const Lut& lut, const BakeGrid& grid,
                     const LutInterpolation& interpolation, int threads) {
  const detail::GridPoints points(grid);
  return bake_error(source, lut, detail::grey_inputs(points, kGreys), interpolation, threads);
}

double cube_error(const BakeSource& source, const BakeGrid& grid, int size,
                  std::span<const Rgb> inputs, const LutInterpolation& interpolation, int threads) {
  (void)cube_samples(size);  // refuses sizes that no cube has
  const detail::GridPoints points(grid);
  const auto compare = [&](std::span<const Rgb> some) {
    std::vector<Rgb> exact(some.begin(), some.end());
    source.apply(exact);
    std::vector<double> found;
    for (std::size_t i = 0; i < some.size(); ++i) {
      const LoneCell cell = lone_cell(source, points, size, some[i]);
      found.push_back(difference(source, exact[i], interpolation.evaluate(cell.cube, cell.place)));
    }
    return found;
  };
  return in_parts({inputs.begin(), inputs.end()}, threads, compare).largest;
}

std::optional<int> cube_size_for(const BakeSource& source, const BakeGrid& grid, double most,
                                 const LutInterpolation& interpolation, int threads) {
  const detail::GridPoints points(grid);
  const std::vector<Rgb> inputs = detail::chance_inputs(points, grid.range, kProbes);
  const auto reaches = [&](int size) {
    return cube_error(source, grid, size, inputs, interpolation, threads) <= most;
  };
  if (!reaches(kMostCubeSize)) return std::nullopt;
  int below = 1;
  int size = kMostCubeSize;
  while (size - below > 1) {
    const int middle = (below + size) / 2;
    (reaches(middle) ? size : below) = middle;
  }
  return size;
}

}  // namespace tristim
