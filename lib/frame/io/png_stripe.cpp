#include "lib/frame/io/png_stripe.h"

#include <zlib.h>

#include <algorithm>
#include <cassert>
#include <cstdlib>
#include <limits>
#include <new>

namespace tristim::detail {
namespace {

constexpr int kRawDeflate = -15;  // windowBits of deflateInit2: no zlib header
constexpr int kMemoryLevel = 9;
constexpr std::size_t kTrialBytes = std::size_t{64} << 10;  // twice deflate's window

enum Filter : std::uint8_t { kNone = 0, kPaeth = 4 };  // [PNG3] table 6: the byte before a row

struct Recipe {
  Filter filter;
  int strategy;
};

constexpr Recipe kPlain{kNone, Z_DEFAULT_STRATEGY};
constexpr Recipe kRecipes[] = {{kPaeth, Z_RLE}, {kPaeth, Z_FILTERED}, kPlain};

std::uint8_t paeth(int left, int above, int above_left) noexcept {  // [PNG3] 9.4
  const int to_left = std::abs(above - above_left);
  const int to_above = std::abs(left - above_left);
  const int to_above_left = std::abs(left + above - 2 * above_left);
  const int near = to_left <= to_above ? left : above;
  const int predicted = std::min(to_left, to_above) <= to_above_left ? near : above_left;
  return static_cast<std::uint8_t>(predicted);
}

void filter_paeth(std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                  std::size_t pixel_bytes, std::uint8_t* out) noexcept {
  const std::size_t first = std::min(pixel_bytes, row.size());
  for (std::size_t i = 0; i < first; ++i) out[i] = static_cast<std::uint8_t>(row[i] - above[i]);
  for (std::size_t i = first; i < row.size(); ++i) {
    const std::uint8_t predicted = paeth(row[i - pixel_bytes], above[i], above[i - pixel_bytes]);
    out[i] = static_cast<std::uint8_t>(row[i] - predicted);
  }
}

/// The rows `first` to `end` of the stripe, each behind the byte that names its filter.
std::vector<std::uint8_t> filtered(const PngStripe& stripe, Filter filter, std::size_t first,
                                   std::size_t end) {
  const std::size_t row_bytes = stripe.above.size();
  std::vector<std::uint8_t> bytes((end - first) * (row_bytes + 1));
  std::uint8_t* out = bytes.data();
  for (std::size_t y = first; y < end; ++y) {
    const auto row = stripe.rows.subspan(y * row_bytes, row_bytes);
    const auto above = y == 0 ? stripe.above : stripe.rows.subspan((y - 1) * row_bytes, row_bytes);
    *out++ = filter;
    if (filter == kPaeth) {
      filter_paeth(row, above, static_cast<std::size_t>(stripe.pixel_bytes), out);
    } else {
      std::copy(row.begin(), row.end(), out);
    }
    out += row_bytes;
  }
  return bytes;
}

/// Raw deflate blocks; without `last` they end at a byte and the stream goes on.
std::vector<std::uint8_t> deflated(std::vector<std::uint8_t>& bytes, int level, int strategy,
                                   bool last) {
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, kRawDeflate, kMemoryLevel, strategy) != Z_OK) {
    throw std::bad_alloc();
  }
  struct Ender {
    z_stream& stream;
    ~Ender() { deflateEnd(&stream); }
  } const ender{stream};

  constexpr std::size_t kSyncBytes = 16;  // more than the empty block that Z_SYNC_FLUSH adds
  constexpr std::size_t kMost = std::numeric_limits<uInt>::max() / 2;
  std::vector<std::uint8_t> result(deflateBound(&stream, bytes.size()) + kSyncBytes);
  std::size_t taken = 0;
  std::size_t given = 0;
  int status = Z_OK;
  do {
    const std::size_t input = std::min(bytes.size() - taken, kMost);
    const std::size_t output = std::min(result.size() - given, kMost);
    const int end_flush = last ? Z_FINISH : Z_SYNC_FLUSH;
    stream.next_in = bytes.data() + taken;
    stream.avail_in = static_cast<uInt>(input);
    stream.next_out = result.data() + given;
    stream.avail_out = static_cast<uInt>(output);
    status = deflate(&stream, taken + input == bytes.size() ? end_flush : Z_NO_FLUSH);
    assert(status == Z_OK || status == Z_STREAM_END);
    taken += input - stream.avail_in;
    given += output - stream.avail_out;
  } while (last ? status == Z_OK : taken < bytes.size() || stream.avail_out == 0);
  result.resize(given);
  return result;
}

/// The recipe that makes the least of some rows in the middle of the stripe.
Recipe best_recipe(const PngStripe& stripe) {
  const std::size_t rows = stripe.rows.size() / stripe.above.size();
  const std::size_t trial_rows =
      std::clamp<std::size_t>(kTrialBytes / stripe.above.size(), 1, rows);
  const std::size_t first = (rows - trial_rows) / 2;
  Recipe best = kPlain;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Recipe& recipe : kRecipes) {
    std::vector<std::uint8_t> bytes = filtered(stripe, recipe.filter, first, first + trial_rows);
    const std::size_t size = deflated(bytes, 1, recipe.strategy, true).size();
    if (size < least) {
      least = size;
      best = recipe;
    }
  }
  return best;
}

}  // namespace

CompressedStripe compress_stripe(const PngStripe& stripe, int level, bool last) {
  const Recipe recipe = stripe.filter && level > 0 ? best_recipe(stripe) : kPlain;
  const std::size_t rows = stripe.rows.size() / stripe.above.size();
  std::vector<std::uint8_t> bytes = filtered(stripe, recipe.filter, 0, rows);
  CompressedStripe result;
  result.adler = static_cast<std::uint32_t>(adler32_z(1, bytes.data(), bytes.size()));
  result.filtered_bytes = bytes.size();
  result.last = last;
  result.deflated = deflated(bytes, level, recipe.strategy, last);
  return result;
}

}  // namespace tristim::detail
