#include <algorithm>
#include <array>
#include <cstring>
#include <vector>

#include "lib/frame/io/color_table.h"
#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "lib/frame/io/row_widening.h"
#include "lib/frame/io/tiff_file.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kStripBytes = std::size_t{64} << 10;
constexpr std::size_t kLargeBytes = std::size_t{3800} << 20;  // deflate may add a little

/// How a frame becomes TIFF samples [TIFF6].
struct Shape {
  std::uint16_t photometric = PHOTOMETRIC_MINISBLACK;
  std::uint16_t compression = COMPRESSION_ADOBE_DEFLATE;
  int depth = 8;  // bits of a sample: 1, 2, 4, 8 or 16
  int samples = 1;
  ColorTable table;  // of PHOTOMETRIC_PALETTE
};

int stored_depth(int bits) {
  for (const int depth : {1, 2, 4, 8}) {
    if (bits <= depth) return depth;
  }
  return 16;
}

/// Whether entry `white` of two is white and the other one black.
bool is_black_and_white(const std::vector<PaletteEntry>& palette, std::size_t white) {
  return palette.size() == 2 && palette[white].srgb == std::array<std::uint8_t, 3>{255, 255, 255} &&
         palette[1 - white].srgb == std::array<std::uint8_t, 3>{0, 0, 0};
}

/// One bit goes as Group 4, which every printer reads; 0 is black, or white where a palette has it
/// first.
Shape shape_of(const std::string& path, const FrameInfo& info) {
  const Packing& packing = info.layout.packing;
  Shape shape;
  const bool white_first = is_black_and_white(info.palette, 0);
  if (white_first || is_black_and_white(info.palette, 1)) {
    shape.photometric = white_first ? PHOTOMETRIC_MINISWHITE : PHOTOMETRIC_MINISBLACK;
    shape.depth = 1;
  } else if (!info.palette.empty()) {
    shape.table = color_table(path, info, "TIFF");
    shape.photometric = PHOTOMETRIC_PALETTE;
    shape.depth = stored_depth(shape.table.bits);
  } else if (packing.samples == 1) {
    shape.depth = stored_depth(packing.bits[0]);
  } else {
    shape.photometric = PHOTOMETRIC_RGB;
    shape.samples = 3;
    shape.depth = *std::ranges::max_element(packing.bits) > 8 ? 16 : 8;
  }
  const bool bilevel = shape.depth == 1 && shape.table.entries.empty();
  if (bilevel) shape.compression = COMPRESSION_CCITTFAX4;
  return shape;
}

class TiffSink final : public FileSink {
 public:
  TiffSink(const std::string& path, const FrameInfo& info, bool replace, const Shape& shape)
      : FileSink(path, info, replace, /*seekable=*/true),
        indexed_(!info.palette.empty()),
        widening_(info, indexed_ ? info.layout.packing.bits[0] : shape.depth),
        tiff_(file(), is_large(info, shape)) {
    const int second = shape.samples == 3 ? shape.depth : 0;
    packed_.packing = {"", shape.samples, {shape.depth, second, second}, false, false};
    bytes_.resize(packed_row_bytes(packed_.packing, info.width));
    set_samples(shape);
    set_colour();
    if (shape.photometric == PHOTOMETRIC_PALETTE) set_table(shape);
  }

 private:
  static bool is_large(const FrameInfo& info, const Shape& shape) {
    const auto bits = static_cast<std::size_t>(shape.depth * shape.samples);
    return static_cast<std::size_t>(info.width) * bits / 8 >
           kLargeBytes / static_cast<std::size_t>(info.height);
  }

  void set_samples(const Shape& shape) {
    const auto rows = std::max<std::size_t>(1, kStripBytes / bytes_.size());
    tiff_.set(TIFFTAG_IMAGEWIDTH, static_cast<std::uint32_t>(info().width));
    tiff_.set(TIFFTAG_IMAGELENGTH, static_cast<std::uint32_t>(info().height));
    tiff_.set(TIFFTAG_BITSPERSAMPLE, shape.depth);
    tiff_.set(TIFFTAG_SAMPLESPERPIXEL, shape.samples);
    tiff_.set(TIFFTAG_PHOTOMETRIC, int{shape.photometric});
    tiff_.set(TIFFTAG_COMPRESSION, int{shape.compression});
    tiff_.set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
    tiff_.set(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT);
    tiff_.set(TIFFTAG_ROWSPERSTRIP, static_cast<std::uint32_t>(rows));
    const bool related = shape.depth >= 8 && shape.photometric != PHOTOMETRIC_PALETTE;
    if (related) tiff_.set(TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
  }

  void set_colour() {
    tiff_.set(TIFFTAG_SOFTWARE, "tristim");
    if (info().dpi > 0) {
      tiff_.set(TIFFTAG_RESOLUTIONUNIT, RESUNIT_INCH);
      tiff_.set(TIFFTAG_XRESOLUTION, info().dpi);
      tiff_.set(TIFFTAG_YRESOLUTION, info().dpi);
    }
    if (!info().palette.empty() || info().layout.packing.samples != 3) return;
    const Primaries& p = info().primaries;
    std::array<float, 8> xy{};
    std::size_t i = 0;
    for (const Chromaticity c : {p.white, p.red, p.green, p.blue}) {
      if (c.x < 0 || c.y < 0) return;  // the tags have no negative numbers
      xy[i++] = static_cast<float>(c.x);
      xy[i++] = static_cast<float>(c.y);
    }
    tiff_.set(TIFFTAG_WHITEPOINT, xy.data());
    tiff_.set(TIFFTAG_PRIMARYCHROMATICITIES, xy.data() + 2);
  }

  void set_table(const Shape& shape) {
    std::array<std::vector<std::uint16_t>, 3> columns;
    for (auto& column : columns) column.resize(std::size_t{1} << shape.depth);
    for (std::size_t i = 0; i < shape.table.entries.size(); ++i) {
      for (std::size_t c = 0; c < 3; ++c) {
        columns[c][i] = widen(shape.table.entries[i].srgb[c], 8, 16);
      }
    }
    tiff_.set(TIFFTAG_COLORMAP, columns[0].data(), columns[1].data(), columns[2].data());
  }

  void write_row(std::span<const std::uint16_t> codes) override {
    const auto samples = indexed_ ? codes : widening_(codes);
    if (packed_.packing.bits[0] == 16) {
      std::memcpy(bytes_.data(), samples.data(), bytes_.size());
    } else {
      pack_row(samples, packed_, bytes_);
    }
    tiff_.put_row(bytes_.data());
  }

  void write_end() override { tiff_.end(); }

  bool indexed_;
  RowWidening widening_;
  TiffFile tiff_;
  FrameLayout packed_;  // TIFF's own: most significant bit first
  std::vector<std::uint8_t> bytes_;
};

}  // namespace

std::unique_ptr<CodeSink> open_tiff(const std::string& path, const FrameInfo& info,
                                    const FrameWriteOptions& options) {
  return std::make_unique<TiffSink>(path, info, options.replace, shape_of(path, info));
}

}  // namespace tristim::detail
