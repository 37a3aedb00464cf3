#include "lib/image/io/exr_zip.h"

#include <libdeflate.h>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <algorithm>
#include <new>

namespace tristim::detail {
namespace {

constexpr int kLevel = 4;  // measured: level 6 is 1 % smaller in twice the time

// Sums up bytes of which each is the difference from the one before plus 128. `sum` is the one
// before the first. Taken from 128, the first byte is its own sum.
void sum_differences(std::span<std::byte> bytes, unsigned sum) noexcept {
  for (std::byte& byte : bytes) {
    sum = (sum + static_cast<unsigned>(byte) - 128) & 0xff;
    byte = static_cast<std::byte>(sum);
  }
}

#ifdef __SSE2__

// Sixteen at a time: each lane adds the lanes 1, 2, 4 and 8 before it in turn.
void sum_differences(std::span<std::byte> bytes) noexcept {
  const __m128i offset = _mm_set1_epi8(-128);
  __m128i before = offset;
  std::size_t i = 0;
  for (; i + 16 <= bytes.size(); i += 16) {
    auto* place = reinterpret_cast<__m128i*>(bytes.data() + i);
    __m128i sum = _mm_add_epi8(_mm_loadu_si128(place), offset);
    sum = _mm_add_epi8(sum, _mm_slli_si128(sum, 1));
    sum = _mm_add_epi8(sum, _mm_slli_si128(sum, 2));
    sum = _mm_add_epi8(sum, _mm_slli_si128(sum, 4));
    sum = _mm_add_epi8(sum, _mm_slli_si128(sum, 8));
    sum = _mm_add_epi8(sum, before);
    _mm_storeu_si128(place, sum);
    before = _mm_set1_epi8(static_cast<char>(bytes[i + 15]));
  }
  sum_differences(bytes.subspan(i), i == 0 ? 128 : static_cast<unsigned>(bytes[i - 1]));
}

std::size_t join_blocks(const std::byte* even, const std::byte* odd, std::size_t pairs,
                        std::byte* joined) noexcept {
  std::size_t i = 0;
  for (; i + 16 <= pairs; i += 16) {
    const __m128i a = _mm_loadu_si128(reinterpret_cast<const __m128i*>(even + i));
    const __m128i b = _mm_loadu_si128(reinterpret_cast<const __m128i*>(odd + i));
    auto* place = reinterpret_cast<__m128i*>(joined + 2 * i);
    _mm_storeu_si128(place, _mm_unpacklo_epi8(a, b));
    _mm_storeu_si128(place + 1, _mm_unpackhi_epi8(a, b));
  }
  return i;
}

#else

void sum_differences(std::span<std::byte> bytes) noexcept { sum_differences(bytes, 128); }

std::size_t join_blocks(const std::byte*, const std::byte*, std::size_t, std::byte*) noexcept {
  return 0;
}

#endif

void take_differences(std::span<std::byte> bytes) noexcept {
  auto before = static_cast<unsigned>(bytes[0]);
  for (std::size_t i = 1; i < bytes.size(); ++i) {
    const auto byte = static_cast<unsigned>(bytes[i]);
    bytes[i] = static_cast<std::byte>((byte - before + 128) & 0xff);
    before = byte;
  }
}

// The first half of `halves` holds the bytes of even places.
void join_halves(std::span<const std::byte> halves, std::span<std::byte> joined) noexcept {
  const std::size_t even_count = (joined.size() + 1) / 2;
  const std::byte* even = halves.data();
  const std::byte* odd = halves.data() + even_count;
  const std::size_t pairs = joined.size() / 2;
  for (std::size_t i = join_blocks(even, odd, pairs, joined.data()); i < pairs; ++i) {
    joined[2 * i] = even[i];
    joined[2 * i + 1] = odd[i];
  }
  if (even_count > pairs) joined.back() = even[pairs];
}

void split_halves(std::span<const std::byte> joined, std::span<std::byte> halves) noexcept {
  const std::size_t even_count = (joined.size() + 1) / 2;
  for (std::size_t i = 0; i < joined.size(); ++i) {
    halves[i % 2 == 0 ? i / 2 : even_count + i / 2] = joined[i];
  }
}

}  // namespace

ExrZip::ExrZip() = default;

ExrZip::~ExrZip() {
  if (decompressor_ != nullptr) libdeflate_free_decompressor(decompressor_);
  if (compressor_ != nullptr) libdeflate_free_compressor(compressor_);
}

bool ExrZip::unpack(std::span<const std::byte> packed, std::span<std::byte> raw) {
  if (raw.empty()) return false;
  if (decompressor_ == nullptr) decompressor_ = libdeflate_alloc_decompressor();
  if (decompressor_ == nullptr) throw std::bad_alloc();
  if (shuffled_.size() < raw.size()) shuffled_.resize(raw.size());
  const std::span<std::byte> halves(shuffled_.data(), raw.size());
  const auto result = libdeflate_zlib_decompress(decompressor_, packed.data(), packed.size(),
                                                 halves.data(), halves.size(), nullptr);
  if (result != LIBDEFLATE_SUCCESS) return false;
  sum_differences(halves);
  join_halves(halves, raw);
  return true;
}

std::span<const std::byte> ExrZip::pack(std::span<const std::byte> raw) {
  if (raw.empty()) return raw;
  if (compressor_ == nullptr) compressor_ = libdeflate_alloc_compressor(kLevel);
  if (compressor_ == nullptr) throw std::bad_alloc();
  shuffled_.resize(raw.size());
  packed_.resize(raw.size());
  split_halves(raw, shuffled_);
  take_differences(shuffled_);
  // no room for more than `raw` itself: libdeflate then returns 0
  const std::size_t size = libdeflate_zlib_compress(compressor_, shuffled_.data(), shuffled_.size(),
                                                    packed_.data(), packed_.size());
  if (size == 0 || size >= raw.size()) return raw;
  return {packed_.data(), size};
}

}  // namespace tristim::detail
