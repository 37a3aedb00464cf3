#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace tristim::detail {

/// A run: `length` bytes from `begin` on, counted in a block, are as the one before them.
struct ByteRun {
  std::uint32_t begin;
  std::uint32_t length;
};

/// Finds runs in the blocks of a stream that are worth being told as runs.
class ByteRuns {
 public:
  /// Bytes that share a code: few enough to follow the picture, enough to pay for the code.
  static constexpr std::size_t kBlockBytes = std::size_t{64} << 10;

  /// Shorter ones are cheaper as single bytes: where runs are many their byte has a short code, and
  /// a run is a branch that nobody foresees. Measured on filtered photographs and renderings: 11
  /// makes the least and is as fast as any; 3 makes up to 8 % more in twice the time.
  static constexpr std::size_t kShortest = 11;
  static constexpr std::size_t kLongest = 258;  // that deflate can tell [RFC1951 3.2.5]

  using Repeats = std::array<std::uint64_t, kBlockBytes / 64 + 1>;  // a bit for each byte

  /// The runs of the bytes `begin` to `end` of `all`, at most a block, in their order; valid until
  /// the next call. Bytes of a run that is longer than kLongest make several.
  std::span<const ByteRun> find(std::span<const std::uint8_t> all, std::size_t begin,
                                std::size_t end);

 private:
  Repeats repeats_;  // which bytes are as the one before them; zeros behind
  std::vector<ByteRun> runs_;
};

}  // namespace tristim::detail
