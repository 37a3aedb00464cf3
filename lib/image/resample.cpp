#include "lib/image/resample.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "lib/image/pick.h"
#include "lib/image/plane.h"
#include "lib/image/turn.h"
#include "tristim/core/error.h"

// zimg works on whole planes: driven by callbacks over a picture wider than the cache it takes
// columns in strips and asks for the first row again at each. So each axis is a step of its own
// that hands zimg planes complete in memory: one row at a time across, and overlapping windows of
// rows down. Each plane has mirrored pixels around it, as many as the filter reaches; so zimg's
// demand for more pixels than the filter is wide holds for every picture, down to one pixel.

namespace tristim::detail {
namespace {

constexpr int kBatch = 16;           // rows read at a time
constexpr double kWindowRows = 128;  // source rows that a window aims to move on by
// Rows that shrink by more than kAverageAbove are averaged first, so that at least kAverageLeaves
// are left to the filter and a window stays small; the average takes off .2 % at the result's
// Nyquist frequency at most.
constexpr double kAverageAbove = 32;
constexpr double kAverageLeaves = 16;

/// The pixel that stands at position `i` of an axis of `n` pixels that goes on mirrored at both
/// ends.
int mirrored(std::int64_t i, int n) noexcept {
  const std::int64_t period = 2 * std::int64_t{n};
  i = ((i % period) + period) % period;
  return static_cast<int>(i < n ? i : period - 1 - i);
}

/// Pixels that the filter reads beyond the centre of a result, and one for rounding.
std::int64_t reach(Span span, const ResampleFilter& filter) noexcept {
  return static_cast<std::int64_t>(std::ceil(filter.support * std::max(1.0, span.step()))) + 1;
}

/// The fewest results that zimg makes at a time: their span must be wider than half of the filter.
double least_count(Span span, const ResampleFilter& filter) noexcept {
  return std::floor(filter.support * std::max(1.0, 1 / span.step())) + 2;
}

/// The source pixels of `count` results.
double length_of(Span span, int count) noexcept {
  return count == span.count ? span.length : count * span.step();
}

/// For each result the pixel of the source that it copies: crops, and the nearest of several.
std::vector<int> picks(Span span, int n) {
  std::vector<int> indices(static_cast<std::size_t>(span.count));
  for (int i = 0; i < span.count; ++i) {
    const double nearest = std::floor(span.start + (i + 0.5) * span.step());
    indices[static_cast<std::size_t>(i)] = static_cast<int>(std::clamp(nearest, 0.0, n - 1.0));
  }
  return indices;
}

class ResampledColumns : public RowSource {
 public:
  ResampledColumns(std::unique_ptr<RowSource> source, Span span, const ResampleFilter& filter)
      : source_(std::move(source)),
        info_(source_->info()),
        columns_(mirrored_columns(span, filter, info_.width)),
        resizer_(PlaneResizer::Along::kColumns,
                 {std::ssize(columns_),
                  span.start - std::floor(span.start) + static_cast<double>(reach(span, filter)),
                  length_of(span, padded_count(span, filter)), padded_count(span, filter)},
                 static_cast<std::size_t>(info_.channels), filter, info_.name),
        batch_(info_.width, std::min(kBatch, info_.height), info_.channels),
        in_(columns_.size()),
        out_(static_cast<std::size_t>(padded_count(span, filter))) {
    info_.width = span.count;
    in_.resize(static_cast<std::size_t>(info_.channels));
    out_.resize(static_cast<std::size_t>(info_.channels));
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height;) {
      const auto batch = batch_.view().rows(0, std::min(kBatch, rows.height - y));
      source_->read(batch);
      for (int i = 0; i < batch.height; ++i) resample_row(batch.row(i), rows.row(y++));
    }
  }

 private:
  static int padded_count(Span span, const ResampleFilter& filter) noexcept {
    return std::max(span.count, static_cast<int>(least_count(span, filter)));
  }

  static std::vector<int> mirrored_columns(Span span, const ResampleFilter& filter, int width) {
    const auto first = static_cast<std::int64_t>(std::floor(span.start)) - reach(span, filter);
    const auto last = static_cast<std::int64_t>(
                          std::ceil(span.start + length_of(span, padded_count(span, filter)))) +
                      reach(span, filter);
    std::vector<int> columns;
    columns.reserve(static_cast<std::size_t>(last - first));
    for (std::int64_t x = first; x < last; ++x) columns.push_back(mirrored(x, width));
    return columns;
  }

  void resample_row(std::span<const float> from, std::span<float> to) {
    const auto channels = static_cast<std::size_t>(info_.channels);
    for (std::size_t c = 0; c < channels; ++c) {
      float* plane = in_.row(c);
      for (const int x : columns_) *plane++ = from[static_cast<std::size_t>(x) * channels + c];
    }
    resizer_.run(in_, out_);
    for (std::size_t c = 0; c < channels; ++c) {
      const float* plane = out_.row(c);
      for (std::size_t i = c; i < to.size(); i += channels) to[i] = *plane++;
    }
  }

  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  std::vector<int> columns_;  // of the source, for each column of in_
  PlaneResizer resizer_;
  Image batch_;
  Plane in_, out_;  // a row for each channel
};

class ResampledRows : public RowSource {
 public:
  ResampledRows(std::unique_ptr<RowSource> source, Span span, const ResampleFilter& filter)
      : source_(std::move(source)),
        info_(source_->info()),
        span_(span),
        filter_(filter),
        samples_(static_cast<std::size_t>(info_.width) * static_cast<std::size_t>(info_.channels)),
        window_(samples_),
        block_(samples_) {
    const double step = span.step();
    const double aimed = std::min<double>(kBatch, kWindowRows / step);
    const double count = std::max(aimed, least_count(span, filter));
    const double rows = count * (1 + step) + 2.0 * static_cast<double>(reach(span, filter));
    if (rows * static_cast<double>(samples_) * sizeof(float) > kMaxHeldBytes) {
      throw Error(ErrorKind::kContent, info_.name,
                  std::to_string(info_.height) + " rows cannot be resampled to " +
                      std::to_string(span.count) + " in memory",
                  "ask for a smaller size or use the filter point");
    }
    block_count_ = static_cast<int>(count);
    block_.resize(static_cast<std::size_t>(block_count_));
    info_.height = span.count;
    info_.chunk_rows = std::min(block_count_, span.count);
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      if (next_ == block_end_) next_block();
      std::copy_n(block_.row(static_cast<std::size_t>(next_ - block_start_)), samples_,
                  rows.row(y).data());
    }
  }

