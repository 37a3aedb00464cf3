#include "tristim/core/find.h"

#include <algorithm>
#include <vector>

namespace tristim {
namespace {

std::string fold(std::string_view name) {
  std::string folded;
  for (char c : name) {
    if (c == '_' || c == '-') continue;
    folded += (c >= 'A' && c <= 'Z') ? static_cast<char>(c + 32) : c;
  }
  return folded;
}

}  // namespace

bool same_name(std::string_view a, std::string_view b) noexcept {
  const auto skip = [](std::string_view text, std::size_t i) {
    while (i < text.size() && (text[i] == '_' || text[i] == '-')) ++i;
    return i;
  };
  const auto lower = [](char c) { return (c >= 'A' && c <= 'Z') ? static_cast<char>(c + 32) : c; };
  std::size_t i = skip(a, 0);
  std::size_t j = skip(b, 0);
  while (i < a.size() && j < b.size()) {
    if (lower(a[i]) != lower(b[j])) return false;
    i = skip(a, i + 1);
    j = skip(b, j + 1);
  }
  return i == a.size() && j == b.size();
}

std::size_t name_distance(std::string_view a, std::string_view b) {
  const std::string x = fold(a);
  const std::string y = fold(b);
  std::vector<std::size_t> row(y.size() + 1);
  for (std::size_t j = 0; j <= y.size(); ++j) row[j] = j;
  for (std::size_t i = 1; i <= x.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= y.size(); ++j) {
      const std::size_t substituted = diagonal + (x[i - 1] == y[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substituted});
    }
  }
  return row[y.size()];
}

std::size_t common_start(std::string_view a, std::string_view b) {
  const std::string x = fold(a);
  const std::string y = fold(b);
  const auto end = std::mismatch(x.begin(), x.end(), y.begin(), y.end()).first;
  return static_cast<std::size_t>(end - x.begin());
}

bool name_contains(std::string_view name, std::string_view part) {
  const std::string folded = fold(part);
  return folded.size() >= 2 && fold(name).find(folded) != std::string::npos;
}

}  // namespace tristim
