#include <cstddef>
#include <cstdint>

#include "tristim/plot/svg.h"

namespace tristim {
namespace {

// Widths of Helvetica from blank to '~', in thousandths of the font size [AFM].
constexpr std::int16_t kHelvetica[] = {
    278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,  //
    556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,  // 0
    1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,  // @
    667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,  // P
    333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,  // `
    556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584,       // p
};
constexpr int kOther = 556;

bool continues(char c) { return (static_cast<unsigned char>(c) & 0xC0) == 0x80; }

// How many bytes the UTF-8 character at the start of `text` has; 0 where there is none. Overlong
// forms, surrogates and what lies beyond U+10FFFF are none.
std::size_t character_length(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || text.size() < length) return 0;
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return 0;
  }
  const unsigned second = byte(1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool beyond = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return overlong || beyond ? 0 : length;
}

std::string_view escape_of(char c) {
  switch (c) {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    default:
      return static_cast<unsigned char>(c) < 0x20 || c == 0x7F ? "?" : "";
  }
}

}  // namespace

std::string xml_escaped(std::string_view text) {
  std::string out;
  while (!text.empty()) {
    const std::size_t length = character_length(text);
    const std::string_view escape = length == 0 ? "\xEF\xBF\xBD" : escape_of(text.front());
    out += escape.empty() ? text.substr(0, length) : escape;
    text.remove_prefix(length == 0 ? 1 : length);
  }
  return out;
}

double text_width(std::string_view text) noexcept {
  int thousandths = 0;
  for (const char c : text) {
    if (c >= ' ' && c <= '~') {
      thousandths += kHelvetica[static_cast<std::size_t>(c - ' ')];
    } else if (!continues(c)) {
      thousandths += kOther;
    }
  }
  return thousandths / 1000.0;
}

}  // namespace tristim
