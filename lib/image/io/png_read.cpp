#include <png.h>

#include <algorithm>
#include <csetjmp>
#include <limits>
#include <optional>
#include <utility>

#include "lib/image/io/png_colour.h"
#include "lib/image/io/readers.h"
#include "lib/image/io/sample_decoder.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr png_alloc_size_t kMaxChunkBytes = png_alloc_size_t{16} << 20;

/// libpng's reader. Its errors jump, so each function below that calls it sets the jump's target
/// and has no object with a destructor in between.
class PngFile {
 public:
  explicit PngFile(InputFilePtr file) : file_(std::move(file)) {
    png_ = png_create_read_struct(PNG_LIBPNG_VER_STRING, this, fail, ignore);
    info_ = png_ != nullptr ? png_create_info_struct(png_) : nullptr;
    if (info_ == nullptr) {
      png_destroy_read_struct(&png_, nullptr, nullptr);
      throw std::bad_alloc();
    }
  }
  ~PngFile() { png_destroy_read_struct(&png_, &info_, nullptr); }
  PngFile(const PngFile&) = delete;
  PngFile& operator=(const PngFile&) = delete;

  /// What stands before the pixels. False where it is damaged.
  bool read_header();
  /// The next row; of an interlaced file, all of them.
  bool read_rows(png_bytepp rows, int count);

  const InputFile& file() const noexcept { return *file_; }
  png_uint_32 width() const noexcept { return width_; }
  png_uint_32 height() const noexcept { return height_; }
  bool interlaced() const noexcept { return interlaced_; }
  int stored_depth() const noexcept { return stored_depth_; }
  int stored_type() const noexcept { return stored_type_; }
  int samples() const noexcept { return samples_; }
  int depth() const noexcept { return depth_; }
  const PngColour& colour() const noexcept { return colour_; }
  double pixel_aspect() const noexcept { return pixel_aspect_; }
  int orientation() const noexcept { return orientation_; }
  const char* message() const noexcept { return message_; }

 private:
  static void fail(png_structp png, png_const_charp text) {
    auto* self = static_cast<PngFile*>(png_get_error_ptr(png));
    const std::string_view words(text);
    const std::size_t size = std::min(words.size(), sizeof(self->message_) - 1);
    words.copy(self->message_, size);
    self->message_[size] = '\0';
    png_longjmp(png, 1);
  }
  static void ignore(png_structp /*png*/, png_const_charp /*text*/) {}
  static void read_bytes(png_structp png, png_bytep bytes, size_t size);
  void choose_transformations();
  void read_metadata();

  InputFilePtr file_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  std::uint64_t position_ = 0;
  png_uint_32 width_ = 0;
  png_uint_32 height_ = 0;
  bool interlaced_ = false;
  int stored_depth_ = 0;
  int stored_type_ = 0;
  int samples_ = 0;
  int depth_ = 0;
  PngColour colour_;
  double pixel_aspect_ = 1;
  int orientation_ = 1;
  char message_[128] = "";
};

void PngFile::read_bytes(png_structp png, png_bytep bytes, size_t size) {
  auto* self = static_cast<PngFile*>(png_get_io_ptr(png));
  std::size_t count = 0;
  try {  // nothing may be thrown through libpng
    count = self->file_->read_at(self->position_, {reinterpret_cast<std::byte*>(bytes), size});
  } catch (const Error&) {
    count = 0;
  }
  if (count < size) png_error(png, "the file ends early");
  self->position_ += size;
}

bool PngFile::read_header() {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(modernize-avoid-setjmp): libpng's way
  png_set_read_fn(png_, this, read_bytes);
  png_set_user_limits(png_, kMaxSide, kMaxSide);
  png_set_chunk_malloc_max(png_, kMaxChunkBytes);
  png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_ALWAYS,
                              reinterpret_cast<png_const_bytep>("cICP"), 1);
  png_read_info(png_, info_);
  width_ = png_get_image_width(png_, info_);
  height_ = png_get_image_height(png_, info_);
  stored_depth_ = png_get_bit_depth(png_, info_);
  stored_type_ = png_get_color_type(png_, info_);
  interlaced_ = png_get_interlace_type(png_, info_) != PNG_INTERLACE_NONE;
  read_metadata();
  choose_transformations();
  return true;
}

void PngFile::read_metadata() {
  read_png_colour(png_, info_, colour_);
  png_uint_32 across = 0;
  png_uint_32 down = 0;
  int unit = PNG_RESOLUTION_UNKNOWN;
  png_get_pHYs(png_, info_, &across, &down, &unit);
  if (across > 0 && down > 0 && across / 100 <= down && down / 100 <= across) {
    pixel_aspect_ = static_cast<double>(down) / across;
  }
  png_uint_32 size = 0;
  png_bytep exif = nullptr;
  if (png_get_eXIf_1(png_, info_, &size, &exif) != 0) orientation_ = exif_orientation(exif, size);
}

void PngFile::choose_transformations() {
  if (stored_type_ == PNG_COLOR_TYPE_PALETTE) png_set_palette_to_rgb(png_);
  if (stored_type_ == PNG_COLOR_TYPE_GRAY && stored_depth_ < 8)
    png_set_expand_gray_1_2_4_to_8(png_);
  if (png_get_valid(png_, info_, PNG_INFO_tRNS) != 0) png_set_tRNS_to_alpha(png_);
  if (stored_depth_ == 16) png_set_swap(png_);  // to little endian
  png_set_interlace_handling(png_);
  png_read_update_info(png_, info_);
  samples_ = png_get_channels(png_, info_);
  depth_ = png_get_bit_depth(png_, info_);
}

bool PngFile::read_rows(png_bytepp rows, int count) {
  if (setjmp(png_jmpbuf(png_)) != 0) return false;  // NOLINT(modernize-avoid-setjmp): libpng's way
  if (interlaced_) {
    png_read_image(png_, rows);
  } else {
    png_read_rows(png_, rows, nullptr, static_cast<png_uint_32>(count));
  }
  return true;
}

class PngRows final : public RowSource {
 public:
  PngRows(std::unique_ptr<PngFile> png, const SampleLayout& layout, PictureInfo info)
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

  std::unique_ptr<PngFile> png_;
  SampleDecoder decoder_;
  PictureInfo info_;
  std::size_t row_bytes_;
  std::vector<std::byte> held_;  // a row, or all rows of an interlaced file
  int next_ = 0;
};

std::vector<std::string> channel_names(const PngFile& png) {
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
std::optional<std::array<int, 4>> choose_samples(const PngFile& png, const std::string& layer) {
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

PictureFacts facts_of(const PngFile& png, const SampleLayout& layout) {
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

void check_png(const PngFile& png) {
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
  auto png = std::make_unique<PngFile>(std::move(file));
  if (!png->read_header()) {
    throw Error(ErrorKind::kContent, png->file().name(),
                std::string("its PNG header is damaged or cut off: ") + png->message(),
                "write or copy it again");
  }
  check_png(*png);
  SampleLayout layout{.type = png->depth() == 16 ? SampleType::kUint16 : SampleType::kUint8,
                      .samples = png->samples(),
                      .alpha = AlphaKind::kStraight,
                      .curve = png->colour().curve};
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
