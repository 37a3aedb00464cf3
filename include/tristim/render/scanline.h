#pragma once

#include <span>
#include <vector>

#include "tristim/render/gouraud.h"
#include "tristim/render/raster.h"

namespace tristim {

/// One row of a shaded polygon, as a scanline rasterizer makes it [Shoaff 4.1, UBC].
struct ScanlineRow {
  PixelRun run = {};      // the centres that are inside
  GouraudSpan span = {};  // of the row's height; t and I_P are those of the first centre
  std::vector<double> intensity = {};  // of each pixel of the run, by increments
};

/// A convex polygon row by row: edges by u and w give Q and R, the span between them by t and its
/// increments the pixels. Which pixels those are is decided as parity_fill does, so polygons that
/// share an edge leave no gap and share no pixel. Rows without a centre inside are left out.
std::vector<ScanlineRow> scanline_fill(int width, int height,
                                       std::span<const GouraudVertex> polygon);

}  // namespace tristim
