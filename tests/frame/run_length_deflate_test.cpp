#include "lib/frame/io/run_length_deflate.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <zlib.h>

#include <array>
#include <bit>
#include <numeric>
#include <random>

#include "lib/frame/io/huffman.h"
#include "lib/frame/io/paeth.h"

namespace tristim {
namespace {

using Bytes = std::vector<std::uint8_t>;

/// What zlib reads in a raw stream.
Bytes inflated(const Bytes& stream, std::size_t size) {
  Bytes out(size + 1);
  z_stream z{};
  inflateInit2(&z, -15);
  z.next_in = const_cast<std::uint8_t*>(stream.data());
  z.avail_in = static_cast<uInt>(stream.size());
  z.next_out = out.data();
  z.avail_out = static_cast<uInt>(out.size());
  const int status = inflate(&z, Z_FINISH);
  const std::size_t got = out.size() - z.avail_out;
  const bool whole = status == Z_STREAM_END && z.avail_in == 0;
  inflateEnd(&z);
  out.resize(got);
  return whole ? out : Bytes();
}

Bytes with_runs(std::size_t size, int values, int longest, unsigned seed) {
  std::mt19937 random(seed);
  Bytes bytes;
  while (bytes.size() < size) {
    const auto value = static_cast<std::uint8_t>(random() % static_cast<unsigned>(values));
    bytes.insert(bytes.end(), 1 + random() % static_cast<unsigned>(longest), value);
  }
  bytes.resize(size);
  return bytes;
}

TEST(RunLengthDeflate, IsReadByZlib) {
  for (const std::size_t size : {1U, 2U, 3U, 8U, 9U, 100U, 65535U, 65536U, 65537U, 300000U}) {
    for (const int longest : {1, 2, 4, 30, 700}) {
      for (const int values : {1, 2, 256}) {
        const Bytes bytes = with_runs(size, values, longest, static_cast<unsigned>(size));
        EXPECT_EQ(inflated(detail::run_length_deflated(bytes, true), size), bytes)
            << size << " bytes of " << values << " values in runs up to " << longest;
      }
    }
  }
}

TEST(RunLengthDeflate, EveryLengthOfARun) {
  Bytes bytes;
  for (std::size_t length = 1; length <= 600; ++length) {
    bytes.insert(bytes.end(), length, static_cast<std::uint8_t>(length % 2));
  }
  EXPECT_EQ(inflated(detail::run_length_deflated(bytes, true), bytes.size()), bytes);
}

TEST(RunLengthDeflate, StreamsCanBeJoined) {
  const Bytes first = with_runs(1000, 7, 5, 1);
  const Bytes second = with_runs(70000, 200, 3, 2);
  Bytes stream = detail::run_length_deflated(first, false);
  const Bytes rest = detail::run_length_deflated(second, true);
  stream.insert(stream.end(), rest.begin(), rest.end());
  Bytes both = first;
  both.insert(both.end(), second.begin(), second.end());
  EXPECT_EQ(inflated(stream, both.size()), both);
}

/// As a filter leaves them: small differences of both signs, and flat places.
Bytes differences(std::size_t size, unsigned seed) {
  std::mt19937 random(seed);
  Bytes bytes;
  while (bytes.size() < size) {
    for (int i = 0; i < 200; ++i) {
      const auto magnitude = static_cast<std::uint8_t>(std::countr_zero(random() | 0x80000000U));
      bytes.push_back(random() % 2 == 0 ? magnitude : static_cast<std::uint8_t>(-magnitude));
    }
    bytes.insert(bytes.end(), random() % 200, 0);
  }
  bytes.resize(size);
  return bytes;
}

TEST(RunLengthDeflate, IsNotLargerThanZlibsRuns) {
  const Bytes bytes = differences(200000, 5);
  Bytes peer(compressBound(static_cast<uLong>(bytes.size())));
  z_stream z{};
  deflateInit2(&z, 9, Z_DEFLATED, -15, 9, Z_RLE);
  z.next_in = const_cast<std::uint8_t*>(bytes.data());
  z.avail_in = static_cast<uInt>(bytes.size());
  z.next_out = peer.data();
  z.avail_out = static_cast<uInt>(peer.size());
  deflate(&z, Z_FINISH);
  const std::size_t peer_size = z.total_out;
  deflateEnd(&z);
  EXPECT_LE(detail::run_length_deflated(bytes, true).size(), peer_size);
}

RC_GTEST_PROP(RunLengthDeflate, AnyBytesComeBack, (const Bytes& bytes)) {
  RC_PRE(!bytes.empty());
  RC_ASSERT(inflated(detail::run_length_deflated(bytes, true), bytes.size()) == bytes);
}

TEST(CodeLengths, OfHuffmansExample) {  // counts 1 1 2 3 5 8: each as rare as the rest below it
  const std::array<std::uint32_t, 6> count = {1, 1, 2, 3, 5, 8};
  std::array<std::uint8_t, 6> length{};
  detail::code_lengths(count, 15, length);
  EXPECT_EQ(length, (std::array<std::uint8_t, 6>{5, 5, 4, 3, 2, 1}));
}

TEST(CodeLengths, StayBelowTheLimitAndFillTheCode) {
  std::array<std::uint32_t, 40> fibonacci{1, 1};
  for (std::size_t i = 2; i < fibonacci.size(); ++i) {
    fibonacci[i] = fibonacci[i - 1] + fibonacci[i - 2];
  }
  for (const int most : {6, 7, 10, 15}) {
    std::array<std::uint8_t, 40> length{};
    detail::code_lengths(fibonacci, most, length);
    std::uint64_t used = 0;
    for (const std::uint8_t bits : length) {
      ASSERT_GE(bits, 1);
      ASSERT_LE(bits, most);
      used += std::uint64_t{1} << (most - bits);
    }
    EXPECT_EQ(used, std::uint64_t{1} << most);
  }
}

TEST(CodeLengths, OfOneSymbolOrNone) {
  std::array<std::uint32_t, 3> count{};
  std::array<std::uint8_t, 3> length{9, 9, 9};
  detail::code_lengths(count, 15, length);
  EXPECT_EQ(length, (std::array<std::uint8_t, 3>{}));
  count[1] = 5;
  detail::code_lengths(count, 15, length);
  EXPECT_EQ(length, (std::array<std::uint8_t, 3>{0, 1, 0}));
}

TEST(FilterPaeth, VectorsAreTheDefinition) {
  std::mt19937 random(3);
  for (const std::size_t size : {1U, 3U, 16U, 65U, 66U, 131U, 1000U}) {
    for (const std::size_t pixel : {1U, 2U, 3U, 6U}) {
      Bytes row(size);
      Bytes above(size);
      for (auto* bytes : {&row, &above}) {
        for (std::uint8_t& byte : *bytes) byte = static_cast<std::uint8_t>(random() % 7 * 42);
      }
      Bytes expected(size);
      Bytes actual(size);
      detail::filter_paeth_scalar(row, above, pixel, expected.data());
      detail::filter_paeth(row, above, pixel, actual.data());
      EXPECT_EQ(actual, expected) << size << " bytes, " << pixel << " a pixel";
    }
  }
}

}  // namespace
}  // namespace tristim
