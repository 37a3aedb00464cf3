#include "lib/color/matrix_text.h"

#include "tristim/core/text.h"

namespace tristim::detail {

std::string matrix_text(const Eigen::Matrix3d& matrix) {
  std::string text;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) text += (j > 0 ? " " : i > 0 ? " / " : "") + shortest(matrix(i, j));
  }
  return text;
}

std::string white_text(Chromaticity white) {
  for (const WhitePoint& known : kWhitePoints) {
    if (known.chromaticity == white) return std::string(known.name);
  }
  return shortest(white.x) + " " + shortest(white.y);
}

}  // namespace tristim::detail
