#include "tristim/image/flatten.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace tristim {
namespace {

constexpr float kLargestHalf = 65504;
constexpr int kBatch = 16;  // rows read at a time, so that a codec delivers whole chunks

// Whether there is NaN or an infinity: their exponents are all ones. A loop without jumps.
bool has_odd_value(std::span<const float> row) noexcept {
  constexpr std::int32_t kMagnitude = 0x7fffffff;
  constexpr std::int32_t kInfinity = 0x7f800000;
  std::int32_t most = 0;
  for (const float sample : row) {
    most = std::max(most, std::bit_cast<std::int32_t>(sample) & kMagnitude);
  }
  return most >= kInfinity;
}

void replace_odd_values(std::span<float> row, OddValues& counts) noexcept {
  if (!has_odd_value(row)) return;
  for (float& sample : row) {
    if (std::isfinite(sample)) continue;
    if (std::isnan(sample)) {
      ++counts.nan;
      sample = 0;
    } else {
      ++counts.infinite;
      sample = std::copysign(kLargestHalf, sample);
    }
  }
}

class Flattened : public RowSource {
 public:
  Flattened(std::unique_ptr<RowSource> source, Rgb background, OddValues* counts)
      : source_(std::move(source)),
        info_(source_->info()),
        background_{static_cast<float>(background.r), static_cast<float>(background.g),
                    static_cast<float>(background.b)},
        counts_(counts != nullptr ? counts : &uncounted_) {
    if (info_.channels == 3) return;
    info_.channels = 3;
    info_.grey = info_.grey && background.r == background.g && background.g == background.b;
    with_alpha_ = Image(info_.width, std::min(kBatch, info_.height), 4);
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    if (source_->info().channels == 3) {
      source_->read(rows);
      for (int y = 0; y < rows.height; ++y) replace_odd_values(rows.row(y), *counts_);
      return;
    }
    for (int y = 0; y < rows.height;) {
      const int count = std::min(with_alpha_.view().height, rows.height - y);
      const auto batch = with_alpha_.view().rows(0, count);
      source_->read(batch);
      for (int i = 0; i < count; ++i) {
        replace_odd_values(batch.row(i), *counts_);
        over_background(batch.row(i).data(), rows.row(y++));
      }
    }
  }

 private:
  void over_background(const float* rgba, std::span<float> rgb) const noexcept {
    for (std::size_t i = 0; i < rgb.size(); i += 3, rgba += 4) {
      const float rest = 1 - std::clamp(rgba[3], 0.0F, 1.0F);
      for (std::size_t c = 0; c < 3; ++c) rgb[i + c] = rgba[c] + rest * background_[c];
    }
  }

  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  float background_[3];
  OddValues uncounted_;
  OddValues* counts_;
  Image with_alpha_;
};

}  // namespace

std::unique_ptr<RowSource> flatten(std::unique_ptr<RowSource> source, Rgb background,
                                   OddValues* counts) {
  return std::make_unique<Flattened>(std::move(source), background, counts);
}

}  // namespace tristim
