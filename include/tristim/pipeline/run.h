#pragma once

#include <cstdint>
#include <span>

#include "tristim/frame/code.h"
#include "tristim/image/picture.h"
#include "tristim/pipeline/reduce.h"
#include "tristim/pipeline/stage.h"

namespace tristim {

/// Sees every band once, in order, after it has been reduced: proofs, measurements, other formats.
class BandObserver {
 public:
  virtual ~BandObserver() = default;

  /// How many of the stages come before the light that the observer wants to see; -1: it wants
  /// none.
  virtual int light_after() const noexcept = 0;

  /// `light` is the band after those stages (empty where none was wanted), `codes` what it became.
  virtual void seen(ImageView<const float> light, ImageView<const std::uint16_t> codes) = 0;
};

struct RunOptions {
  int threads = 0;                   // 0: one for each processor
  int band_rows = 0;                 // 0: chosen from the width and the picture's chunks
  RowSource* dither_mask = nullptr;  // strength of the dither by its first channel, 0 .. 1,
                                     // clipped; of the picture's size
};

/// Drives a picture in bands from `source` (3 channels) through the stages and the reducer to the
/// sink, whose finish() is left to the caller. Bands are read, worked on and written at the same
/// time. The codes do not depend on `options`.
///
/// Memory is a few bands, whatever the picture's height; the whole picture where the reducer needs
/// that. Returns what the stages counted. Throws what source, observers and sink throw; the first
/// failure ends all.
StageCounts run(RowSource& source, std::span<const Stage> stages, Reducer& reducer, CodeSink& sink,
                std::span<BandObserver* const> observers = {}, const RunOptions& options = {});

/// The rows of a band for a picture, a multiple of its chunks where that stays below a few
/// megabytes. Those that go `in_order`, through error diffusion, are of many rows; others stay in a
/// processor's own cache.
int band_rows(const PictureInfo& info, bool in_order) noexcept;

}  // namespace tristim
