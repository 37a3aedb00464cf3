#include "tools/spot_picture.h"

#include <stdexcept>

#include "tristim/core/error.h"
#include "tristim/image/flatten.h"
#include "tristim/image/io/read.h"
#include "tristim/image/memory.h"

namespace tristim::tools {

SpotPicture read_spot_picture(const std::string& path) {
  constexpr int kMostSide = 1024;
  const auto picture = flatten(open_picture(path), {}, nullptr);
  const PictureInfo& info = picture->info();
  if (info.width > kMostSide || info.height > kMostSide) {
    throw Error(ErrorKind::kContent, path,
                "is " + std::to_string(info.width) + "x" + std::to_string(info.height) +
                    " pixels, more than a cell needs",
                "give a picture of one cell, 1024x1024 at most");
  }
  const auto weight = xyz_from_rgb(info.primaries).row(1).eval();
  SpotPicture spot{.name = path, .width = info.width, .height = info.height};
  Image rows(info.width, 1, 3);
  for (int y = 0; y < info.height; ++y) {
    picture->read(rows.view());
    const std::span<const float> row = rows.view().row(0);
    for (std::size_t x = 0; x + 2 < row.size(); x += 3) {
      const Eigen::Vector3d rgb(row[x], row[x + 1], row[x + 2]);
      spot.value.push_back(static_cast<float>(weight * rgb));
    }
  }
  try {
    check_spot(spot);
  } catch (const std::invalid_argument&) {
    throw Error(ErrorKind::kContent, path, "is the same everywhere: no dot can grow",
                "give a picture with light and dark places");
  }
  return spot;
}

}  // namespace tristim::tools
