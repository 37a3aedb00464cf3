#include "lib/lut/io/ocio_text.h"

#include "tristim/core/text.h"

namespace tristim::detail {

std::string yaml_text(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return out + "\"";
}

std::string ocio_matrix(const Eigen::Matrix3d& m, const Eigen::Vector3d& offset) {
  std::string text = "!<MatrixTransform> {matrix: [";
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) text += shortest(m(row, column)) + ", ";
    text += "0, ";
  }
  text += "0, 0, 0, 1], offset: [";
  for (int row = 0; row < 3; ++row) text += shortest(offset(row)) + ", ";
  return text + "0]}";
}

std::string ocio_line(const Eigen::Vector3d& scale, const Eigen::Vector3d& offset) {
  return ocio_matrix(scale.asDiagonal(), offset);
}
std::string ocio_line(double scale, double offset) {
  return ocio_line(Eigen::Vector3d::Constant(scale), Eigen::Vector3d::Constant(offset));
}

std::string ocio_clip() {
  return "!<RangeTransform> {min_in_value: 0, max_in_value: 1, min_out_value: 0, max_out_value: 1}";
}

std::string ocio_power(double exponent, bool inverse) {
  return "!<ExponentTransform> {value: " + shortest(exponent) +
         (inverse ? ", direction: inverse}" : "}");
}

std::string ocio_table(const std::string& file) {
  return "!<FileTransform> {src: " + yaml_text(file) + ", interpolation: linear}";
}

}  // namespace tristim::detail
