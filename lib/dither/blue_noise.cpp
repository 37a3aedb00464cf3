#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "lib/dither/cells.h"
#include "lib/dither/void_and_cluster.h"
#include "tristim/dither/matrices.h"

namespace tristim {
namespace {

constexpr int kBuiltInSize = 128;
constexpr std::array<std::uint16_t, std::size_t{kBuiltInSize} * kBuiltInSize> kBuiltIn{
#include "luts/blue_noise_128.csv"
};

ThresholdMatrix ranked(int size, const std::vector<std::size_t>& order) {
  ThresholdMatrix matrix = detail::square_matrix(size);
  detail::assign_ranks(order, matrix);
  return matrix;
}

// The order of a torus' cells; the last one made is kept, for a device's channels and an
// animation's frames ask for the same one after the other.
std::vector<std::size_t> order_of(const detail::Torus& torus, std::uint64_t seed) {
  struct Kept {
    detail::Torus torus;
    std::uint64_t seed;
    std::vector<std::size_t> order;
  };
  static std::mutex mutex;
  static std::optional<Kept> last;
  const std::scoped_lock lock(mutex);
  if (!last || last->torus != torus || last->seed != seed) {
    last = Kept{torus, seed, detail::void_and_cluster(torus, seed)};
  }
  return last->order;
}

// One slice of a stack; within it the order of the whole stack ranks the cells.
std::vector<std::size_t> slice_order(int size, int slice, std::uint64_t seed) {
  const std::size_t cells = static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
  const std::size_t first = static_cast<std::size_t>(slice) * cells;
  std::vector<std::size_t> order;
  for (const std::size_t cell : order_of({size, size, kBlueNoiseFrames}, seed)) {
    if (cell >= first && cell < first + cells) order.push_back(cell - first);
  }
  return order;
}

// The matrix begun at another place. Far from each other two places of blue noise know nothing of
// each other, so this is another mask for another channel. The steps spread the places of four
// channels evenly [Roberts18].
ThresholdMatrix moved(const ThresholdMatrix& matrix, int channel) {
  const auto place = [&](double step, int size) {
    const double part = step * channel;
    return static_cast<int>((part - static_cast<int>(part)) * size);
  };
  const int dx = place(0.7548776662466927, matrix.width);
  const int dy = place(0.5698402909980532, matrix.height);
  ThresholdMatrix result = matrix;
  auto to = result.rank.begin();
  for (int y = 0; y < matrix.height; ++y) {
    const std::uint16_t* row = matrix.row(y + dy);
    to = std::copy(row + dx, row + matrix.width, to);
    to = std::copy(row, row + dx, to);
  }
  return result;
}

}  // namespace

ThresholdMatrix blue_noise_matrix(const MatrixParameters& parameters) {
  const int size = parameters.size;
  if (size < 1 || size > kMostBlueNoise) {
    throw std::invalid_argument("size of blue noise: " + std::to_string(size) + "; expected 1 to " +
                                std::to_string(kMostBlueNoise));
  }
  if (parameters.frame) {
    const int slice = (*parameters.frame % kBlueNoiseFrames + kBlueNoiseFrames) % kBlueNoiseFrames;
    return moved(ranked(size, slice_order(size, slice, parameters.seed)), parameters.channel);
  }
  if (size == kBuiltInSize && parameters.seed == 0) {
    ThresholdMatrix matrix = detail::square_matrix(size);
    matrix.rank.assign(kBuiltIn.begin(), kBuiltIn.end());
    return moved(matrix, parameters.channel);
  }
  return moved(ranked(size, order_of({size, size, 1}, parameters.seed)), parameters.channel);
}

}  // namespace tristim
