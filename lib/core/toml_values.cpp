#include "lib/core/toml_values.h"

#include "tristim/core/text.h"

namespace tristim::detail {

double number_in(const TomlTable& table, std::string_view key, double fallback, double low,
                 double high, std::string_view range) {
  const double value = table.number(key).value_or(fallback);
  if (value >= low && value <= high) return value;
  table.fail(key, std::string(key) + " = " + shortest(value) + " is out of range",
             "give a number " + std::string(range));
}

}  // namespace tristim::detail
