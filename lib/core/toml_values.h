#pragma once

#include <string>
#include <string_view>

#include "lib/core/toml.h"
#include "tristim/core/find.h"

namespace tristim::detail {

/// A member of `list` named by the string at `key`; `fallback` where the key is absent.
template <typename List, typename Item>
Item choice(const TomlTable& table, std::string_view key, const List& list, Item fallback) {
  const auto name = table.string(key);
  if (!name) return fallback;
  if (const auto* item = find_by_name(list, *name)) return *item;
  table.fail(key, "unknown " + std::string(key) + " '" + *name + "'", name_hint(list, *name));
}

/// The number at `key`, or `fallback`; refuses what is not in [low, high], which `range` puts into
/// words.
double number_in(const TomlTable& table, std::string_view key, double fallback, double low,
                 double high, std::string_view range);

inline constexpr double kTiny = 1e-12;  // open ends of ranges

}  // namespace tristim::detail
