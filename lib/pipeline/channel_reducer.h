#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "tristim/device/display.h"
#include "tristim/dither/levels.h"
#include "tristim/dither/ordered.h"
#include "tristim/pipeline/reduce.h"

namespace tristim::detail {

/// A channel whose codes are chosen with all of its light in view.
struct WholeChannel {
  const WholePictureDither* dither;
  MixLevels levels;
};

/// What turns the light of one channel into codes.
using ChannelReducer = std::variant<NearestLevel, OrderedDither, LevelDiffusion, WholeChannel>;

/// `matrix` of an ordered method, else nullptr. A whole-picture method of `options` must outlive
/// what is made.
ChannelReducer channel_reducer(const LevelScale& scale, const ReduceOptions& options,
                               const ThresholdMatrix* matrix, int channel, int width);

/// Light to the numbers of the mix, in place.
void to_mix(Mix mix, ChannelRow<float> row) noexcept;

/// Of row `y` of a picture the pixels from `x` on, by every reducer but those that need all of it;
/// error diffusion wants whole rows. `in` is scratch.
void reduce_row(ChannelReducer& reducer, Mix mix, ChannelRow<float> in, int y,
                ChannelRow<std::uint16_t> out, std::span<const float> strength, int x = 0);

/// The strength of a row's pixels: the mask's, times that of the whole; empty where the dither is
/// whole everywhere.
std::vector<float> row_strength(const Band& band, int row, float strength);

}  // namespace tristim::detail
