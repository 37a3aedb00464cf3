#pragma once

#include <algorithm>
#include <string>

#include "tristim/core/error.h"
#include "tristim/image/io/read.h"

namespace tristim {

/// All of a picture, read in bands of `band` rows (0: at once).
struct WholePicture {
  PictureInfo info;
  Image image;

  float at(int x, int y, int channel) const { return image.view().pixel(x, y)[channel]; }
};

inline WholePicture read_whole(const std::string& path, const ReadOptions& options = {},
                               int band = 0) {
  const auto rows = open_picture(path, options);
  WholePicture picture{rows->info(), {}};
  const PictureInfo& info = picture.info;
  picture.image = Image(info.width, info.height, info.channels);
  const int step = band > 0 ? band : info.height;
  for (int y = 0; y < info.height; y += step) {
    rows->read(picture.image.view().rows(y, std::min(step, info.height - y)));
  }
  return picture;
}

/// The text of the Error that reading a file throws, after its kind: "3 <thing>: ..."; "" where
/// there is none.
inline std::string reading_error(const std::string& path, const ReadOptions& options = {}) {
  try {
    read_whole(path, options);
  } catch (const Error& error) {
    return std::to_string(static_cast<int>(error.kind())) + " " + error.what();
  }
  return {};
}

}  // namespace tristim
