#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace tristim::detail {

/// Takes numbers off the bytes of a file. All throw Error (kContent) "<file>, byte 70: ...".
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& file) : bytes_(bytes), file_(&file) {}

  std::size_t position() const noexcept { return at_; }
  std::size_t left() const noexcept { return bytes_.size() - at_; }

  std::string_view text(std::size_t count);
  void skip(std::size_t count) { (void)text(count); }

  std::uint8_t byte() { return static_cast<std::uint8_t>(text(1)[0]); }
  std::uint16_t big16() { return static_cast<std::uint16_t>(big(2)); }
  std::uint32_t big32() { return big(4); }
  float big_float();
  std::uint16_t little16();
  std::uint32_t little32();

  /// A name of `count` units of UTF-16 with the high byte first, to its first zero, as UTF-8. What
  /// is no text becomes U+FFFD.
  std::string utf16(std::size_t count);

  [[noreturn]] void fail(std::string_view wrong, std::string_view remedy = {}) const;

 private:
  std::uint32_t big(std::size_t count);

  std::string_view bytes_;
  const std::string* file_;  // outlives this
  std::size_t at_ = 0;
};

/// Appends numbers with the high or the low byte first.
void put_big(std::string& bytes, std::uint32_t value, int count);
void put_little(std::string& bytes, std::uint32_t value, int count);
void put_big_float(std::string& bytes, float value);

/// UTF-8 as units of UTF-16, with a zero at the end. What is no text becomes U+FFFD.
std::u16string utf16_of(std::string_view utf8);

/// Its units, the high byte first.
void put_utf16(std::string& bytes, const std::u16string& text);

}  // namespace tristim::detail
