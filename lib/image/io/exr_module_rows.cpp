#include "lib/image/io/exr_module_rows.h"

#include <algorithm>
#include <utility>

#include "lib/image/io/module.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

class ExrModuleRows final : public RowSource {
 public:
  ExrModuleRows(InputFilePtr file, std::unique_ptr<NativeRows> rows, const ExrPart& part,
                const ExrColour& colour, PictureInfo info)
      : file_(std::move(file)),
        rows_(std::move(rows)),
        part_(part),
        colour_(colour),
        info_(std::move(info)) {}

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    const PixelWindow seen = visible(part_.data, part_.display);
    for (int y = 0; y < rows.height; ++y, ++next_) {
      std::ranges::fill(rows.row(y), 0.0F);
      const bool inside = next_ >= seen.y && next_ < seen.y + seen.height;
      if (seen.width > 0 && inside) copy_row(seen, rows.rows(y, 1));
    }
  }

 private:
  void copy_row(const PixelWindow& seen, ImageView<float> row) {
    const float* in = data_row(part_.display.y + next_ - part_.data.y) +
                      4 * (part_.display.x + seen.x - part_.data.x);
    const auto width = static_cast<int>(seen.width);
    float* out = row.pixel(static_cast<int>(seen.x), 0);
    for (std::ptrdiff_t i = 0; i < width; ++i) {
      std::copy_n(in + 4 * i, info_.channels, out + info_.channels * i);
    }
    if (colour_.delivered) convert_pixels(*colour_.delivered, width, info_.channels, out);
  }

  // A row of the data window: four floats a pixel. Whole chunks are held, as the file has them.
  const float* data_row(std::int64_t row) {
    const auto row_floats = static_cast<std::size_t>(part_.data.width) * 4;
    const std::int64_t first = row / part_.chunk_rows * part_.chunk_rows;
    if (held_first_ != first) {
      const std::int64_t count =
          std::min<std::int64_t>(part_.chunk_rows, part_.data.height - first);
      held_.resize(row_floats * static_cast<std::size_t>(count));
      held_first_ = -1;
      rows_->read(static_cast<int>(first), static_cast<int>(count),
                  std::as_writable_bytes(std::span(held_)));
      held_first_ = first;
    }
    return held_.data() + row_floats * static_cast<std::size_t>(row - first);
  }

  InputFilePtr file_;  // open as long as the module reads from it
  std::unique_ptr<NativeRows> rows_;
  ExrPart part_;
  ExrColour colour_;
  PictureInfo info_;
  std::vector<float> held_;
  std::int64_t held_first_ = -1;
  int next_ = 0;
};

}  // namespace

bool needs_exr_module(const ExrPart& part, const ExrSelection& selection) {
  return selection.model == ExrColourModel::kChroma || part.compression.starts_with("dwa");
}

std::unique_ptr<RowSource> open_exr_module_rows(InputFilePtr file, const ExrPart& part,
                                                const ExrSelection& selection,
                                                const ExrColour& colour, const PictureInfo& info) {
  ExrRowsRequest request{
      .path = file->reopen_path(), .name = file->name(), .part = part.index, .data = part.data};
  request.chroma = selection.model == ExrColourModel::kChroma;
  if (request.chroma && (part.index != 0 || !selection.layer.empty())) {
    throw Error(ErrorKind::kContent, file->name(),
                "has luminance and chroma in a layer or a further part",
                "write it with channels R G B");
  }
  for (std::size_t slot = 0; slot < 4; ++slot) {
    const int channel = selection.channel[slot];
    if (channel >= 0)
      request.channels[slot] = part.channels[static_cast<std::size_t>(channel)].name;
  }
  auto* open = reinterpret_cast<OpenExrRows*>(load_function(kOpenExrModule));
  std::unique_ptr<NativeRows> rows;
  open(request, rows);
  return std::make_unique<ExrModuleRows>(std::move(file), std::move(rows), part, colour, info);
}

}  // namespace tristim::detail
