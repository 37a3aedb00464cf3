#include "tristim/palette/histogram_text.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim {
namespace {

constexpr std::string_view kFirstLine = "tristim histogram 1";
// So that sums of codes times counts stay within 64 bits.
constexpr std::uint64_t kMostPixels = std::uint64_t{1} << 46;

[[noreturn]] void refuse(std::string_view name, int line, const std::string& wrong) {
  throw Error(ErrorKind::kContent, std::string(name) + ":" + std::to_string(line), wrong,
              "write it with palette build --histogram-out");
}

template <typename Number>
std::optional<Number> number(std::string_view text, int base) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, base);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<Color8> color_of(std::string_view hex) {
  if (hex.size() != 6 && hex.size() != 8) return std::nullopt;
  const auto digits = number<std::uint32_t>(hex, 16);
  if (!digits) return std::nullopt;
  const std::uint32_t rgba = hex.size() == 8 ? *digits : *digits << 8 | 255;
  return Color8{static_cast<std::uint8_t>(rgba >> 24), static_cast<std::uint8_t>(rgba >> 16 & 255),
                static_cast<std::uint8_t>(rgba >> 8 & 255), static_cast<std::uint8_t>(rgba & 255)};
}

// The text up to the next end of line, which is taken from `rest`.
std::string_view next_line(std::string_view& rest) {
  const std::size_t end = std::min(rest.find('\n'), rest.size());
  std::string_view line = rest.substr(0, end);
  rest.remove_prefix(std::min(end + 1, rest.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

std::string histogram_text(const Histogram& histogram) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  std::string text(kFirstLine);
  text += '\n';
  for (const auto& [color, count] : histogram.entries()) {
    for (const std::uint8_t code : {color.r, color.g, color.b, color.a}) {
      text += kDigits[code >> 4];
      text += kDigits[code & 15];
    }
    if (color.a == 255) text.resize(text.size() - 2);
    text += ' ' + std::to_string(count) + '\n';
  }
  return text;
}

void merge_histogram_text(std::string_view text, std::string_view name, Histogram& histogram) {
  std::string_view rest = without_utf8_mark(text);
  if (next_line(rest) != kFirstLine) {
    refuse(name, 1, "is no histogram: its first line is not '" + std::string(kFirstLine) + "'");
  }
  Histogram read;
  std::uint64_t pixels = 0;
  for (int line = 2; !rest.empty(); ++line) {
    const std::string_view row = next_line(rest);
    const std::size_t space = std::min(row.find(' '), row.size());
    const auto color = color_of(row.substr(0, space));
    const auto count = number<std::uint64_t>(row.substr(std::min(space + 1, row.size())), 10);
    if (!color || !count || *count == 0) {
      refuse(name, line, "expected a colour and how often it occurs, as in 'ff8000 12'");
    }
    if (*count > kMostPixels || (pixels += *count) > kMostPixels) {
      refuse(name, line, "counts more than " + std::to_string(kMostPixels) + " pixels");
    }
    read.add(*color, *count);
  }
  histogram.merge(read);
}

}  // namespace tristim
