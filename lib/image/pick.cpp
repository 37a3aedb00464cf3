#include "lib/image/pick.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace tristim::detail {
namespace {

constexpr int kBatch = 16;  // rows read at a time

class PickedColumns : public RowSource {
 public:
  PickedColumns(std::unique_ptr<RowSource> source, std::vector<int> columns)
      : source_(std::move(source)),
        info_(source_->info()),
        columns_(std::move(columns)),
        batch_(info_.width, std::min(kBatch, info_.height), info_.channels) {
    info_.width = static_cast<int>(columns_.size());
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height;) {
      const auto batch = batch_.view().rows(0, std::min(kBatch, rows.height - y));
      source_->read(batch);
      for (int i = 0; i < batch.height; ++i) {
        float* out = rows.row(y++).data();
        for (const int x : columns_) out = std::copy_n(batch.pixel(x, i), batch.channels, out);
      }
    }
  }

 private:
  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  std::vector<int> columns_;
  Image batch_;
};

class PickedRows : public RowSource {
 public:
  PickedRows(std::unique_ptr<RowSource> source, std::vector<int> rows)
      : source_(std::move(source)),
        info_(source_->info()),
        rows_(std::move(rows)),
        row_(info_.width, 1, info_.channels) {
    info_.height = static_cast<int>(rows_.size());
    info_.chunk_rows = 1;
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y) {
      for (const int wanted = rows_[next_++]; read_ <= wanted; ++read_) source_->read(row_.view());
      std::ranges::copy(row_.view().row(0), rows.row(y).begin());
    }
  }

 private:
  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  std::vector<int> rows_;
  Image row_;
  std::size_t next_ = 0;
  int read_ = 0;  // rows of the source so far; the last is in row_
};

class AveragedRows : public RowSource {
 public:
  AveragedRows(std::unique_ptr<RowSource> source, int count)
      : source_(std::move(source)),
        info_(source_->info()),
        row_(info_.width, 1, info_.channels),
        sums_(row_.view().row(0).size()) {
    info_.height = count;
    info_.chunk_rows = 1;
  }

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y) {
      const std::int64_t groups = info_.height;
      const std::int64_t end =  // rounded, so that the groups are alike from both ends
          (2 * ++next_ * source_->info().height + groups) / (2 * groups);
      const double count = static_cast<double>(end - read_);
      std::ranges::fill(sums_, 0.0);
      for (; read_ < end; ++read_) {
        source_->read(row_.view());
        const auto row = row_.view().row(0);
        for (std::size_t s = 0; s < sums_.size(); ++s) sums_[s] += double{row[s]};
      }
      const auto out = rows.row(y);
      for (std::size_t s = 0; s < sums_.size(); ++s) out[s] = static_cast<float>(sums_[s] / count);
    }
  }

 private:
  std::unique_ptr<RowSource> source_;
  PictureInfo info_;
  Image row_;
  std::vector<double> sums_;
  std::int64_t next_ = 0;  // group
  std::int64_t read_ = 0;  // rows of the source so far
};

}  // namespace

std::unique_ptr<RowSource> pick_columns(std::unique_ptr<RowSource> source,
                                        std::vector<int> columns) {
  return std::make_unique<PickedColumns>(std::move(source), std::move(columns));
}

std::unique_ptr<RowSource> pick_rows(std::unique_ptr<RowSource> source, std::vector<int> rows) {
  return std::make_unique<PickedRows>(std::move(source), std::move(rows));
}

std::unique_ptr<RowSource> average_rows(std::unique_ptr<RowSource> source, int count) {
  return std::make_unique<AveragedRows>(std::move(source), count);
}

}  // namespace tristim::detail
