#include "lib/image/turn.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr Turn kOrientations[] = {{false, false, false}, {false, true, false}, {false, true, true},
                                  {false, false, true},  {true, false, false}, {true, false, true},
                                  {true, true, true},    {true, true, false}};

/// Left and right exchanged, row by row.
class FlippedColumns : public RowSource {
 public:
  explicit FlippedColumns(std::unique_ptr<RowSource> source) : source_(std::move(source)) {}

  const PictureInfo& info() const noexcept override { return source_->info(); }

  void read(ImageView<float> rows) override {
    source_->read(rows);
    for (int y = 0; y < rows.height; ++y) {
      for (int left = 0, right = rows.width - 1; left < right; ++left, --right) {
        std::swap_ranges(rows.pixel(left, y), rows.pixel(left, y) + rows.channels,
                         rows.pixel(right, y));
      }
    }
  }

 private:
  std::unique_ptr<RowSource> source_;
};

/// Any other turn: reads the whole picture when the first row is asked for.
class TurnedWhole : public RowSource {
 public:
  TurnedWhole(std::unique_ptr<RowSource> source, Turn how)
      : source_(std::move(source)), info_(source_->info()), how_(how) {
    if (how.transpose) std::swap(info_.width, info_.height);
    info_.chunk_rows = 1;
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    if (source_ != nullptr) {
      const PictureInfo& stored = source_->info();
      picture_ = Image(stored.width, stored.height, stored.channels);
      source_->read(picture_.view());
      source_.reset();
    }
    for (int y = 0; y < rows.height; ++y) copy_row(next_++, rows.row(y).data());
  }

 private:
  void copy_row(int y, float* out) const noexcept {
    const auto picture = picture_.view();
    for (int x = 0; x < info_.width; ++x, out += picture.channels) {
      int u = how_.transpose ? y : x;
      int v = how_.transpose ? x : y;
      if (how_.flip_x) u = picture.width - 1 - u;
      if (how_.flip_y) v = picture.height - 1 - v;
      std::copy_n(picture.pixel(u, v), picture.channels, out);
    }
  }

  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  Turn how_;
  Image picture_;
  int next_ = 0;
};

}  // namespace

Turn turn_from_orientation(int orientation) noexcept {
  return orientation >= 1 && orientation <= 8 ? kOrientations[orientation - 1] : Turn{};
}

Turn turn_from_degrees(int clockwise_deg) {
  switch (clockwise_deg) {
    case 0:
      return {};
    case 90:
      return {.transpose = true, .flip_y = true};
    case 180:
      return {.flip_x = true, .flip_y = true};
    case 270:
      return {.transpose = true, .flip_x = true};
    default:
      throw std::invalid_argument("fit: rotation by " + std::to_string(clockwise_deg) +
                                  " degrees, expected 0, 90, 180 or 270");
  }
}

Turn combine(Turn a, Turn b) noexcept {
  return {a.transpose != b.transpose, a.flip_x != (a.transpose ? b.flip_y : b.flip_x),
          a.flip_y != (a.transpose ? b.flip_x : b.flip_y)};
}

std::unique_ptr<RowSource> turn(std::unique_ptr<RowSource> source, Turn how) {
  if (how == Turn{}) return source;
  if (how == Turn{.flip_x = true}) return std::make_unique<FlippedColumns>(std::move(source));
  const PictureInfo& info = source->info();
  const double bytes = 4.0 * info.width * info.height * info.channels;
  if (bytes > kMaxHeldBytes) {
    throw Error(ErrorKind::kContent, info.name,
                "a picture of " + std::to_string(info.width) + "x" + std::to_string(info.height) +
                    " is too large to be turned in memory",
                "ask for a smaller size or turn the file beforehand");
  }
  return std::make_unique<TurnedWhole>(std::move(source), how);
}

}  // namespace tristim::detail
