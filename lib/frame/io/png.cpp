#include <zlib.h>

#include <algorithm>
#include <array>
#include <deque>
#include <future>
#include <stdexcept>
#include <vector>

#include "lib/core/parallel.h"
#include "lib/frame/io/file_sink.h"
#include "lib/frame/io/formats.h"
#include "lib/frame/io/png_file.h"
#include "lib/frame/io/png_stripe.h"
#include "lib/frame/io/row_widening.h"
#include "tristim/core/error.h"
#include "tristim/frame/pack.h"

namespace tristim::detail {
namespace {

constexpr std::size_t kStripeBytes = std::size_t{512} << 10;
constexpr std::size_t kMinStripeRows = 8;  // so that the trial on a very wide row is a small part

int smallest_depth(int bits) {
  for (const int depth : {1, 2, 4, 8}) {
    if (bits <= depth) return depth;
  }
  return 16;
}

PngShape palette_shape(const std::string& path, const FrameInfo& info) {
  const std::size_t colours = info.palette.size();
  const int bits = std::min(info.layout.packing.bits[0], 8);
  const std::size_t limit = std::size_t{1} << bits;
  if (colours > limit) {
    throw Error(
        ErrorKind::kMisuse, path,
        "a palette of " + std::to_string(colours) + " colours, but indexed PNG of packing " +
            std::string(info.layout.packing.name) + " holds at most " + std::to_string(limit),
        "use fewer colours or a wider packing");
  }
  int depth = smallest_depth(bits);
  if (info.layout.packing.bits[0] > 8) {
    depth = 1;
    while (colours > (std::size_t{1} << depth)) depth *= 2;
  }
  return {PngColour::kPalette, depth, 1};
}

PngShape shape_of(const std::string& path, const FrameInfo& info) {
  if (!info.palette.empty()) return palette_shape(path, info);
  const Packing& packing = info.layout.packing;
  if (packing.samples == 1) return {PngColour::kGrey, smallest_depth(packing.bits[0]), 1};
  const int most = *std::ranges::max_element(packing.bits);
  return {PngColour::kRgb, most > 8 ? 16 : 8, 3};
}

/// The bytes before the deflate blocks: a window of 32 KiB and what the level was [RFC1950].
std::vector<std::uint8_t> zlib_header(int level) {
  const std::uint8_t flags = level < 2 ? 0x01 : level < 6 ? 0x5e : level == 6 ? 0x9c : 0xda;
  return {0x78, flags};
}

class PngSink final : public FileSink {
 public:
  PngSink(const std::string& path, const FrameInfo& frame, const FrameWriteOptions& options,
          const PngShape& shape)
      : FileSink(path, frame, options.replace),
        png_(file(), frame, shape),
        level_(options.png_level),
        pixel_bytes_(std::max(1, shape.depth * shape.samples / 8)),
        filter_(shape.colour != PngColour::kPalette && shape.depth >= 8),
        indexed_(shape.colour == PngColour::kPalette),
        widening_(frame, shape.depth),
        idat_(zlib_header(level_)),
        stripes_at_once_(static_cast<std::size_t>(thread_count(options.threads))) {
    const int second = shape.samples == 3 ? shape.depth : 0;
    packed_.packing = {"", shape.samples, {shape.depth, second, second}, false, false};
    above_.resize(packed_row_bytes(packed_.packing, frame.width));
    stripe_bytes_ = std::max(kStripeBytes / above_.size(), kMinStripeRows) * above_.size();
  }

 private:
  void write_row(std::span<const std::uint16_t> codes) override {
    if (rows_.size() == stripe_bytes_) end_stripe(false);
    rows_.resize(rows_.size() + above_.size());
    const auto packed = std::span(rows_).last(above_.size());
    pack_row(indexed_ ? codes : widening_(codes), packed_, packed);
  }

  // Compresses the rows collected so far on a thread of their own, a few stripes at a time; the
  // file gets them in order.
  void end_stripe(bool last) {
    std::vector<std::uint8_t> next_above(rows_.end() - static_cast<std::ptrdiff_t>(above_.size()),
                                         rows_.end());
    const auto policy = stripes_at_once_ > 1 ? std::launch::async : std::launch::deferred;
    running_.push_back(
        std::async(policy, [above = std::move(above_), rows = std::move(rows_),
                            pixel_bytes = pixel_bytes_, filter = filter_, level = level_, last] {
          return compress_stripe({above, rows, pixel_bytes, filter}, level, last);
        }));
    above_ = std::move(next_above);
    rows_ = {};
    if (running_.size() >= stripes_at_once_) write_stripe();
  }

  void write_stripe() {
    const CompressedStripe stripe = running_.front().get();
    running_.pop_front();
    adler_ = adler32_combine(adler_, stripe.adler, static_cast<z_off_t>(stripe.filtered_bytes));
    idat_.insert(idat_.end(), stripe.deflated.begin(), stripe.deflated.end());
    if (stripe.last) {
      for (const int shift : {24, 16, 8, 0}) {
        idat_.push_back(static_cast<std::uint8_t>(adler_ >> shift));
      }
    }
    png_.write_chunk("IDAT", idat_);
    idat_.clear();
  }

  void write_end() override {
    end_stripe(true);
    while (!running_.empty()) write_stripe();
    png_.write_chunk("IEND", {});
  }

  PngFile png_;
  int level_;
  int pixel_bytes_;
  bool filter_;
  bool indexed_;
  RowWidening widening_;
  FrameLayout packed_;               // PNG's own: most significant bit and byte first
  std::size_t stripe_bytes_ = 0;     // depends on the width only, as the file's bytes shall
  std::vector<std::uint8_t> above_;  // the row before the stripe
  std::vector<std::uint8_t> rows_;   // of the stripe
  std::vector<std::uint8_t> idat_;   // of the next chunk
  std::size_t stripes_at_once_;
  std::deque<std::future<CompressedStripe>> running_;
  uLong adler_ = 1;  // of all filtered bytes [RFC1950]
};

}  // namespace

std::unique_ptr<CodeSink> open_png(const std::string& path, const FrameInfo& info,
                                   const FrameWriteOptions& options) {
  if (options.png_level < 0 || options.png_level > 9) {
    throw std::invalid_argument("FrameWriteOptions: png_level " +
                                std::to_string(options.png_level) + ", expected 0 to 9");
  }
  return std::make_unique<PngSink>(path, info, options, shape_of(path, info));
}

}  // namespace tristim::detail
