#include "lib/device/read_display.h"

#include <algorithm>
#include <functional>

#include "tristim/core/text.h"

namespace tristim::detail {

double number_in(const TomlTable& table, std::string_view key, double fallback, double low,
                 double high, std::string_view range) {
  const double value = table.number(key).value_or(fallback);
  if (value >= low && value <= high) return value;
  table.fail(key, std::string(key) + " = " + shortest(value) + " is out of range",
             "give a number " + std::string(range));
}

bool strictly_ascending(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

}  // namespace tristim::detail
