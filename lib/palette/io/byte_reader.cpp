#include "lib/palette/io/byte_reader.h"

#include <bit>

#include "tristim/core/error.h"

namespace tristim::detail {
namespace {

constexpr char32_t kUnknown = 0xfffd;

bool is_high_surrogate(char32_t c) { return c >= 0xd800 && c < 0xdc00; }
bool is_low_surrogate(char32_t c) { return c >= 0xdc00 && c < 0xe000; }

void put_utf8(std::string& text, char32_t c) {
  const auto put = [&](char32_t byte) { text += static_cast<char>(byte); };
  if (c < 0x80) return put(c);
  if (c < 0x800) {
    put(0xc0 | c >> 6);
  } else if (c < 0x10000) {
    put(0xe0 | c >> 12);
    put(0x80 | (c >> 6 & 0x3f));
  } else {
    put(0xf0 | c >> 18);
    put(0x80 | (c >> 12 & 0x3f));
    put(0x80 | (c >> 6 & 0x3f));
  }
  put(0x80 | (c & 0x3f));
}

/// Takes a character off a text of UTF-8.
char32_t take_utf8(std::string_view& text) {
  const auto first = static_cast<unsigned char>(text[0]);
  const std::size_t length = first < 0x80 ? 1 : first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  char32_t c = length == 1 ? first : first & (0xffu >> (length + 1));
  bool good = first < 0x80 || (first >= 0xc2 && first <= 0xf4);
  std::size_t taken = 1;
  for (; good && taken < length; ++taken) {
    const unsigned char next = taken < text.size() ? static_cast<unsigned char>(text[taken]) : 0;
    good = (next & 0xc0) == 0x80;
    if (!good) break;
    c = c << 6 | (next & 0x3f);
  }
  text.remove_prefix(taken);
  constexpr char32_t kLeast[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool allowed =
      c >= kLeast[length] && c <= 0x10ffff && !is_high_surrogate(c) && !is_low_surrogate(c);
  return good && allowed ? c : kUnknown;
}

}  // namespace

void ByteReader::fail(std::string_view wrong, std::string_view remedy) const {
  throw Error(ErrorKind::kContent, *file_ + ", byte " + std::to_string(at_), wrong, remedy);
}

std::string_view ByteReader::text(std::size_t count) {
  if (count > left()) fail("the file ends early", "write or copy it again");
  const std::string_view part = bytes_.substr(at_, count);
  at_ += count;
  return part;
}

std::uint32_t ByteReader::big(std::size_t count) {
  std::uint32_t value = 0;
  for (const char c : text(count)) value = value << 8 | static_cast<unsigned char>(c);
  return value;
}

float ByteReader::big_float() { return std::bit_cast<float>(big(4)); }

std::uint16_t ByteReader::little16() {
  const std::uint32_t value = big(2);
  return static_cast<std::uint16_t>(value >> 8 | value << 8);
}

std::uint32_t ByteReader::little32() {
  const std::uint32_t low = little16();
  return low | std::uint32_t{little16()} << 16;
}

std::string ByteReader::utf16(std::size_t count) {
  if (count > left() / 2) fail("a name is longer than the file", "write or copy it again");
  std::string name;
  bool ended = false;
  for (std::size_t i = 0; i < count; ++i) {
    char32_t c = big16();
    if (is_high_surrogate(c) && i + 1 < count) {
      const char32_t low = big16();
      ++i;
      c = is_low_surrogate(low) ? 0x10000 + ((c - 0xd800) << 10) + (low - 0xdc00) : kUnknown;
    } else if (is_high_surrogate(c) || is_low_surrogate(c)) {
      c = kUnknown;
    }
    ended = ended || c == 0;
    if (!ended) put_utf8(name, c);
  }
  return name;
}

void put_big(std::string& bytes, std::uint32_t value, int count) {
  for (int i = count - 1; i >= 0; --i) bytes += static_cast<char>(value >> 8 * i);
}

void put_little(std::string& bytes, std::uint32_t value, int count) {
  for (int i = 0; i < count; ++i) bytes += static_cast<char>(value >> 8 * i);
}

void put_big_float(std::string& bytes, float value) {
  put_big(bytes, std::bit_cast<std::uint32_t>(value), 4);
}

std::u16string utf16_of(std::string_view utf8) {
  std::u16string text;
  while (!utf8.empty()) {
    const char32_t c = take_utf8(utf8);
    if (c >= 0x10000) {
      text += static_cast<char16_t>(0xd800 + ((c - 0x10000) >> 10));
      text += static_cast<char16_t>(0xdc00 + (c & 0x3ff));
    } else {
      text += static_cast<char16_t>(c);
    }
  }
  return text + u'\0';
}

void put_utf16(std::string& bytes, const std::u16string& text) {
  for (const char16_t unit : text) put_big(bytes, unit, 2);
}

}  // namespace tristim::detail
