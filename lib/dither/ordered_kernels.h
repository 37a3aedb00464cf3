#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "lib/dither/level_guess.h"
#include "tristim/dither/levels.h"

namespace tristim::detail {

/// How the two levels that bracket a light are found.
enum class LevelsWay {
  kTwo,     ///< there are no others
  kEven,    ///< all steps are equal: arithmetic
  kFew,     ///< one comparison for each level
  kBins,    ///< a table by the leading bits of the float
  kSearch,  ///< a search, where such a table would be too large; not in vectors
};

/// The levels of a channel, ready for rows. Level i is at light[i].
struct OrderedLevels {
  OrderedLevels(const MixLevels& mix, int matrix_ranks);

  LevelsWay way = LevelsWay::kSearch;
  float lowest, highest;   // light of the first and of the last level
  float ranks;             // of the matrix
  float ranks_per_light;   // kTwo
  float levels_per_light;  // kEven
  float last;              // number of the last level

  /// A stretch of floats with one binary start, which holds the beginning of one level at most.
  struct Bin {
    float knot;           // from here on the next level; infinite where none begins
    std::uint32_t lower;  // the level where the stretch begins
  };
  struct Level {
    float light;
    float ranks_per_light;  // 0 for the last level, with which nothing is mixed
  };
  std::vector<Bin> bins;
  std::vector<Level> levels;
  int shift = 0;               // bits of a float that tell nothing about the bin
  std::int32_t first_bin = 0;  // the others, of bins[0], which reaches down to the lowest level
  LevelSearch search;
  std::optional<LevelGuess> guess;  // of the level taken, where they lie on a curve; kBins alone

  std::vector<std::int32_t> codes;
  bool codes_count = false;  // codes[i] is codes[0] + i

 private:
  bool make_bins(int bin_shift);
};

inline constexpr std::size_t kMostLanes = 64;  // floats of a vector

/// One row of one channel.
struct OrderedRow {
  const OrderedLevels* levels = nullptr;
  const float* least = nullptr;  // ranks above the lower level that take the upper one: rank + 1/2;
                                 // `period` of them, and their beginning once more for kMostLanes
  std::size_t period = 0;        // a multiple of the matrix's width, at least kMostLanes
  std::size_t column = 0;        // of the first pixel, below the period
};

/// The rows in one instruction set; all of them give the same codes.
struct OrderedKernels {
  std::string_view name;

  /// `count` samples of a channel. `strength`: a number for each pixel, or nullptr.
  void (*row)(const OrderedRow& row, const float* in, const float* strength, std::size_t count,
              std::uint16_t* out) = nullptr;
};

/// The definition.
const OrderedKernels& scalar_ordered_kernels() noexcept;

/// By Highway, for every instruction set that this processor has, best first.
std::span<const OrderedKernels> simd_ordered_kernels();

/// Those that the environment's TRISTIM_SIMD names, else the best.
const OrderedKernels& ordered_kernels();

}  // namespace tristim::detail
