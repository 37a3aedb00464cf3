#pragma once

#include <string>

#include "tristim/color/primaries.h"
#include "tristim/image/view.h"

namespace tristim {

/// What a picture is before any of its pixels is read.
struct PictureInfo {
  int width = 0;      // pixels of the display window, at least 1
  int height = 0;     // rows of the display window, at least 1
  int channels = 3;   // of the rows delivered: 3 (R G B) or 4 (R G B A, premultiplied)
  bool grey = false;  // R, G and B are copies of one channel
  Primaries primaries =
      {};                   // of the light delivered; the white is the one that RGB (1, 1, 1) means
  double pixel_aspect = 1;  // width of a pixel over its height
  int orientation = 1;      // EXIF 1..8: how to turn the rows for display
  int chunk_rows = 1;  // rows that the file holds together; reading a multiple of it is cheapest
  std::string name;    // for messages
};

/// Rows of linear light, top to bottom, from a file, a renderer or another source.
///
/// Values are as stored: negative, above 1, infinite or NaN where the picture has them.
class RowSource {
 public:
  virtual ~RowSource() = default;

  virtual const PictureInfo& info() const noexcept = 0;

  /// The next `rows.height` rows; `rows` has the width and channels of info(). The rows are the
  /// same however many are asked for at a time. Asking for more rows than are left is the caller's
  /// mistake. Throws Error (kContent) where the file is damaged.
  virtual void read(ImageView<float> rows) = 0;
};

/// Takes rows of linear light, top to bottom.
class RowSink {
 public:
  virtual ~RowSink() = default;

  /// The next rows. Throws Error (kSystem) where they cannot be written.
  virtual void write(ImageView<const float> rows) = 0;

  /// After the last row: makes the result appear under its name. Without it nothing is left behind.
  virtual void finish() = 0;
};

}  // namespace tristim
