#include "lib/frame/io/byte_runs.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <bit>

namespace tristim::detail {
namespace {

/// Which of 64 bytes are as the one before them; `bytes[-1]` is there too.
std::uint64_t repeats_of_64(const std::uint8_t* bytes) noexcept {
  std::uint64_t repeats = 0;
#ifdef __SSE2__
  for (int part = 0; part < 64; part += 16) {
    const __m128i here = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + part));
    const __m128i before = _mm_loadu_si128(reinterpret_cast<const __m128i*>(bytes + part - 1));
    const auto same = static_cast<unsigned>(_mm_movemask_epi8(_mm_cmpeq_epi8(here, before)));
    repeats |= std::uint64_t{same} << part;
  }
#else
  for (int i = 0; i < 64; ++i) repeats |= std::uint64_t{bytes[i] == bytes[i - 1]} << i;
#endif
  return repeats;
}

void mark_repeats(std::span<const std::uint8_t> all, std::size_t begin, std::size_t end,
                  ByteRuns::Repeats& repeats) noexcept {
  const std::uint8_t* bytes = all.data() + begin;
  const std::size_t count = end - begin;
  std::size_t at = 0;
  repeats.fill(0);
  const auto mark = [&](std::size_t i) {
    const bool same = begin + i > 0 && bytes[i] == bytes[static_cast<std::ptrdiff_t>(i) - 1];
    repeats[i / 64] |= std::uint64_t{same} << i % 64;
  };
  if (begin == 0) {  // there is no byte before the first one
    for (; at < std::min<std::size_t>(count, 64); ++at) mark(at);
  }
  for (; at + 64 <= count; at += 64) repeats[at / 64] = repeats_of_64(bytes + at);
  for (; at < count; ++at) mark(at);
}

/// Where a run of ByteRuns::kShortest bytes begins: the bits of `here`, which those of `next`
/// follow.
std::uint64_t begins_of_runs(std::uint64_t here, std::uint64_t next) noexcept {
  static_assert(ByteRuns::kShortest == 1 + 1 + 2 + 4 + 3);
  for (const int more : {1, 2, 4, 3}) {
    here &= here >> more | next << (64 - more);
    next &= next >> more;
  }
  return here;
}

/// Where the next run begins, from `at` on, or `count`.
std::size_t next_run(const ByteRuns::Repeats& repeats, std::size_t at, std::size_t count) noexcept {
  const std::size_t words = (count + 63) / 64;
  std::size_t word = at / 64;
  if (word >= words) return count;
  std::uint64_t found = begins_of_runs(repeats[word], repeats[word + 1]) & ~std::uint64_t{0}
                                                                               << at % 64;
  while (found == 0) {
    if (++word == words) return count;
    found = begins_of_runs(repeats[word], repeats[word + 1]);
  }
  return 64 * word + static_cast<std::size_t>(std::countr_zero(found));
}

/// The first byte from `at` on that is not as the one before.
std::size_t end_of_run(const ByteRuns::Repeats& repeats, std::size_t at) noexcept {
  std::size_t word = at / 64;
  std::uint64_t others = ~repeats[word] & ~std::uint64_t{0} << at % 64;
  while (others == 0) others = ~repeats[++word];
  return 64 * word + static_cast<std::size_t>(std::countr_zero(others));
}

}  // namespace

std::span<const ByteRun> ByteRuns::find(std::span<const std::uint8_t> all, std::size_t begin,
                                        std::size_t end) {
  const std::size_t count = end - begin;
  mark_repeats(all, begin, end, repeats_);
  runs_.clear();
  for (std::size_t at = 0; (at = next_run(repeats_, at, count)) < count;) {
    const std::size_t length = std::min(end_of_run(repeats_, at) - at, kLongest);
    runs_.push_back({static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(length)});
    at += length;
  }
  return runs_;
}

}  // namespace tristim::detail
