#include "lib/dither/step_table.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "lib/core/instruction_set.h"

namespace tristim::detail {
namespace {

constexpr int kCoarsestShift = 16;  // 1/128 octave: about one threshold of an 8-bit curve
constexpr int kFinestShift = 8;

std::int32_t bits_of(float value) noexcept { return std::bit_cast<std::int32_t>(value); }

// Empty where two thresholds share a stretch.
std::vector<std::uint32_t> entries(std::span<const float> threshold, const StepTable& table) {
  const std::uint32_t stretch = std::uint32_t{1} << table.shift;
  std::vector<std::uint32_t> entry;
  std::size_t count = 0;
  for (std::int32_t bits = table.first; bits <= table.last;
       bits += static_cast<std::int32_t>(stretch)) {
    const auto reached = [&](std::int32_t end) {
      return count < threshold.size() && bits_of(threshold[count]) < end;
    };
    std::uint32_t sum = static_cast<std::uint32_t>(count) << table.shift;
    if (reached(bits + static_cast<std::int32_t>(stretch))) {
      sum += stretch - static_cast<std::uint32_t>(bits_of(threshold[count]) - bits);
      ++count;
      if (reached(bits + static_cast<std::int32_t>(stretch))) return {};
    }
    entry.push_back(sum);
  }
  return entry;
}

bool set_up(std::span<const float> threshold, int shift, std::size_t most_entries,
            StepTable& table) {
  const std::int32_t stretch = std::int32_t{1} << shift;
  table.shift = shift;
  table.first = (bits_of(threshold.front()) & -stretch) - stretch;
  table.last = bits_of(threshold.back()) | (stretch - 1);
  const auto stretches = (std::int64_t{table.last} - table.first + 1) >> shift;
  const bool fits = stretches <= static_cast<std::int64_t>(most_entries) &&
                    threshold.size() < std::size_t{1} << (32 - shift);
  if (table.first < 0 || !fits) return false;
  table.entry = entries(threshold, table);
  return !table.entry.empty();
}

void scalar_row(const StepTable& table, const float* in, std::size_t count, std::uint16_t* out) {
  for (std::size_t i = 0; i < count; ++i) out[i] = table(in[i]);
}

}  // namespace

std::uint16_t StepTable::operator()(float value) const noexcept {
  const std::int32_t bits = std::clamp(value > 0 ? bits_of(value) : 0, first, last);
  const auto stretch = static_cast<std::size_t>((bits - first) >> shift);
  const std::uint32_t low = static_cast<std::uint32_t>(bits) & ((std::uint32_t{1} << shift) - 1);
  return static_cast<std::uint16_t>(codes[(entry[stretch] + low) >> shift]);
}

std::optional<StepTable> step_table(std::span<const float> threshold,
                                    std::span<const std::uint16_t> code, std::size_t most_entries) {
  const bool usable =
      !threshold.empty() && threshold.front() > 0 && std::isfinite(threshold.back());
  if (!usable) return std::nullopt;
  StepTable table;
  table.codes.assign(code.begin(), code.end());
  table.codes_count = true;
  for (std::size_t i = 0; i < code.size(); ++i) {
    table.codes_count = table.codes_count && code[i] == code[0] + i;
  }
  for (int shift = kCoarsestShift; shift >= kFinestShift; --shift) {
    if (!set_up(threshold, shift, most_entries, table)) continue;
    table.guess = guess_thresholds(threshold);
    return table;
  }
  return std::nullopt;
}

const StepKernel& scalar_step_kernel() noexcept {
  static constexpr StepKernel kScalar{"scalar", scalar_row};
  return kScalar;
}

const StepKernel& step_kernel() {
  static const StepKernel* const simd = chosen_instruction_set(simd_step_kernels());
  return simd == nullptr ? scalar_step_kernel() : *simd;
}

}  // namespace tristim::detail
