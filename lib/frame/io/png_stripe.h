#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tristim::detail {

/// Consecutive rows of a PNG picture, packed, without filter bytes.
struct PngStripe {
  std::span<const std::uint8_t>
      above;  // the row before the first one; zeros at the top of the picture
  std::span<const std::uint8_t> rows;  // whole rows of above.size() bytes
  int pixel_bytes = 1;                 // the distance to the sample on the left; at least 1
  bool filter = false;  // whether the rows are samples that have to do with their neighbours
};

/// A stripe as PNG's filtered bytes and the deflate blocks that hold them.
struct CompressedStripe {
  std::vector<std::uint8_t> deflated;  // whole bytes; ends the stream where `last` is set
  std::uint32_t adler = 1;             // of the filtered bytes alone
  std::size_t filtered_bytes = 0;
  bool last = false;
};

/// Filters and compresses a stripe by itself, so that stripes may be compressed in any order.
///
/// Which filter and which matches it takes, a trial on some of the rows decides: run lengths over
/// the Paeth filter for pictures with the noise of a camera or a dither (run_length_deflate.h: many
/// times as fast as zlib's level 6 and some per cent smaller), zlib's string matching for flat and
/// patterned ones. `level` is zlib's, 0 to 9. Throws std::bad_alloc.
CompressedStripe compress_stripe(const PngStripe& stripe, int level, bool last);

}  // namespace tristim::detail
