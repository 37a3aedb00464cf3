#include "lib/dither/half_way.h"

#include <cmath>
#include <cstddef>
#include <limits>

namespace tristim::detail {

std::vector<float> half_way_points(const std::vector<float>& light) {
  std::vector<float> points;
  for (std::size_t i = 1; i < light.size(); ++i) {
    const auto middle = static_cast<float>((double{light[i - 1]} + double{light[i]}) / 2);
    points.push_back(std::nextafter(middle, std::numeric_limits<float>::infinity()));
  }
  return points;
}

}  // namespace tristim::detail
