#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "lib/image/io/png_input.h"
#include "lib/image/io/readers.h"
#include "lib/image/io/sample_decoder.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

class PngRows final : public RowSource {
 public:
  PngRows(std::unique_ptr<PngInput> png, const SampleLayout& layout, PictureInfo info)
      : png_(std::move(png)),
        decoder_(layout),
        info_(std::move(info)),
        row_bytes_(static_cast<std::size_t>(info_.width) * decoder_.pixel_bytes()) {}

  const PictureInfo& info() const noexcept override { return info_; }

  void read(ImageView<float> rows) override {
    for (int y = 0; y < rows.height; ++y, ++next_) {
      decoder_.decode(png_->interlaced() ? interlaced_row() : next_row(), rows.row(y));
    }
  }

 private:
  std::span<const std::byte> next_row() {
    held_.resize(row_bytes_);
    auto* row = reinterpret_cast<png_bytep>(held_.data());
    if (!png_->read_rows(&row, 1)) damaged(next_);
    return held_;
  }

  std::span<const std::byte> interlaced_row() {
    if (held_.empty()) {
      held_.resize(row_bytes_ * static_cast<std::size_t>(info_.height));
      std::vector<png_bytep> rows;
      rows.reserve(static_cast<std::size_t>(info_.height));
      for (int y = 0; y < info_.height; ++y) {
        rows.push_back(
            reinterpret_cast<png_bytep>(held_.data() + row_bytes_ * static_cast<std::size_t>(y)));
      }
      if (!png_->read_rows(rows.data(), info_.height)) damaged(0);
    }
    return std::span(held_).subspan(row_bytes_ * static_cast<std::size_t>(next_), row_bytes_);
  }

  [[noreturn]] void damaged(int row) const {
    throw Error(ErrorKind::kContent, info_.name,
                "is damaged or cut off at row " + std::to_string(row) + ": " + png_->message(),
                "write or copy it again");
  }

  std::unique_ptr<PngInput> png_;
  SampleDecoder decoder_;
  PictureInfo info_;
  std::size_t row_bytes_;
  std::vector<std::byte> held_;  // a row, or all rows of an interlaced file
  int next_ = 0;
};

std::vector<std::string> channel_names(const PngInput& png) {
  const std::string type = ":" + std::to_string(png.stored_depth()) + "-bit";
  if (png.stored_type() == PNG_COLOR_TYPE_PALETTE) return {"index" + type};
  std::vector<std::string> names = (png.stored_type() & PNG_COLOR_MASK_COLOR) != 0
                                       ? std::vector<std::string>{"R", "G", "B"}
                                       : std::vector<std::string>{"Y"};
  if ((png.stored_type() & PNG_COLOR_MASK_ALPHA) != 0) names.emplace_back("A");
  for (std::string& name : names) name += type;
  return names;
}

// Where `layer` names one channel, that one; nothing where the file has none of that name.
std::optional<std::array<int, 4>> choose_samples(const PngInput& png, const std::string& layer) {
  const int samples = png.samples();
  const bool grey = samples < 3;
  const bool alpha = samples == 2 || samples == 4;
  if (layer.empty()) {
    if (grey) return std::array{0, 0, 0, alpha ? 1 : -1};
    return std::array{0, 1, 2, alpha ? 3 : -1};
  }
  const std::string_view names = grey ? "YA" : "RGBA";
  const std::size_t found = layer.size() == 1 ? names.find(layer) : std::string_view::npos;
  if (found >= static_cast<std::size_t>(samples)) return {};
  const int one = static_cast<int>(found);
  return std::array{one, one, one, -1};
}

PictureFacts facts_of(const PngInput& png, const SampleLayout& layout) {
  PictureFacts facts;
  facts.format = "png";
  facts.compression = "zip";
  facts.colour = png.colour().words;
  facts.channels = channel_names(png);
  facts.data_width = static_cast<int>(png.width());
  facts.data_height = static_cast<int>(png.height());
  PictureInfo& info = facts.info;
  info.name = png.file().name();
  info.width = static_cast<int>(png.width());
  info.height = static_cast<int>(png.height());
  info.channels = layout.source[3] >= 0 ? 4 : 3;
  info.grey = layout.source[0] == layout.source[1];
  info.primaries = png.colour().primaries;
  info.pixel_aspect = png.pixel_aspect();
  info.orientation = png.orientation();
  return facts;
}

void check_png(const PngInput& png) {
  const std::string& name = png.file().name();
  check_picture_size(name, png.width(), png.height());
  const std::uint64_t bytes = std::uint64_t{png.width()} * png.height() *
                              static_cast<std::uint64_t>(png.samples() * png.depth() / 8);
  if (png.interlaced() && bytes > kMaxHeldBytes) {
    throw Error(ErrorKind::kContent, name,
                "is too large for an interlaced file, which has to be held whole",
                "write it without interlacing");
  }
  if (!png.colour().refusal.empty()) {
    throw Error(ErrorKind::kContent, name, png.colour().refusal,
                "convert it to sRGB, BT.709, BT.2020 or P3 D65 with a simple curve");
  }
  check_primaries(name, png.colour().primaries);
}

}  // namespace

OpenedPicture open_png(InputFilePtr file, const ReadOptions& options) {
  auto png = std::make_unique<PngInput>(std::move(file));
  if (!png->read_header()) {
    throw Error(ErrorKind::kContent, png->file().name(),
                std::string("its PNG header is damaged or cut off: ") + png->message(),
                "write or copy it again");
  }
  check_png(*png);
  SampleLayout layout{.type = png->depth() == 16 ? SampleType::kUint16 : SampleType::kUint8,
                      .samples = png->samples(),
                      .alpha = AlphaKind::kStraight,
                      .curve = options.codes ? kNoCurve : png->colour().curve};
  const std::optional<std::array<int, 4>> source = choose_samples(*png, options.layer);
  if (source) layout.source = *source;
  OpenedPicture opened;
  opened.facts = facts_of(*png, layout);
  if (!source) {
    opened.why_no_rows = "has no channel called " + options.layer;
    opened.remedy = "it has R, G, B, A or Y";
    return opened;
  }
  opened.rows = std::make_unique<PngRows>(std::move(png), layout, opened.facts.info);
  return opened;
}

}  // namespace tristim::detail
