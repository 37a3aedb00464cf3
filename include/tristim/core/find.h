#pragma once

#include <cstddef>
#include <iterator>
#include <string>
#include <string_view>

namespace tristim {

/// Whether two names are one: case, '_' and '-' do not count, so NTSC_1953 is ntsc1953.
bool same_name(std::string_view a, std::string_view b) noexcept;

/// Edit distance of two names [Levenshtein66], counted after the folding of same_name.
std::size_t name_distance(std::string_view a, std::string_view b);

/// How many characters two names begin with in common, after the folding of same_name.
std::size_t common_start(std::string_view a, std::string_view b);

/// Whether `part`, of two characters or more after the folding of same_name, occurs in `name`.
bool name_contains(std::string_view name, std::string_view part);

/// The member of `list` (anything with a `name`) called `name`, or nullptr.
template <typename List>
auto find_by_name(const List& list, std::string_view name) noexcept
    -> decltype(&*std::begin(list)) {
  for (const auto& item : list) {
    if (same_name(item.name, name)) return &item;
  }
  return nullptr;
}

/// The names of a list, in its order.
template <typename List>
std::string list_names(const List& list, std::string_view separator = ", ") {
  std::string names;
  for (const auto& item : list) {
    if (!names.empty()) names += separator;
    names += item.name;
  }
  return names;
}

/// What to do about an unknown name: "did you mean X?" where one of `list` is near (of equally near
/// ones that with the longest start in common), or is the only one that contains it; else the
/// choices.
template <typename List>
std::string name_hint(const List& list, std::string_view name) {
  std::string_view nearest;
  std::string_view containing;
  int containing_count = 0;
  std::size_t least = name.size() / 2 + 1;  // more than half of the letters wrong is no hint
  for (const auto& item : list) {
    const std::size_t distance = name_distance(item.name, name);
    const bool tie = !nearest.empty() && distance == least;
    if (distance < least || (tie && common_start(item.name, name) > common_start(nearest, name))) {
      least = distance;
      nearest = item.name;
    }
    if (name_contains(item.name, name)) {
      containing = item.name;
      ++containing_count;
    }
  }
  if (containing_count == 1) nearest = containing;
  if (nearest.empty()) return "use one of: " + list_names(list);
  return "did you mean " + std::string(nearest) + "?";
}

}  // namespace tristim
