#include "lib/frame/io/png_stripe.h"

#include <libdeflate.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <utility>

#include "lib/frame/io/huffman.h"
#include "lib/frame/io/paeth.h"
#include "lib/frame/io/run_length_deflate.h"

namespace tristim::detail {
namespace {

constexpr int kRawDeflate = -15;  // windowBits of deflateInit2: no zlib header
constexpr int kMemoryLevel = 9;
constexpr std::size_t kTrialBytes = std::size_t{64} << 10;  // twice deflate's window

enum Filter : std::uint8_t { kNone = 0, kPaeth = 4 };  // [PNG3] table 6: the byte before a row
enum class Matches { kRuns, kFiltered, kAll };

struct Recipe {
  Filter filter;
  Matches matches;
};

constexpr Recipe kRuns{kPaeth, Matches::kRuns};
constexpr Recipe kPlain{kNone, Matches::kAll};
constexpr Recipe kRecipes[] = {kRuns, {kPaeth, Matches::kFiltered}, kPlain};

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

/// Tells how small bytes become, or nearly.
class Trial {
 public:
  std::size_t size(const std::vector<std::uint8_t>& bytes, Matches matches) {
    if (matches == Matches::kRuns) return run_length_deflated(bytes, true).size();
    if (!quick_) throw std::bad_alloc();
    out_.resize(libdeflate_deflate_compress_bound(quick_.get(), bytes.size()));
    return libdeflate_deflate_compress(quick_.get(), bytes.data(), bytes.size(), out_.data(),
                                       out_.size());
  }

 private:
  struct Free {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
  };
  std::unique_ptr<libdeflate_compressor, Free> quick_{libdeflate_alloc_compressor(1)};
  std::vector<std::uint8_t> out_;
};

std::uint64_t load8(const std::uint8_t* bytes) noexcept {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Whether strings of sixteen bytes, of pixels `step` bytes apart, come back within deflate's
/// window so often that matches may pay; a byte that goes on and on is none. Photographs have them
/// at .001 to .01 of their pixels, patterns at .1 and more.
bool has_strings(std::span<const std::uint8_t> bytes, std::size_t step) {
  constexpr std::size_t kString = 16;
  constexpr std::size_t kWindow = std::size_t{32} << 10;
  constexpr std::size_t kOneIn = 64;
  constexpr int kPlaceBits = 12;
  std::array<std::uint32_t, std::size_t{1} << kPlaceBits> place{};  // where a string was last
  std::size_t enough = bytes.size() / step / kOneIn + 1;
  for (std::size_t at = 0; at + kString <= bytes.size(); at += step) {
    const std::uint8_t* here = bytes.data() + at;
    const std::uint64_t first = load8(here);
    const std::uint64_t hash = first * 0x9e3779b97f4a7c15 >> (64 - kPlaceBits);  // golden section
    const std::size_t before = std::exchange(place[hash], static_cast<std::uint32_t>(at));
    if (load8(bytes.data() + before) != first || before == at || at - before > kWindow) continue;
    const bool goes_on = load8(bytes.data() + before + 8) == load8(here + 8);
    const bool one_byte = first == (first & 0xff) * 0x0101010101010101;
    if (goes_on && !one_byte && --enough == 0) return true;
  }
  return false;
}

/// What a Huffman code of the bytes alone would need.
std::uint64_t coded_bits(std::span<const std::uint8_t> bytes) {
  std::array<std::uint32_t, 256> count{};
  for (const std::uint8_t byte : bytes) ++count[byte];
  std::array<std::uint8_t, 256> length{};
  code_lengths(count, 15, length);
  return std::inner_product(count.begin(), count.end(), length.begin(), std::uint64_t{0});
}

/// The recipe that makes the least of some rows in the middle of the stripe.
Recipe best_recipe(const PngStripe& stripe) {
  const std::size_t rows = stripe.rows.size() / stripe.above.size();
  const std::size_t trial_rows =
      std::clamp<std::size_t>(kTrialBytes / stripe.above.size(), 1, rows);
  const std::size_t first = (rows - trial_rows) / 2;
  const auto paeth = filtered(stripe, kPaeth, first, first + trial_rows);
  const auto plain = filtered(stripe, kNone, first, first + trial_rows);
  const auto step = static_cast<std::size_t>(stripe.pixel_bytes);
  // Compressing for a trial takes as long as a tenth of the work itself; most photographs need
  // none.
  if (!has_strings(paeth, step) && !has_strings(plain, step) &&
      coded_bits(paeth) <= coded_bits(plain)) {
    return kRuns;
  }
  Trial trial;
  Recipe best = kPlain;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Recipe& recipe : kRecipes) {
    const std::size_t size = trial.size(recipe.filter == kPaeth ? paeth : plain, recipe.matches);
    if (size >= least) continue;
    least = size;
    best = recipe;
  }
  return best;
}

}  // namespace

CompressedStripe compress_stripe(const PngStripe& stripe, int level, bool last) {
  const Recipe recipe = stripe.filter && level > 0 ? best_recipe(stripe) : kPlain;
  const std::size_t rows = stripe.rows.size() / stripe.above.size();
  std::vector<std::uint8_t> bytes = filtered(stripe, recipe.filter, 0, rows);
  CompressedStripe result;
  result.adler = libdeflate_adler32(1, bytes.data(), bytes.size());
  result.filtered_bytes = bytes.size();
  result.last = last;
  if (recipe.matches == Matches::kRuns) {
    result.deflated = run_length_deflated(bytes, last);
  } else {
    const bool of_filter = recipe.matches == Matches::kFiltered;
    result.deflated = deflated(bytes, level, of_filter ? Z_FILTERED : Z_DEFAULT_STRATEGY, last);
  }
  return result;
}

}  // namespace tristim::detail
