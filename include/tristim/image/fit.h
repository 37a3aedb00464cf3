#pragma once

#include <memory>
#include <string_view>

#include "tristim/color/rgb.h"
#include "tristim/image/picture.h"

namespace tristim {

/// How a picture comes into a frame of another shape.
enum class FitMode {
  kContain,
  kCover,
  kStretch,
  kNone,
};

struct NamedFitMode {
  std::string_view name;
  FitMode mode;
  std::string_view what;
};

inline constexpr NamedFitMode kFitModes[] = {
    {"contain", FitMode::kContain, "all of the picture, centred, background beside it"},
    {"cover", FitMode::kCover, "no background: what exceeds the frame is cropped, centred"},
    {"stretch", FitMode::kStretch, "all of the picture, its shape changed to the frame's"},
    {"none", FitMode::kNone, "not resampled: cropped or padded, centred"},
};

/// A separable resampling filter.
struct ResampleFilter {
  std::string_view name;
  std::string_view what;
  std::string_view source;
  int support = 0;  // half of its width in pixels of the coarser grid; 0 takes the nearest pixel
  int zimg_filter = 0;  // zimg_resample_filter_e
  double a = 0, b = 0;  // B and C of the cubics [Mitchell88]; a: lobes of lanczos
};

inline constexpr ResampleFilter kPointFilter{
    "point", "nearest pixel; for pixel art and index pictures", "", 0, 0, 0, 0};
inline constexpr ResampleFilter kBilinearFilter{"bilinear", "triangle: no halos, soft", "", 1, 1, 0,
                                                0};

/// The default. A filter that mixes light must not have negative lobes: beside a highlight of 100
/// times the white an edge goes down to -1.75 with mitchell, -4.2 with bicubic and -7.3 with
/// lanczos, which every display shows as a black ring. Of the filters without them hermite is the
/// sharpest: at half of the Nyquist frequency it keeps 85 % of the contrast, as mitchell does,
/// bilinear 81 %, a cubic B-spline 66 %. Four HDR photos and a chart of bright rings, enlarged 4
/// times from means of 4 x 4 pixels, came out nearer to the original than with bilinear and
/// mitchell, each of them.
inline constexpr ResampleFilter kHermiteFilter{
    "hermite",
    "cubic without negative lobes: no halos, as sharp as mitchell",
    "[Mitchell88], B = 0, C = 0",
    2,
    2,
    0,
    0};
inline constexpr ResampleFilter kMitchellFilter{
    "mitchell", "cubic, B = C = 1/3: faint halos", "[Mitchell88]", 2, 2, 1.0 / 3, 1.0 / 3};
inline constexpr ResampleFilter kBicubicFilter{
    "bicubic", "Catmull-Rom: sharp, halos", "[Keys81]", 2, 2, 0, 0.5};
inline constexpr ResampleFilter kSpline36Filter{
    "spline36", "sharper, strong halos", "[PanoTools]", 3, 4, 0, 0};
inline constexpr ResampleFilter kLanczosFilter{
    "lanczos", "sharpest, three lobes, strong halos", "[Duchon79]", 3, 5, 3, 0};

/// Every filter. The command line, the docs and the tests read this list.
inline constexpr ResampleFilter kFilters[] = {kHermiteFilter,  kPointFilter,   kBilinearFilter,
                                              kMitchellFilter, kBicubicFilter, kSpline36Filter,
                                              kLanczosFilter};

/// The longest side that fit() makes.
inline constexpr int kMaxFitSide = 1 << 20;

struct FitOptions {
  int width = 0;  // pixels of the result, 0: as the height and the picture's shape ask; both 0: its
                  // own size
  int height = 0;
  FitMode mode = FitMode::kContain;
  ResampleFilter filter = kHermiteFilter;
  Rgb background = {};  // light in the picture's own primaries
  int rotate_deg = 0;   // clockwise, after the picture is upright: 0, 90, 180 or 270
};

/// `source` at the asked size, upright, with square pixels; `source` itself where it is so already.
///
/// Its own size is width * pixel_aspect x height, turned by its EXIF orientation (what is not 1..8
/// counts as 1) and by `rotate_deg`. Sides are rounded half up and at least 1 pixel; an odd pixel
/// of crop or padding goes to the right or the bottom. Beyond its edges a picture is mirrored. A
/// flat grey stays within 2e-6 of itself, 2e-5 where it shrinks a thousand times.
///
/// The rows do not depend on how many are read at a time. They are the same bits on every x86-64
/// processor (zimg's portable code), but for lanczos, whose sine is the C library's; on other
/// architectures a compiler may have fused zimg's sums, and the last bits may differ.
///
/// Streams: memory is some rows of the source and of the result, but a quarter turn and a vertical
/// flip hold the smaller of picture and result, and enlarging a picture of N rows holds 3 / N of
/// the result. A picture that shrinks 32 times or more in height has groups of rows averaged first.
///
/// Throws std::invalid_argument for a negative or too large size (kMaxFitSide), a rotation by
/// anything else or an unknown mode. Throws Error (kContent) for a pixel aspect ratio that is not
/// positive and finite, and for what would need more than 4 GiB at once. read() passes on what the
/// source throws.
std::unique_ptr<RowSource> fit(std::unique_ptr<RowSource> source, const FitOptions& options);

}  // namespace tristim
