#pragma once

#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace tristim {

/// What is wrong with `text` as XML of the plain kind that drawings are: elements that nest, quoted
/// attributes, escaped text. Empty where nothing is.
inline std::string xml_complaint(std::string_view text) {
  std::vector<std::string> open;
  const auto bad_entity = [](std::string_view part) {
    for (std::size_t at = part.find('&'); at != part.npos; at = part.find('&', at + 1)) {
      const std::string_view name = part.substr(at, part.find(';', at) - at);
      if (name != "&amp" && name != "&lt" && name != "&gt" && name != "&quot") return true;
    }
    return false;
  };
  while (!text.empty()) {
    const std::size_t tag = text.find('<');
    const std::string_view before = text.substr(0, tag);
    if (bad_entity(before) || before.find('>') != before.npos) {
      return "not escaped: " + std::string(before);
    }
    if (tag == text.npos) break;
    if (open.empty() && before.find_first_not_of('\n') != before.npos) return "text outside";
    const std::size_t end = text.find('>', tag);
    if (end == text.npos) return "a tag without end";
    std::string_view inside = text.substr(tag + 1, end - tag - 1);
    if (inside.find('<') != inside.npos || bad_entity(inside)) return "bad tag";
    text.remove_prefix(end + 1);
    if (inside.starts_with('/')) {
      if (open.empty() || open.back() != inside.substr(1)) return "closes " + std::string(inside);
      open.pop_back();
      continue;
    }
    const bool empty = inside.ends_with('/');
    if (empty) inside.remove_suffix(1);
    std::size_t quotes = 0;
    for (const char c : inside) quotes += c == '"' ? 1U : 0U;
    if (quotes % 2 != 0) return "quotes of " + std::string(inside);
    if (!empty) open.emplace_back(inside.substr(0, inside.find(' ')));
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

/// How often `part` occurs in `text`.
inline std::size_t count_of(std::string_view text, std::string_view part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++count;
  return count;
}

}  // namespace tristim
