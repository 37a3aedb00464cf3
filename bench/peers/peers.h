#pragma once

#include <cstdint>
#include <functional>

#include "tristim/color/primaries.h"
#include "tristim/lut/lut.h"

/// What other libraries make of the same work, each behind functions that take no types of theirs.
/// All throw std::runtime_error where a library refuses.
namespace tristim::bench {

/// Linear light of three channels, through a matrix from `from` to sRGB's primaries, clipped,
/// through sRGB's curve, to 8 bits.
struct DisplayJob {
  int width, height;
  Primaries from;
};

/// All pixels of a picture, from the first sample of each.
using ToBytes = std::function<void(const float* in, std::uint8_t* out)>;

ToBytes ocio_to_bytes(const DisplayJob& job);
ToBytes oiio_to_bytes(const DisplayJob& job);
ToBytes lcms_to_bytes(const DisplayJob& job);

enum class ZimgDither { kNone, kOrdered, kErrorDiffusion };

/// Planes one after the other, in and out. `from` is one of BT.2020's and sRGB's. Curves are
/// approximate, which is zimg's fast way.
ToBytes zimg_to_bytes(const DisplayJob& job, ZimgDither dither);

/// One plane of encoded numbers to `bits` bits, with neither matrix nor curve.
ToBytes zimg_plane(int width, int height, int bits, ZimgDither dither);

/// Interleaved pixels of three floats to as many; `in` and `out` may be the same.
using FloatPixels = std::function<void(const float* in, float* out, int pixels)>;

FloatPixels ocio_cube(const Lut3D& cube, bool is_trilinear);
FloatPixels lcms_cube(const Lut3D& cube);

}  // namespace tristim::bench
