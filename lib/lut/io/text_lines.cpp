#include "lib/lut/io/text_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>

#include "tristim/core/error.h"
#include "tristim/core/text.h"

namespace tristim::detail {
namespace {

constexpr std::string_view kBlanks = " \t\r\v\f";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

std::string quoted(std::string_view word) {
  constexpr std::size_t kMost = 40;  // of a word of a damaged file
  return "'" + std::string(word.substr(0, kMost)) + (word.size() > kMost ? "...'" : "'");
}

template <typename T>
std::optional<T> finite(std::string_view word) noexcept {
  if (word.size() > 1 && word[0] == '+' && word[1] != '-') word.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size()) return {};
  if (error == std::errc::result_out_of_range) {
    // too small is 0; too large has no float
    const auto wide = parse_number(word);
    if (wide && std::fabs(*wide) < 1) return T{};
    return {};
  }
  if (error != std::errc() || !std::isfinite(value)) return {};
  return value;
}

}  // namespace

TextLines::TextLines(std::string_view bytes, const std::string& file, char comment)
    : bytes_(without_utf8_mark(bytes)), file_(file), comment_(comment) {}

bool TextLines::next() {
  if (held_) {
    held_ = false;
    rest_ = line_;
    return true;
  }
  while (!bytes_.empty()) {
    const std::size_t end = std::min(bytes_.find('\n'), bytes_.size());
    line_ = trimmed(bytes_.substr(0, end));
    bytes_.remove_prefix(std::min(end + 1, bytes_.size()));
    ++number_;
    if (line_.empty() || (comment_ != '\0' && line_[0] == comment_)) continue;
    rest_ = line_;
    return true;
  }
  rest_ = {};
  return false;
}

void TextLines::need() {
  if (!next()) fail("the file ends early", "write or copy it again");
}

std::string_view TextLines::take_word() {
  if (rest_.empty()) fail("a number is missing");
  const std::string_view word = rest_.substr(0, rest_.find_first_of(kBlanks));
  rest_ = trimmed(rest_.substr(word.size()));
  return word;
}

float TextLines::take_float() {
  const std::string_view word = take_word();
  const auto value = finite<float>(word);
  if (!value) fail(quoted(word) + " is no finite number");
  return *value;
}

double TextLines::take_double() {
  const std::string_view word = take_word();
  const auto value = finite<double>(word);
  if (!value) fail(quoted(word) + " is no finite number");
  return *value;
}

int TextLines::take_integer(int least, int most, std::string_view what) {
  const std::string_view word = rest_.empty() ? rest_ : take_word();
  const auto value = parse_integer(word);
  if (!value || *value < least || *value > most) {
    fail(quoted(word) + " is no " + std::string(what),
         "it is an integer from " + std::to_string(least) + " to " + std::to_string(most));
  }
  return static_cast<int>(*value);
}

void TextLines::end_line() const {
  if (!rest_.empty()) fail(quoted(rest_) + " is one thing too many");
}

void TextLines::promise(std::size_t numbers) const {
  // of the last number no separator is needed
  const std::size_t bytes = bytes_.size() + (held_ ? line_.size() + 1 : 0);
  if (numbers > bytes / 2 + 1) {
    fail("promises " + std::to_string(numbers) + " numbers, but only " + std::to_string(bytes) +
             " bytes are there",
         "write or copy it again");
  }
}

void TextLines::fail(std::string_view wrong, std::string_view remedy) const {
  throw Error(ErrorKind::kContent, file_ + ", row " + std::to_string(std::max(number_, 1)), wrong,
              remedy);
}

std::optional<float> finite_float(std::string_view word) noexcept { return finite<float>(word); }

void append_float(std::string& text, float value) {
  std::array<char, 24> digits{};
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

void append_row(std::string& text, const float* rgb) {
  for (int c = 0; c < 3; ++c) {
    append_float(text, rgb[c]);
    text += c < 2 ? ' ' : '\n';
  }
}

std::string one_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ' || c == 0x7f) c = ' ';
    if (c == '"') c = '\'';
  }
  return std::string(trimmed(line));
}

std::string xml_text(std::string_view text) {
  std::string out;
  for (const char c : one_line(text)) {
    if (c == '<') {
      out += "&lt;";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '>') {
      out += "&gt;";
    } else {
      out += c;
    }
  }
  return out;
}

}  // namespace tristim::detail
