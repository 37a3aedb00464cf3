#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "lib/frame/io/color_table.h"
#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "lib/frame/io/row_widening.h"
#include "tristim/core/error.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kHeaderBytes = 14 + 40;  // BITMAPFILEHEADER and BITMAPINFOHEADER [BMP]
constexpr std::size_t kMostBytes = 0xffffffff;
constexpr std::size_t kZeroBytes = std::size_t{64} << 10;
constexpr double kMetresPerInch = 0.0254;

struct Shape {
  ColorTable table;  // no entries: 24 bits of blue, green, red
  int bits = 24;     // of a pixel
  std::size_t row_bytes = 0;
  std::size_t pixels_at = 0;  // where the rows begin
};

Shape shape_of(const std::string& path, const FrameInfo& info) {
  Shape shape;
  const Packing& packing = info.layout.packing;
  if (packing.samples == 1) {
    shape.table = color_table(path, info, "BMP");
    shape.bits = shape.table.bits == 1 ? 1 : shape.table.bits <= 4 ? 4 : 8;
  } else if (*std::ranges::max_element(packing.bits) > 8) {
    throw Error(
        ErrorKind::kMisuse, path,
        "BMP holds 8 bits a channel, codes of packing " + std::string(packing.name) + " have more",
        "write PNG or TIFF");
  }
  const auto width = static_cast<std::size_t>(info.width);
  shape.row_bytes = (width * static_cast<std::size_t>(shape.bits) + 31) / 32 * 4;
  shape.pixels_at = kHeaderBytes + 4 * shape.table.entries.size();
  if (shape.row_bytes > (kMostBytes - shape.pixels_at) / static_cast<std::size_t>(info.height)) {
    throw Error(ErrorKind::kMisuse, path, "BMP holds at most 4 GiB", "write PNG or TIFF");
  }
  return shape;
}

void put(std::vector<std::uint8_t>& bytes, std::size_t value, int count) {
  for (int i = 0; i < count; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> 8 * i));
}

/// Rows stand from the bottom up: other programs do not read files whose height is negative.
class BmpSink final : public FileSink {
 public:
  BmpSink(const std::string& path, const FrameInfo& info, bool replace, Shape shape)
      : FileSink(path, info, replace, /*seekable=*/true),
        shape_(std::move(shape)),
        widening_(info, 8),
        bytes_(shape_.row_bytes) {
    const bool indexed = !shape_.table.entries.empty();
    packed_.packing = indexed ? Packing{"", 1, {shape_.bits, 0, 0}, true, false}
                              : Packing{"", 3, {8, 8, 8}, false, true};
    write_head();
    const std::vector<std::byte> zeros(kZeroBytes);
    std::size_t left = shape_.row_bytes * static_cast<std::size_t>(info.height);
    for (; left > 0; left -= std::min(left, zeros.size())) {
      file().write(std::span(zeros).first(std::min(left, zeros.size())));
    }
  }

 private:
  void write_head() {
    const auto height = static_cast<std::size_t>(info().height);
    const std::size_t picture_bytes = shape_.row_bytes * height;
    const double dots = std::min(std::round(info().dpi / kMetresPerInch), 2e9);
    std::vector<std::uint8_t> head{'B', 'M'};
    put(head, shape_.pixels_at + picture_bytes, 4);
    put(head, 0, 4);
    put(head, shape_.pixels_at, 4);
    put(head, 40, 4);
    put(head, static_cast<std::size_t>(info().width), 4);
    put(head, height, 4);
    put(head, 1, 2);
    put(head, static_cast<std::size_t>(shape_.bits), 2);
    put(head, 0, 4);  // no compression
    put(head, picture_bytes, 4);
    put(head, static_cast<std::size_t>(dots), 4);
    put(head, static_cast<std::size_t>(dots), 4);
    put(head, shape_.table.entries.size(), 4);
    put(head, 0, 4);
    for (const PaletteEntry& entry : shape_.table.entries) {
      for (std::size_t c = 3; c-- > 0;) head.push_back(entry.srgb[c]);
      head.push_back(0);
    }
    file().write(std::as_bytes(std::span(head)));
  }

  void write_row(std::span<const std::uint16_t> codes) override {
    const bool indexed = !shape_.table.entries.empty();
    const std::size_t used = packed_row_bytes(packed_.packing, info().width);
    pack_row(indexed ? codes : widening_(codes), packed_, std::span(bytes_).first(used));
    const auto from_bottom = static_cast<std::size_t>(info().height - 1 - y_++);
    file().write_at(shape_.pixels_at + from_bottom * shape_.row_bytes,
                    std::as_bytes(std::span(bytes_)));
  }

  Shape shape_;
  RowWidening widening_;
  FrameLayout packed_;
  std::vector<std::uint8_t> bytes_;  // a row; those behind the pixels stay 0
  int y_ = 0;
};

}  // namespace

std::unique_ptr<CodeSink> open_bmp(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options) {
  return std::make_unique<BmpSink>(path, info, options.replace, shape_of(path, info));
}

}  // namespace tristim::detail
