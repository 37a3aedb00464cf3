#include "tristim/measure/pictures.h"

#include <stdexcept>

#include "lib/core/parallel.h"
#include "tristim/color/primaries.h"

namespace tristim {

LuminanceMap luminance(ImageView<const float> picture) {
  if (picture.channels != 3) throw std::invalid_argument("luminance needs three channels");
  const Eigen::Vector3d weights = xyz_from_rgb(Primaries{}).row(1);
  LuminanceMap map{picture.width, picture.height, {}};
  map.value.resize(static_cast<std::size_t>(picture.width) *
                   static_cast<std::size_t>(picture.height));
  detail::parallel_for_rows(picture.height, 0, [&](int y) {
    const float* pixel = picture.row(y).data();
    for (int x = 0; x < picture.width; ++x, pixel += 3) {
      map.value[map.index(x, y)] =
          weights[0] * pixel[0] + weights[1] * pixel[1] + weights[2] * pixel[2];
    }
  });
  return map;
}

}  // namespace tristim
