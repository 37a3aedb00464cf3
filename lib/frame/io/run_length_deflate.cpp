#include "lib/frame/io/run_length_deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "lib/frame/io/byte_runs.h"
#include "lib/frame/io/huffman.h"

namespace tristim::detail {
namespace {

// [RFC1951] 3.2.5 to 3.2.7.
constexpr std::size_t kEndOfBlock = 256;
constexpr std::size_t kLengthSymbols = 257;  // the first of them
constexpr std::size_t kSymbols = 286;
constexpr std::size_t kShortestRun = 3;  // that has a symbol
constexpr int kLongestCode = 14;         // of 15 that there may be: four of them fit into 56 bits
constexpr int kLongestLengthCode = 7;
constexpr std::array<std::uint8_t, 19> kLengthCodeOrder = {16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                           11, 4,  12, 3, 13, 2, 14, 1, 15};

/// The symbol of a run's length and the bits behind it.
struct RunSymbol {
  std::uint16_t symbol;
  std::uint8_t extra_bits;
  std::uint8_t extra;
};

RunSymbol run_symbol(std::size_t length) noexcept {
  if (length == ByteRuns::kLongest) return {kSymbols - 1, 0, 0};
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

using Counts = std::array<std::uint32_t, kSymbols>;

/// Of literals, runs and the end of the block.
Counts count_symbols(std::span<const std::uint8_t> block, std::span<const ByteRun> runs) {
  // Four of them: the next byte is often the same, and would wait for its own count.
  std::array<Counts, 4> part{};
  std::size_t i = 0;
  for (; i + 8 <= block.size(); i += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, block.data() + i, sizeof eight);
    for (unsigned byte = 0; byte < 8; ++byte) ++part[byte % 4][eight >> 8 * byte & 0xff];
  }
  for (; i < block.size(); ++i) ++part[0][block[i]];
  Counts total = part[0];
  for (std::size_t k = 0; k < kSymbols; ++k) total[k] += part[1][k] + part[2][k] + part[3][k];
  for (const ByteRun& run : runs) {
    total[block[run.begin]] -= run.length;
    ++total[run_symbol(run.length).symbol];
  }
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

using Codes = std::array<Code, kSymbols>;

void put_literals(BitWriter& out, const Codes& code, std::span<const std::uint8_t> bytes) {
  static_assert(4 * kLongestCode <= 56);
  std::size_t i = 0;
  for (; i + 4 <= bytes.size(); i += 4) {
    for (std::size_t k = 0; k < 4; ++k) out.put(code[bytes[i + k]].bits, code[bytes[i + k]].count);
    out.flush();
  }
  for (; i < bytes.size(); ++i) out.put(code[bytes[i]].bits, code[bytes[i]].count);
  out.flush();
}

void put_run(BitWriter& out, const Codes& code, std::size_t length) {
  const RunSymbol symbol = run_symbol(length);
  out.put(code[symbol.symbol].bits, code[symbol.symbol].count);
  out.put(symbol.extra, symbol.extra_bits);
  out.put(0, 1);  // the one distance
  out.flush();
}

void put_block(BitWriter& to, std::span<const std::uint8_t> block, std::span<const ByteRun> runs,
               bool last) {
  BitWriter out = to;  // in registers
  const Counts count = count_symbols(block, runs);
  std::array<std::uint8_t, kSymbols> length{};
  code_lengths(count, kLongestCode, length);
  const Codes code = code_of(length);
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
  std::size_t at = 0;
  for (const ByteRun& run : runs) {
    put_literals(out, code, block.subspan(at, run.begin - at));
    put_run(out, code, run.length);
    at = run.begin + run.length;
  }
  put_literals(out, code, block.subspan(at));
  out.put(code[kEndOfBlock].bits, code[kEndOfBlock].count);
  out.flush();
  to = out;
}

}  // namespace

std::vector<std::uint8_t> run_length_deflated(std::span<const std::uint8_t> bytes, bool last) {
  std::vector<std::uint8_t> result;
  BitWriter out(result);
  ByteRuns runs;
  std::size_t begin = 0;
  do {
    const std::size_t end = std::min(begin + ByteRuns::kBlockBytes, bytes.size());
    put_block(out, bytes.subspan(begin, end - begin), runs.find(bytes, begin, end),
              last && end == bytes.size());
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
