#include "lib/pipeline/channel_planes.h"

#include <algorithm>
#include <cstddef>
#include <vector>

#include "lib/dither/planes.h"

namespace tristim::detail {

StageCounts split_rows(ImageView<float> rgb, const RowLead& lead) {
  const auto width = static_cast<std::size_t>(rgb.width);
  std::vector<float> pixels(3 * width);
  StageCounts counts;
  for (int y = 0; y < rgb.height; ++y) {
    const std::span<float> row = rgb.row(y);
    std::ranges::copy(row, pixels.begin());
    counts += lead.split(pixels, {row.data(), row.data() + width, row.data() + 2 * width});
  }
  return counts;
}

void join_rows(ImageView<std::uint16_t> rgb) {
  const auto width = static_cast<std::size_t>(rgb.width);
  std::vector<std::uint16_t> planes(3 * width);
  for (int y = 0; y < rgb.height; ++y) {
    const std::span<std::uint16_t> row = rgb.row(y);
    std::ranges::copy(row, planes.begin());
    join_row({planes.data(), planes.data() + width, planes.data() + 2 * width}, row);
  }
}

}  // namespace tristim::detail
