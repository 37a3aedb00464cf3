#include "lib/render/io/obj_lines.h"

#include <algorithm>

namespace tristim::detail {

// A line that ends in a backslash goes on in the next one; the parser wants no bytes 0.
ObjLines::int_type ObjLines::underflow() {
  if (rest_.empty()) return traits_type::eof();
  given_.clear();
  line_ = rest_;
  bool goes_on = true;
  while (goes_on && !rest_.empty()) {
    const std::size_t end = std::min(rest_.find('\n'), rest_.size());
    std::string_view part = rest_.substr(0, end);
    rest_.remove_prefix(std::min(end + 1, rest_.size()));
    if (part.ends_with('\r')) part.remove_suffix(1);
    part = part.substr(0, part.find(" #"));
    goes_on = part.ends_with('\\');
    if (goes_on) part.remove_suffix(1);
    given_ += part;
    given_ += goes_on ? " " : "\n";
    ++number_;
  }
  if (goes_on) given_ += '\n';
  std::replace(given_.begin(), given_.end(), '\0', ' ');
  std::replace(given_.begin(), given_.end(), '\r', ' ');
  line_ = std::string_view(given_).substr(0, given_.size() - 1);
  setg(given_.data(), given_.data(), given_.data() + given_.size());
  return traits_type::to_int_type(given_[0]);
}

}  // namespace tristim::detail
