#include "tristim/image/fit.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>

#include "lib/image/resample.h"
#include "lib/image/turn.h"
#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

using detail::Span;
using detail::Turn;

/// One axis of a picture.
struct Side {
  int pixels = 0;     // of the source
  double extent = 0;  // their length in square pixels
};

/// What of a side of the picture comes where on the same side of the frame.
struct Placement {
  Span span;
  int offset = 0;
  int size = 0;
};

int whole_pixels(double length, int largest) noexcept {
  return static_cast<int>(std::clamp(std::floor(length + 0.5), 1.0, double(largest)));
}

Placement centred(Span span, int size) noexcept { return {span, (size - span.count) / 2, size}; }

Placement whole(Side side, int count, int size) noexcept {
  return centred({0, double(side.pixels), count}, size);
}

Placement covering(Side side, double scale, int size) noexcept {
  const double pixels = side.pixels;
  if (scale == size / side.extent) return whole(side, size, size);
  const double length = std::min(pixels, size / scale * (pixels / side.extent));
  return {{(pixels - length) / 2, length, size}, 0, size};
}

Placement unscaled(Side side, int size) noexcept {
  const int own = whole_pixels(side.extent, kMaxFitSide);
  const int count = std::min(own, size);
  const double ratio = side.pixels / double(own);
  const int cropped = (own - count) / 2;
  return centred({cropped * ratio, count * ratio, count}, size);
}

struct Placements {
  Placement x, y;
};

Placements place(Side x, Side y, int width, int height, FitMode mode) {
  const double scale_x = width / x.extent;
  const double scale_y = height / y.extent;
  switch (mode) {
    case FitMode::kContain:
      if (scale_x <= scale_y) {
        return {whole(x, width, width), whole(y, whole_pixels(y.extent * scale_x, height), height)};
      }
      return {whole(x, whole_pixels(x.extent * scale_y, width), width), whole(y, height, height)};
    case FitMode::kCover: {
      const double scale = std::max(scale_x, scale_y);
      return {covering(x, scale, width), covering(y, scale, height)};
    }
    case FitMode::kStretch:
      return {whole(x, width, width), whole(y, height, height)};
    case FitMode::kNone:
      return {unscaled(x, width), unscaled(y, height)};
  }
  throw std::invalid_argument("fit: mode " + std::to_string(static_cast<int>(mode)) +
                              ", expected one of kFitModes");
}

/// The source within a frame of background; the last step, whose info is that of the result.
class Framed : public RowSource {
 public:
  Framed(std::unique_ptr<RowSource> source, const Placement& x, const Placement& y, Rgb background)
      : source_(std::move(source)), info_(source_->info()), left_(x.offset), top_(y.offset) {
    info_.width = x.size;
    info_.height = y.size;
    info_.pixel_aspect = 1;
    info_.orientation = 1;
    const bool padded = x.size != x.span.count || y.size != y.span.count;
    const bool neutral = background.r == background.g && background.g == background.b;
    info_.grey = info_.grey && (!padded || neutral);
    const float pixel[] = {static_cast<float>(background.r), static_cast<float>(background.g),
                           static_cast<float>(background.b), 1};
    std::ranges::copy(pixel, background_);
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    const PictureInfo& inner = source_->info();
    const int first = std::clamp(top_ - next_, 0, rows.height);
    const int last = std::clamp(top_ + inner.height - next_, first, rows.height);
    const int right = left_ + inner.width;
    fill(rows, 0, first, 0, rows.width);
    if (last > first) {
      source_->read(
          {rows.pixel(left_, first), inner.width, last - first, rows.channels, rows.stride});
    }
    fill(rows, first, last, 0, left_);
    fill(rows, first, last, right, rows.width);
    fill(rows, last, rows.height, 0, rows.width);
    next_ += rows.height;
  }

 private:
  void fill(ImageView<float> rows, int top, int bottom, int left, int right) const noexcept {
    for (int y = top; y < bottom; ++y) {
      for (int x = left; x < right; ++x) {
        std::copy_n(background_, rows.channels, rows.pixel(x, y));
      }
    }
  }

  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  int left_, top_;
  float background_[4];
  int next_ = 0;
};

void check_options(const FitOptions& options) {
  for (const int side : {options.width, options.height}) {
    if (side >= 0 && side <= kMaxFitSide) continue;
    throw std::invalid_argument("fit: a side of " + std::to_string(side) + " pixels, expected 0.." +
                                std::to_string(kMaxFitSide));
  }
}

void check_picture(const PictureInfo& info) {
  if (info.pixel_aspect > 0 && std::isfinite(info.pixel_aspect)) return;
  throw Error(
      ErrorKind::kContent, info.name,
      "its pixel aspect ratio of " + shortest(info.pixel_aspect) + " is not positive and finite",
      "set it to 1 in the file");
}

/// The side that was not asked for, from the one that was and the picture's shape.
int missing_side(double length, const std::string& name) {
  if (length < kMaxFitSide) return whole_pixels(length, kMaxFitSide);
  throw Error(ErrorKind::kContent, name,
              "its shape makes a side longer than " + std::to_string(kMaxFitSide) + " pixels",
              "give both sides of the size");
}

/// The span of an axis that is counted from its other end.
Span flipped(Span span, int pixels, bool flip) noexcept {
  if (flip) span.start = pixels - span.start - span.length;
  return span;
}

/// Resamples before the turn where that leaves less to hold, after it otherwise.
std::unique_ptr<RowSource> resample_and_turn(std::unique_ptr<RowSource> source, Turn how,
                                             const Span& x, const Span& y,
                                             const ResampleFilter& filter) {
  const PictureInfo& info = source->info();
  if (double(x.count) * y.count > double(info.width) * info.height) {
    return detail::resample(detail::turn(std::move(source), how), x, y, filter);
  }
  const Span columns = flipped(how.transpose ? y : x, info.width, how.flip_x);
  const Span rows = flipped(how.transpose ? x : y, info.height, how.flip_y);
  return detail::turn(detail::resample(std::move(source), columns, rows, filter), how);
}

}  // namespace

std::unique_ptr<RowSource> fit(std::unique_ptr<RowSource> source, const FitOptions& options) {
  const PictureInfo& info = source->info();
  check_options(options);
  const Turn how = combine(detail::turn_from_orientation(info.orientation),
                           detail::turn_from_degrees(options.rotate_deg));
  check_picture(info);

  Side x{info.width, info.width * info.pixel_aspect};
  Side y{info.height, double(info.height)};
  if (how.transpose) std::swap(x, y);
  int width = options.width;
  int height = options.height;
  FitMode mode = options.mode;
  if (width == 0 && height == 0) {
    width = missing_side(x.extent, info.name);
    height = missing_side(y.extent, info.name);
    mode = FitMode::kNone;
  }
  if (width == 0) width = missing_side(x.extent * height / y.extent, info.name);
  if (height == 0) height = missing_side(y.extent * width / x.extent, info.name);
  const Placements placed = place(x, y, width, height, mode);

  const bool whole_x =
      placed.x.span.copies() && placed.x.span.count == x.pixels && width == x.pixels;
  const bool whole_y =
      placed.y.span.copies() && placed.y.span.count == y.pixels && height == y.pixels;
  const bool upright = how == Turn{} && info.orientation == 1 && info.pixel_aspect == 1;
  if (whole_x && whole_y && upright) return source;

  source = resample_and_turn(std::move(source), how, placed.x.span, placed.y.span, options.filter);
  return std::make_unique<Framed>(std::move(source), placed.x, placed.y, options.background);
}

}  // namespace tristim
