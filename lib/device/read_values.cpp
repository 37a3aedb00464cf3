#include <algorithm>
#include <functional>

#include "lib/device/read_display.h"

namespace tristim::detail {

bool strictly_ascending(const std::vector<double>& values) {
  return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

}  // namespace tristim::detail
