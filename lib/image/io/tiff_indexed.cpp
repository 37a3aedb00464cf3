#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstdio>
#include <memory>
#include <new>

#include "lib/image/io/indexed_readers.h"
#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr tmsize_t kMostHeldBytes = tmsize_t{256} << 20;  // at once, by libtiff

/// libtiff's reader over an InputFile.
class TiffInput {
 public:
  explicit TiffInput(InputFilePtr file) : file_(std::move(file)) {
    const std::unique_ptr<TIFFOpenOptions, decltype(&TIFFOpenOptionsFree)> options(
        TIFFOpenOptionsAlloc(), TIFFOpenOptionsFree);
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), kMostHeldBytes);
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_message, this);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), drop_message, this);
    // 'm': no memory mapping
    tiff_ = TIFFClientOpenExt(name().c_str(), "rm", this, read, write, seek, close, size, nullptr,
                              nullptr, options.get());
    if (tiff_ == nullptr) {
      throw Error(ErrorKind::kContent, name(),
                  std::string("its TIFF header is damaged or cut off: ") + message_.data(),
                  "write or copy it again");
    }
  }
  ~TiffInput() { TIFFClose(tiff_); }
  TiffInput(const TiffInput&) = delete;
  TiffInput& operator=(const TiffInput&) = delete;

  const std::string& name() const noexcept { return file_->name(); }
  const char* message() const noexcept { return message_.data(); }
  TIFF* tiff() const noexcept { return tiff_; }

  template <typename Number>
  Number get(std::uint32_t tag) const {
    Number value{};
    TIFFGetFieldDefaulted(tiff_, tag, &value);
    return value;
  }

 private:
  static tmsize_t read(thandle_t handle, void* bytes, tmsize_t size) {
    auto* self = static_cast<TiffInput*>(handle);
    try {  // nothing may be thrown through libtiff
      const std::size_t count = self->file_->read_at(
          self->position_, {static_cast<std::byte*>(bytes), static_cast<std::size_t>(size)});
      self->position_ += count;
      return static_cast<tmsize_t>(count);
    } catch (const Error&) {
      return 0;
    }
  }
  static tmsize_t write(thandle_t /*self*/, void* /*bytes*/, tmsize_t /*size*/) { return 0; }
  static toff_t seek(thandle_t handle, toff_t offset, int whence) {
    auto* self = static_cast<TiffInput*>(handle);
    const std::uint64_t from = whence == SEEK_CUR   ? self->position_
                               : whence == SEEK_END ? self->file_->size()
                                                    : 0;
    self->position_ = from + offset;
    return self->position_;
  }
  static toff_t size(thandle_t handle) { return static_cast<TiffInput*>(handle)->file_->size(); }
  static int close(thandle_t /*self*/) { return 0; }
  static int keep_message(TIFF* /*tiff*/, void* handle, const char* /*module*/, const char* format,
                          va_list arguments) {
    auto* self = static_cast<TiffInput*>(handle);
    std::vsnprintf(self->message_.data(), self->message_.size(), format, arguments);
    return 1;
  }
  static int drop_message(TIFF* /*tiff*/, void* /*self*/, const char* /*module*/,
                          const char* /*format*/, va_list /*arguments*/) {
    return 1;
  }

  InputFilePtr file_;
  std::uint64_t position_ = 0;
  std::array<char, 128> message_{};
  TIFF* tiff_ = nullptr;
};

// Some writers fill the 16 bits of the table with values of 8.
bool has_8_bits(const std::array<std::uint16_t*, 3>& columns, std::size_t count) {
  return std::ranges::all_of(columns, [&](const std::uint16_t* column) {
    return std::all_of(column, column + count, [](std::uint16_t v) { return v < 256; });
  });
}

bool read_palette(const TiffInput& input, std::size_t count, IndexedPicture& picture) {
  std::array<std::uint16_t*, 3> columns{};
  if (TIFFGetField(input.tiff(), TIFFTAG_COLORMAP, &columns[0], &columns[1], &columns[2]) != 1) {
    return false;
  }
  const bool bytes = has_8_bits(columns, count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<std::uint8_t, 4> entry{0, 0, 0, 255};
    for (std::size_t c = 0; c < 3; ++c) {
      const unsigned value = columns[c][i];
      entry[c] = static_cast<std::uint8_t>(bytes ? value : (value * 255u + 32767u) / 65535u);
    }
    picture.palette.push_back(entry);
  }
  return true;
}

}  // namespace

std::optional<IndexedPicture> read_indexed_tiff(InputFilePtr file) {
  const TiffInput input(std::move(file));
  const auto bits = input.get<std::uint16_t>(TIFFTAG_BITSPERSAMPLE);
  const bool depth_fits = bits == 1 || bits == 2 || bits == 4 || bits == 8;
  if (input.get<std::uint16_t>(TIFFTAG_PHOTOMETRIC) != PHOTOMETRIC_PALETTE || !depth_fits ||
      input.get<std::uint16_t>(TIFFTAG_SAMPLESPERPIXEL) != 1 || TIFFIsTiled(input.tiff()) != 0) {
    return std::nullopt;
  }
  IndexedPicture picture;
  picture.positions = position_raster(input.name(), input.get<std::uint32_t>(TIFFTAG_IMAGEWIDTH),
                                      input.get<std::uint32_t>(TIFFTAG_IMAGELENGTH));
  if (!read_palette(input, std::size_t{1} << bits, picture)) return std::nullopt;
  const auto view = picture.positions.view();
  std::vector<std::uint8_t> row(static_cast<std::size_t>(TIFFScanlineSize(input.tiff())));
  const unsigned mask = (1u << bits) - 1;
  for (int y = 0; y < view.height; ++y) {
    if (TIFFReadScanline(input.tiff(), row.data(), static_cast<std::uint32_t>(y), 0) != 1) {
      fail_at_row(input.name(), y, input.message());
    }
    for (int x = 0; x < view.width; ++x) {
      const unsigned first = static_cast<unsigned>(x) * bits;
      *view.pixel(x, y) =
          static_cast<std::uint8_t>(row[first / 8] >> (8u - bits - first % 8) & mask);
    }
  }
  return picture;
}

}  // namespace tristim::detail
