#pragma once

#include <streambuf>
#include <string>
#include <string_view>

namespace tristim::detail {

/// Gives out a text line by line and knows which one was given last: the parser behind it asks for
/// a line, then reports what it found in it.
class ObjLines : public std::streambuf {
 public:
  explicit ObjLines(std::string_view text) : rest_(text) {}

  int number() const noexcept { return number_; }  // from 1
  std::string_view line() const noexcept { return line_; }

 protected:
  int_type underflow() override;

 private:
  std::string_view rest_;
  std::string_view line_;
  std::string given_;
  int number_ = 0;
};

}  // namespace tristim::detail
