#include "tristim/dither/io/matrix_file.h"

#include <algorithm>
#include <fstream>
#include <string_view>

#include "tristim/core/error.h"
#include "tristim/core/file.h"
#include "tristim/core/text.h"
#include "tristim/dither/matrix_text.h"
#include "tristim/image/io/read.h"

namespace tristim {
namespace {

constexpr int kMostSide = 4096;

ThresholdMatrix read_picture_matrix(const std::string& path) {
  const auto source = open_picture(path);
  const PictureInfo& info = source->info();
  if (info.width > kMostSide || info.height > kMostSide) {
    throw Error(
        ErrorKind::kContent, path,
        "is " + std::to_string(info.width) + " x " + std::to_string(info.height) + " pixels",
        "use " + std::to_string(kMostSide) + " a side at most for a matrix");
  }
  Image picture(info.width, info.height, info.channels);
  source->read(picture.view());
  return matrix_from_picture(picture.view(), path);
}

}  // namespace

bool begins_as_picture(const std::string& path) {
  if (path == "-") return false;
  std::ifstream file(path, std::ios::binary);
  std::string head(256, '\0');
  file.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(file.gcount()));
  const bool netpbm = head.size() > 1 && head[0] == 'P' && head[1] >= '1' && head[1] <= '7';
  const bool binary = std::ranges::any_of(without_utf8_mark(head), [](char c) {
    return (static_cast<unsigned char>(c) < ' ' && c != '\n' && c != '\r' && c != '\t');
  });
  return netpbm || binary;
}

ThresholdMatrix read_matrix(const std::string& path) {
  return begins_as_picture(path) ? read_picture_matrix(path)
                                 : parse_matrix(read_text_file(path), path);
}

}  // namespace tristim
