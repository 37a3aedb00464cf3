#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace tristim::detail {

/// Walks over the lines of a text of numbers, those without anything but blanks left out. Holds no
/// copy: the text of a large cube is large enough.
class TextLines {
 public:
  /// `bytes` and `file`, which is for messages, outlive this. Lines that begin with `comment` are
  /// left out; '\0': none are.
  TextLines(std::string_view bytes, const std::string& file, char comment = '#');

  /// Goes to the next line; false at the end of the text.
  bool next();
  /// As next(), or throws "the file ends early".
  void need();
  /// Steps back, so that next() finds the same line again.
  void again() noexcept { held_ = true; }

  /// What is left of the line, without blanks around it.
  std::string_view rest() const noexcept { return rest_; }
  /// The bytes behind the line.
  std::size_t bytes_left() const noexcept { return bytes_.size(); }

  /// The next word of the line; throws where there is none.
  std::string_view take_word();
  /// The next word as a finite number of float range, and the shortest way to a float. Throws where
  /// it is none.
  float take_float();
  /// The same with the digits of a double.
  double take_double();
  /// The next word as an integer from `least` to `most`; `what` is for messages.
  int take_integer(int least, int most, std::string_view what);
  /// Throws where something is left of the line.
  void end_line() const;

  /// Throws, before memory is asked for, where what is left of the text cannot hold so many
  /// numbers, of a digit and a separator each.
  void promise(std::size_t numbers) const;

  /// Throws Error (kContent) "<file>, row <number>: <wrong>; <remedy>".
  [[noreturn]] void fail(std::string_view wrong, std::string_view remedy = {}) const;

 private:
  std::string_view bytes_;
  const std::string& file_;
  char comment_;
  std::string_view line_;
  std::string_view rest_;
  int number_ = 0;
  bool held_ = false;
};

/// The finite float that all of `word` is, rounded once; what is too small for one is 0. Nothing
/// for other texts.
std::optional<float> finite_float(std::string_view word) noexcept;

/// Appends the shortest decimal text that reads back as the same float, whatever the locale.
void append_float(std::string& text, float value);

/// Appends "r g b\n".
void append_row(std::string& text, const float* rgb);

/// Text of one line: control characters become blanks, '"' becomes "'".
std::string one_line(std::string_view text);

/// The same as the text of an XML element.
std::string xml_text(std::string_view text);

}  // namespace tristim::detail
