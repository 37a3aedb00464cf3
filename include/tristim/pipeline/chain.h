#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tristim/image/flatten.h"
#include "tristim/palette/palette.h"
#include "tristim/pipeline/run.h"
#include "tristim/pipeline/settings.h"

namespace tristim {

/// A picture made ready for the stages: odd values and alpha gone, upright, at the size that the
/// settings or the device's panel ask for. `counts` (may be null) must outlive the result. Throws
/// as fit() does.
std::unique_ptr<RowSource> prepare(std::unique_ptr<RowSource> picture, const Display& display,
                                   const Settings& settings, OddValues* counts);

/// The stages between a prepared picture and the reducer: exposure, tone map, primaries, gamut map.
struct StageList {
  std::vector<Stage> stages;
  int scene_stages =
      0;  // how many of them change the picture whatever the device: exposure and tone map
};
StageList stage_list(const PictureInfo& picture, const Display& display, const Settings& settings);

/// `asked`, with what it leaves open taken from the device: resolution, ruling, the angles of a
/// press.
ScreenParameters screen_parameters(const Display& display, const ScreenParameters& asked);

/// What the reducer needs of the settings. The metric and the rest of `settings` outlive nothing:
/// they are copied.
ReduceOptions reduce_options(const Display& display, const Settings& settings);

/// What counts for a palette beside the pixels themselves. Sources have the picture's size.
struct CountOptions {
  PaletteWeights weights = PaletteWeights::kCount;
  RowSource* mask = nullptr;      // how much a pixel counts, by the first channel, 0 .. 1, clipped
  RowSource* coverage = nullptr;  // alpha as the first channel; null: all is opaque
  AlphaMode alpha = AlphaMode::kOver;  // what becomes of pixels that are not quite covered
};

/// Counts the colours of a prepared picture as the device will be asked for them: after all stages,
/// at 8 bits of the sRGB curve a channel, in the device's primaries; by contrast as
/// contrast_weights() weighs them, with a mask each pixel up to 255 times.
Histogram histogram(RowSource& picture, const StageList& stages, const Display& display,
                    const RunOptions& options, const CountOptions& counting = {});

/// `display` with a palette of codes of 8 bits a channel behind the sRGB curve in its primaries, at
/// positions 0, 1, ...
Display with_palette(Display display, const std::vector<Color8>& palette);

/// `display` with the colours of a palette, which are sRGB, and its codes; those without one have
/// their positions.
Display with_palette(Display display, const Palette& palette);

/// The number of colours that a palette chosen for a picture may have on `display`. Throws Error
/// (kMisuse) where its packing is not indexed or `choice` asks for more than it holds.
int palette_colors(const Display& display, const PaletteChoice& choice);

}  // namespace tristim
