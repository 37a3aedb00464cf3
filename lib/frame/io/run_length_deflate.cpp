#include "lib/frame/io/run_length_deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "lib/frame/io/huffman.h"

namespace tristim::detail {
namespace {

// [RFC1951] 3.2.5 to 3.2.7.
constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLengthSymbols = 257;  // the first of them
constexpr std::size_t kSymbols = 286;
constexpr std::size_t kShortestRun = 3;
constexpr std::size_t kLongestRun = 258;
constexpr int kLongestCode = 15;
constexpr int kLongestLengthCode = 7;
constexpr std::array<std::uint8_t, 19> kLengthCodeOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                           11, 4,  12, 3, 13, 2, 14, 1, 15};

// Bytes that share a code: small enough to follow the picture, large enough to pay for the code.
constexpr std::size_t kBlockBytes = std::size_t{64} << 10;

/// The symbol of a run's length and the bits behind it.
struct RunSymbol {
  std::uint16_t symbol;
  std::uint8_t extra_bits;
  std::uint8_t extra;
};

RunSymbol run_symbol(std::size_t length) noexcept {
  if (length == kLongestRun) return {kSymbols - 1, 0, 0};
  const auto past = static_cast<unsigned>(length - kShortestRun);
  if (past < 4) return {static_cast<std::uint16_t>(kLengthSymbols + past), 0, 0};
  const auto bits = static_cast<unsigned>(std::bit_width(past)) - 3;
  const unsigned step = past >> bits;  // 4 .. 7
  return {static_cast<std::uint16_t>(kLengthSymbols + 4 * bits + step),
          static_cast<std::uint8_t>(bits), static_cast<std::uint8_t>(past - (step << bits))};
}

/// Bits from the lowest on, behind what `bytes` holds.
class BitWriter {
 public:
  explicit BitWriter(std::vector<std::uint8_t>& bytes) : bytes_(&bytes) {}

  /// At most 56 bits between two calls of flush().
  void put(std::uint64_t bits, unsigned count) noexcept {
    held_ |= bits << held_count_;
    held_count_ += count;
  }

  /// Leaves less than 8 bits.
  void flush() noexcept {
    std::uint64_t little = held_;
    if constexpr (std::endian::native == std::endian::big) little = __builtin_bswap64(little);
    std::memcpy(at_, &little, sizeof little);
    at_ += held_count_ / 8;
    held_ >>= held_count_ & ~7U;
    held_count_ &= 7;
  }

  void fill_byte() noexcept {
    held_count_ = (held_count_ + 7) & ~7U;
    flush();
  }

  /// Makes room for `more` bits, and for what flush() writes beyond them.
  void reserve_bits(std::size_t more) {
    const std::size_t size = written();
    bytes_->resize(size + more / 8 + 2 * sizeof held_);
    at_ = bytes_->data() + size;
  }
  void trim() { bytes_->resize(written()); }

 private:
  std::size_t written() const noexcept {
    return at_ == nullptr ? bytes_->size() : static_cast<std::size_t>(at_ - bytes_->data());
  }

