#include "lib/color/name_text.h"

namespace tristim::detail {

std::string normal_name(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const bool space = c == ' ' || c == '\t' || c == '\r' || c == '\n';
    if (space && (result.empty() || result.back() == ' ')) continue;
    result += space ? ' ' : (c >= 'A' && c <= 'Z') ? static_cast<char>(c + 32) : c;
  }
  while (result.ends_with(' ')) result.pop_back();
  for (std::size_t at = 0; (at = result.find("grey", at)) != std::string::npos; ++at) {
    result[at + 2] = 'a';
  }
  return result;
}

}  // namespace tristim::detail
