#include "lib/lut/io/ocio/library.h"

#include <algorithm>

namespace tristim::detail {

void set_up_library() {
  static const bool done = [] {
    ocio::SetLoggingLevel(ocio::LOGGING_LEVEL_NONE);
    return true;
  }();
  static_cast<void>(done);
}

std::string reason(const std::exception& exception) {
  constexpr std::size_t kMost = 400;
  std::string text = exception.what();
  while (!text.empty() && (text.back() == '\n' || text.back() == '.')) text.pop_back();
  std::ranges::replace(text, '\n', ' ');
  if (text.size() > kMost) text = text.substr(0, kMost) + " ...";
  return text;
}

}  // namespace tristim::detail
