#include "tristim/image/repeat.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace tristim {
namespace {

class RepeatedPixels : public RowSource {
 public:
  RepeatedPixels(std::unique_ptr<RowSource> source, int across, int down)
      : source_(std::move(source)),
        info_(source_->info()),
        across_(across),
        down_(down),
        row_(info_.width, 1, info_.channels),
        left_(0) {
    info_.width *= across;
    info_.height *= down;
    info_.chunk_rows = down;
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y) {
      if (left_ == 0) {
        source_->read(row_.view());
        left_ = down_;
      }
      --left_;
      const ImageView<const float> from = row_.view();
      float* to = rows.row(y).data();
      for (int x = 0; x < from.width; ++x) {
        for (int i = 0; i < across_; ++i) {
          to = std::copy_n(from.pixel(x, 0), from.channels, to);
        }
      }
    }
  }

 private:
  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  int across_, down_;
  Image row_;  // the source's row at hand
  int left_;   // how often it is still wanted
};

}  // namespace

std::unique_ptr<RowSource> repeat_pixels(std::unique_ptr<RowSource> source, int across, int down) {
  if (across == 1 && down == 1) return source;
  const PictureInfo& info = source->info();
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  if (across < 1 || down < 1 || std::int64_t{info.width} * across > kMost ||
      std::int64_t{info.height} * down > kMost) {
    throw std::invalid_argument("pixels repeated " + std::to_string(across) + " x " +
                                std::to_string(down) + ": expected 1 or more, and a result below " +
                                std::to_string(kMost) + " a side");
  }
  return std::make_unique<RepeatedPixels>(std::move(source), across, down);
}

}  // namespace tristim