 private:
  // Blocks have one height, since zimg makes no fewer rows at a time: the last one overlaps the one
  // before it, and the only one of a small result exceeds it. They depend on the sizes alone, not
  // on what is asked for.
  void next_block() {
    const int last_start = std::max(0, span_.count - block_count_);
    const int start = std::min(next_, last_start);
    const double first = span_.start + start * span_.step();
    const double length = length_of(span_, block_count_);
    const std::int64_t margin = reach(span_, filter_);
    const int height = source_->info().height;
    std::int64_t top = static_cast<std::int64_t>(std::floor(first)) - margin;
    const auto bottom = static_cast<std::int64_t>(std::ceil(first + length)) + margin;
    if (bottom > height) {  // what is mirrored at the end must be in the window, too
      top = std::min(top, std::max(std::int64_t{0}, 2 * std::int64_t{height} - bottom));
    }
    move_window(top, bottom);
    PlaneResizer(PlaneResizer::Along::kRows,
                 {bottom - top, first - static_cast<double>(top), length, block_count_}, samples_,
                 filter_, info_.name)
        .run(window_, block_);
    block_start_ = start;
    block_end_ = std::min(start + block_count_, span_.count);
  }

  /// Makes the window hold the rows [top, bottom) of the mirrored source; neither ever goes back.
  void move_window(std::int64_t top, std::int64_t bottom) {
    const int height = source_->info().height;
    if (read_ == 0) {
      window_top_ = window_bottom_ = top;
      window_.resize(1);
      for (; read_ < top; ++read_) read_source(0, 1);
    }
    window_.drop(static_cast<std::size_t>(top - window_top_));
    window_top_ = top;
    window_.resize(static_cast<std::size_t>(bottom - top));

    const std::int64_t first = std::max<std::int64_t>(window_bottom_, 0);
    const std::int64_t last = std::min<std::int64_t>(bottom, height);
    if (last > first) {
      read_source(static_cast<std::size_t>(first - top), static_cast<int>(last - first));
      read_ = static_cast<int>(last);
    }
    for (std::int64_t y = window_bottom_; y < bottom; ++y) {
      if (y >= 0 && y < height) continue;
      std::copy_n(window_.row(static_cast<std::size_t>(mirrored(y, height) - top)), samples_,
                  window_.row(static_cast<std::size_t>(y - top)));
    }
    window_bottom_ = bottom;
  }

  void read_source(std::size_t row, int count) {
    source_->read({window_.row(row), info_.width, count, info_.channels, window_.stride()});
  }

  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  Span span_;
  ResampleFilter filter_;
  std::size_t samples_;  // of a row
  Plane window_;         // of the source
  std::int64_t window_top_ = 0, window_bottom_ = 0;
  int read_ = 0;         // rows of the source so far
  Plane block_;          // of the result
  int block_count_ = 0;  // its rows
  int block_start_ = 0, block_end_ = 0;
  int next_ = 0;
};

std::unique_ptr<RowSource> resample_columns(std::unique_ptr<RowSource> source, Span span,
                                            const ResampleFilter& filter) {
  const int width = source->info().width;
  if (span.copies() && span.count == width) return source;
  if (span.copies() || filter.support == 0 || width == 1) {
    return pick_columns(std::move(source), picks(span, width));
  }
  return std::make_unique<ResampledColumns>(std::move(source), span, filter);
}

std::unique_ptr<RowSource> resample_rows(std::unique_ptr<RowSource> source, Span span,
                                         const ResampleFilter& filter) {
  const int height = source->info().height;
  if (span.copies() && span.count == height) return source;
  if (span.copies() || filter.support == 0 || height == 1) {
    return pick_rows(std::move(source), picks(span, height));
  }
  return std::make_unique<ResampledRows>(std::move(source), span, filter);
}

}  // namespace

std::unique_ptr<RowSource> resample(std::unique_ptr<RowSource> source, Span columns, Span rows,
                                    const ResampleFilter& filter) {
  if (rows.step() >= kAverageAbove && filter.support > 0) {
    const int height = source->info().height;
    const int group = static_cast<int>(rows.step() / kAverageLeaves);
    const int count = (height + group - 1) / group;
    const double scale = static_cast<double>(count) / height;
    source = average_rows(std::move(source), count);
    rows = {rows.start * scale, rows.length == height ? count : rows.length * scale, rows.count};
  }
  // First the step that leaves fewer samples for the other.
  if (columns.step() >= 1) {
    return resample_rows(resample_columns(std::move(source), columns, filter), rows, filter);
  }
  return resample_columns(resample_rows(std::move(source), rows, filter), columns, filter);
}

}  // namespace tristim::detail