  std::vector<std::uint8_t>* bytes_;
  std::uint8_t* at_ = nullptr;
  std::uint64_t held_ = 0;
  unsigned held_count_ = 0;
};

std::uint64_t load8(const std::uint8_t* bytes) noexcept {
  std::uint64_t value = 0;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Whether a run of three or more may begin at one of the six bytes from `at` on: eight follow, and
/// one is before.
bool run_near(const std::uint8_t* at) noexcept {
  constexpr std::uint64_t kLow7 = 0x7f7f7f7f7f7f7f7f;
  const std::uint64_t change = load8(at) ^ load8(at - 1);
  const std::uint64_t same = ~(((change & kLow7) + kLow7) | change | kLow7);  // bit 7 of each
  return (same & same >> 8 & same >> 16) != 0;
}

/// How many of the `most` bytes from `at` on are as the one before.
std::size_t run_length(const std::uint8_t* at, std::size_t most) noexcept {
  const std::uint64_t before = 0x0101010101010101 * at[-1];
  std::size_t length = 0;
  if constexpr (std::endian::native == std::endian::little) {
    for (; length + 8 <= most; length += 8) {
      const std::uint64_t change = load8(at + length) ^ before;
      if (change != 0) return length + static_cast<std::size_t>(std::countr_zero(change)) / 8;
    }
  }
  while (length < most && at[length] == at[-1]) ++length;
  return length;
}

/// Calls `literals(first, count)` and `run(length)` for all bytes of [begin, end); runs repeat the
/// byte before them. `all` is where the stream begins.
template <typename Literals, typename Run>
void each_token(std::span<const std::uint8_t> all, std::size_t begin, std::size_t end,
                Literals&& literals, Run&& run) {
  constexpr std::size_t kTogether = 6;
  const std::uint8_t* bytes = all.data();
  std::size_t at = begin;
  if (at == 0 && at < end) literals(at++, 1U);
  while (at < end) {
    if (at + 8 <= end && !run_near(bytes + at)) {
      literals(at, kTogether);
      at += kTogether;
      continue;
    }
    const std::size_t length = run_length(bytes + at, std::min(end - at, kLongestRun));
    if (length >= kShortestRun) {
      run(length);
      at += length;
    } else {
      literals(at++, 1U);
    }
  }
}

using Counts = std::array<std::uint32_t, kSymbols>;

Counts count_symbols(std::span<const std::uint8_t> all, std::size_t begin, std::size_t end) {
  // Four of them: the next byte is often the same, and would wait for its own count.
  std::array<Counts, 4> part{};
  const auto literals = [&](std::size_t first, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i) ++part[i % 4][all[first + i]];
  };
  each_token(all, begin, end, literals,
             [&](std::size_t length) { ++part[0][run_symbol(length).symbol]; });
  Counts total = part[0];
  for (std::size_t i = 0; i < kSymbols; ++i) total[i] += part[1][i] + part[2][i] + part[3][i];
  ++total[kEndOfBlock];
  return total;
}

/// A code and its length.
struct Code {
  std::uint16_t bits = 0;
  std::uint8_t count = 0;
};

template <std::size_t N>
std::array<Code, N> code_of(const std::array<std::uint8_t, N>& length) {
  std::array<std::uint16_t, N> bits{};
  canonical_code(length, bits);
  std::array<Code, N> code;
  for (std::size_t i = 0; i < N; ++i) code[i] = {bits[i], length[i]};
  return code;
}

/// A step of the text that tells the code lengths.
struct LengthStep {
  std::uint8_t symbol, extra, extra_bits;
};

std::vector<LengthStep> length_steps(std::span<const std::uint8_t> length) {
  std::vector<LengthStep> steps;
  for (std::size_t i = 0; i < length.size();) {
    std::size_t same = 1;
    while (i + same < length.size() && length[i + same] == length[i]) ++same;
    i += same;
    const std::uint8_t value = length[i - 1];
    if (value != 0) {
      steps.push_back({value, 0, 0});
      --same;
    }
    const std::size_t longest = value == 0 ? 138 : 6;
    for (std::size_t n = 0; same >= 3; same -= n) {
      n = std::min(same, longest);
      const bool many = value == 0 && n > 10;
      const auto extra = static_cast<std::uint8_t>(n - (many ? 11 : 3));
      if (value != 0) steps.push_back({16, extra, 2});
      if (value == 0) steps.push_back(many ? LengthStep{18, extra, 7} : LengthStep{17, extra, 3});
    }
    for (; same > 0; --same) steps.push_back({value, 0, 0});
  }
  return steps;
}

/// The head of a block with codes of its own [RFC1951 3.2.7]. Of distances there is one, 1.
void put_codes(BitWriter& out, std::span<const std::uint8_t> symbol_length, bool last) {
  constexpr unsigned kDynamic = 2;
  std::vector<std::uint8_t> lengths(symbol_length.begin(), symbol_length.end());
  lengths.push_back(1);
  const std::vector<LengthStep> steps = length_steps(lengths);
  std::array<std::uint32_t, kLengthCodeOrder.size()> count{};
  for (const LengthStep& step : steps) ++count[step.symbol];
  std::array<std::uint8_t, kLengthCodeOrder.size()> length{};
  code_lengths(count, kLongestLengthCode, length);
  const auto code = code_of(length);
  std::size_t told = kLengthCodeOrder.size();
  while (told > 4 && length[kLengthCodeOrder[told - 1]] == 0) --told;

  out.put(last ? 1 : 0, 1);
  out.put(kDynamic, 2);
  out.put(symbol_length.size() - kLengthSymbols, 5);
  out.put(0, 5);
  out.put(told - 4, 4);
  out.flush();
  for (std::size_t i = 0; i < told; ++i) {
    out.put(length[kLengthCodeOrder[i]], 3);
    out.flush();
  }
  for (const LengthStep& step : steps) {
    out.put(code[step.symbol].bits, code[step.symbol].count);
    out.put(step.extra, step.extra_bits);
    out.flush();
  }
}

void put_block(BitWriter& to, std::span<const std::uint8_t> all, std::size_t begin, std::size_t end,
               bool last) {
  BitWriter out = to;  // in registers
  const Counts count = count_symbols(all, begin, end);
  std::array<std::uint8_t, kSymbols> length{};
  code_lengths(count, kLongestCode, length);
  const auto code = code_of(length);
  std::size_t used = kSymbols;
  while (used > kLengthSymbols && length[used - 1] == 0) --used;

  constexpr std::size_t kHeadBits = 8192;   // 286 lengths of at most 14 bits, and what is before
  constexpr std::size_t kRunExtraBits = 6;  // behind the symbol of a run, at most
  std::size_t bits = kHeadBits;
  for (std::size_t i = 0; i < kSymbols; ++i) {
    bits += count[i] * (length[i] + (i < kLengthSymbols ? 0 : kRunExtraBits));
  }
  out.reserve_bits(bits);
  put_codes(out, std::span(length).first(used), last);
  static_assert(3 * kLongestCode <= 56);
  const auto literals = [&](std::size_t first, std::size_t number) {
    for (std::size_t i = 0; i < number; ++i) {
      const Code literal = code[all[first + i]];
      out.put(literal.bits, literal.count);
      if (i % 3 == 2 || i + 1 == number) out.flush();
    }
  };
  each_token(all, begin, end, literals, [&](std::size_t run) {
    const RunSymbol symbol = run_symbol(run);
    out.put(code[symbol.symbol].bits, code[symbol.symbol].count);
    out.put(symbol.extra, symbol.extra_bits);
    out.put(0, 1);  // the one distance
    out.flush();
  });
  out.put(code[kEndOfBlock].bits, code[kEndOfBlock].count);
  out.flush();
  to = out;
}

}  // namespace

std::vector<std::uint8_t> run_length_deflated(std::span<const std::uint8_t> bytes, bool last) {
  std::vector<std::uint8_t> result;
  BitWriter out(result);
  std::size_t begin = 0;
  do {
    const std::size_t end = std::min(begin + kBlockBytes, bytes.size());
    put_block(out, bytes, begin, end, last && end == bytes.size());
    begin = end;
  } while (begin < bytes.size());
  out.reserve_bits(64);
  if (!last) out.put(0, 3);  // a stored block: nothing, twice complemented
  out.fill_byte();
  if (!last) {
    out.put(0xffff0000, 32);
    out.flush();
  }
  out.trim();
  return result;
}

}  // namespace tristim::detail
