#pragma once

#include <memory>
#include <string>
#include <vector>

#include "tristim/image/picture.h"

namespace tristim {

/// What to read of a file, and how.
struct ReadOptions {
  /// "": R G B (A), else X Y Z, else Y; "diffuse": diffuse.R ..., or the part of that name; or one
  /// channel's name, which is grey.
  std::string layer = {};
  /// Threads that decode at once; 0: one for each processor. The rows are the same for any number.
  int threads = 0;
  /// Integer samples as they are stored, the highest code being 1, whatever curve the file names.
  bool codes = false;
};

/// Opens a picture for reading in strips: EXR, PNG, the PNM family with PFM, NumPy arrays of
/// light, and through
/// OpenImageIO (loaded at the first file that needs it) HDR, TIFF, JPEG, BMP and the like. What a
/// file is, its first bytes say, not its name. "-" is standard input.
///
/// The rows are linear light in the file's own primaries: EXR `chromaticities` (the white is
/// `adoptedNeutral` where there is one; files without them have sRGB primaries, and XYZ-encoded
/// files D65), PNG gAMA, cHRM and sRGB; integer samples are decoded by their transfer function,
/// sRGB unless the file says otherwise. The data window lies inside the display window: black and
/// transparent around it.
///
/// Throws Error: kSystem where the file is missing, a directory or unreadable; kContent where it is
/// empty, no picture, damaged, deep, too large, or has no colour channels (the text lists what it
/// has).
std::unique_ptr<RowSource> open_picture(const std::string& path, const ReadOptions& options = {});

/// What `tristim info` prints of a file.
struct PictureFacts {
  PictureInfo info;
  std::string format;                 // "openexr", "png", ...
  std::vector<std::string> channels;  // all that the file has, "name:type"
  std::string compression;            // may be empty
  std::string colour;                 // where the primaries and the curve come from, in words
  int data_x = 0, data_y = 0, data_width = 0,
      data_height = 0;  // the data window relative to the display window
};

/// The facts of a file. Throws as open_picture does, except that a file without colour channels has
/// facts.
PictureFacts picture_facts(const std::string& path, const ReadOptions& options = {});

}  // namespace tristim
